// SPDX-License-Identifier: MIT
// The pictures of a run: the cloud by phase, speed and temperature, and the synthetic flash radiograph.
#include "outcome.hpp"

#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/picture.hpp"
#include "bolide/observe/radiograph.hpp"
#include "bolide/png/write_png.hpp"

#include <algorithm>
#include <cmath>

namespace impact {

using namespace bolide;

namespace {
/// The colours of the temperature end where 90 % of the moving mass is colder: the rest is in thin films, far hotter,
/// which would leave one colour for all the rest.
observe::paint temperature_of(const observe::snapshot& s) {
  const auto &temperature = s.at("temperature"), &mass = s.at("mass"), &velocity = s.at("velocity");
  observe::weighted_samples speed, moving;
  for (std::size_t i = 0; i < s.size(); ++i) speed.add(std::hypot(velocity(i, 0), velocity(i, 1)), mass(i));
  const double fast = 0.1 * speed.quantile(0.999);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (std::hypot(velocity(i, 0), velocity(i, 1)) >= fast) moving.add(temperature(i), mass(i));
  const double high = 100 * std::ceil(moving.quantile(0.9) / 100);
  return observe::paint::temperature().between(200, std::isfinite(high) ? std::max(high, 1200.0) : 1200.0);
}

std::string heading(const outcome& o) { return title(o.used) + ", EOS " + o.used.eos; }
} // namespace

void write_pictures(const std::filesystem::path& folder, outcome& o) {
  const auto space = observe::cloud_window(o.last);
  const auto write = [&](const char* file, const observe::image& picture) {
    png::write_png(folder / file, picture);
    o.pictures.push_back(folder / file);
  };
  const auto draw = [&](const observe::paint& how) { return observe::draw_panel({&o.last, how, heading(o)}, space); };
  write("cloud_phase.png", draw(observe::paint::phase()));
  write("cloud_speed.png", draw(observe::paint::speed()));
  write("cloud_temperature.png", draw(temperature_of(o.last)));
  write("radiograph.png", observe::draw_radiograph(o.last, space, heading(o)));
}

void write_comparison_picture(const std::filesystem::path& path, const std::vector<outcome>& runs) {
  observe::window all = observe::cloud_window(runs.front().last);
  std::vector<observe::panel> panels;
  for (const outcome& o : runs) {
    const auto w = observe::cloud_window(o.last);
    all = {std::min(all.left, w.left), std::max(all.right, w.right), std::min(all.bottom, w.bottom), std::max(all.top, w.top)};
    panels.push_back({&o.last, observe::paint::phase(), o.used.eos, {}});
  }
  // the last panel: the outlines of all over the cloud of the second, the default
  const outcome& base = runs.size() > 1 ? runs[1] : runs.front();
  observe::panel outlines{&base.last, observe::paint::body(), "outlines of all over the cloud of " + base.used.eos, {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    observe::impact_scene scene;
    scene.plate_rear_z = runs[k].used.thickness;
    scene.impact_speed = runs[k].used.velocity;
    outlines.curves.push_back(
        {observe::outline(runs[k].last, scene), runs[k].used.eos, observe::line_palette[(k + 1) % observe::line_palette.size()]});
  }
  panels.push_back(outlines);
  observe::picture_style style;
  style.width = 760;
  png::write_png(path, observe::draw_panels(panels, all, 2, title(runs.front().used), style));
}

} // namespace impact
