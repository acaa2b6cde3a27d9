// SPDX-License-Identifier: MIT
// Error against cost as a picture: marks by shape and transfer, a line along the front.
#include "front.hpp"
#include "output.hpp"

#include "bolide/observe/chart.hpp"
#include "bolide/png/write_png.hpp"

#include <cmath>
#include <map>

namespace tradeoff {

void write_picture(const std::filesystem::path& path, const bolide::advise::table& t, const std::string& problem) {
  struct points {
    std::vector<double> x, y;
  };
  const auto add = [](points& to, const bolide::advise::row& r) { to.x.push_back(std::log10(r.cost)), to.y.push_back(std::log10(100 * r.error)); };
  const rows all = rows_of(t, problem);
  std::map<std::string, points> by_method;
  points front;
  for (const auto* r : all) add(by_method[r->how.shape + " " + r->how.transfer], *r);
  for (const auto* r : front_of(all)) add(front, *r);
  bolide::observe::chart plot{problem, "log10 of CPU time (s)", "log10 of error (%)"};
  for (const auto& [name, p] : by_method) plot.marks(name, p.x, p.y);
  plot.line("front", front.x, front.y);
  bolide::png::write_png(path, bolide::observe::draw_chart(plot, {.mark = 4}));
}

} // namespace tradeoff
