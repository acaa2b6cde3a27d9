// SPDX-License-Identifier: MIT
#include "options.hpp"

#include "materials.hpp"

#include "bolide/core/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>

namespace impact {
namespace {

using bolide::bad_parameter;
using bolide::require;
using bolide::to_text;
using bolide::quantity::dimension;
using bolide::quantity::format;
using bolide::quantity::parse;

std::string quoted(std::string_view label, std::string_view text) { return std::string(label) + " = '" + std::string(text) + "': "; }

/// A quantity in (0, most].
option positive(std::string name, std::string value, std::string help, std::string group, dimension d, double settings::*member,
                double most) {
  const auto read = [=](settings& s, std::string_view text, std::string_view label) {
    const double x = parse(text, d, label);
    if (!(x > 0 && x <= most)) throw bad_parameter(quoted(label, text) + "must be more than 0 and at most " + format(most, d));
    s.*member = x;
  };
  return {std::move(name),
          std::move(value),
          std::move(help),
          std::move(group),
          true,
          read,
          [=](const settings& s) { return format(s.*member, d); }};
}

option choice(std::string name, std::string help, std::string group, std::string settings::*member, std::vector<std::string> from) {
  std::string list;
  for (const auto& c : from) list += (list.empty() ? "" : "|") + c;
  const auto read = [=](settings& s, std::string_view text, std::string_view label) {
    if (std::find(from.begin(), from.end(), text) == from.end()) throw bad_parameter(quoted(label, text) + "must be one of " + list);
    s.*member = text;
  };
  return {std::move(name), list, std::move(help), std::move(group), true, read, [=](const settings& s) { return s.*member; }};
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == text.npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

/// A whole number in [least, most].
template <class Integer> Integer whole(std::string_view text, std::string_view label, Integer least, Integer most) {
  Integer n{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size() || n < least || n > most)
    throw bad_parameter(quoted(label, text) + "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                        " (no unit)");
  return n;
}

/// A plain number in (least, most].
double number(std::string_view text, std::string_view label, double least, double most, bool least_allowed) {
  const double x = parse(text, dimension::dimensionless, label);
  if (!(x > least || (least_allowed && x == least)) || !(x <= most))
    throw bad_parameter(quoted(label, text) + "must be " + (least_allowed ? "at least " : "more than ") + to_text(least) + " and at most " +
                        to_text(most) + " (no unit)");
  return x;
}

void read_tension(settings& s, std::string_view text, std::string_view label) {
  if (text == "none") return void(s.tension.reset());
  const double p = parse(text, dimension::pressure, label);
  if (!(p > 0 && p <= 1e12)) throw bad_parameter(quoted(label, text) + "must be more than 0 and at most 1TPa, or none");
  s.tension = p;
}

void read_viscosity(settings& s, std::string_view text, std::string_view label) {
  const auto parts = split(text == "none" ? "0,0" : text);
  if (parts.size() != 2)
    throw bad_parameter(quoted(label, text) + "must be two numbers, quadratic and linear coefficient (for example 1.5,0.06), or none");
  s.viscosity_quadratic = number(parts[0], label, 0, 100, true);
  s.viscosity_linear = number(parts[1], label, 0, 10, true);
}

void read_jitter(settings& s, std::string_view text, std::string_view label) {
  const bool percent = !text.empty() && text.back() == '%';
  const double x = parse(percent ? text.substr(0, text.size() - 1) : text, dimension::dimensionless, label) / (percent ? 100 : 1);
  if (!(x >= 0 && x < 0.5))
    throw bad_parameter(quoted(label, text) + "must be at least 0 and less than 0.5 of the spacing (for example 10% or 0.1)");
  s.jitter = x;
}

void read_box(settings& s, std::string_view text, std::string_view label) {
  if (text == "none") return void(s.box.reset());
  const auto parts = split(text);
  if (parts.size() != 3)
    throw bad_parameter(quoted(label, text) + "must be three lengths r_max,z_min,z_max (for example 60mm,-40mm,80mm), or none");
  const box_limits b{parse(parts[0], dimension::length, label), parse(parts[1], dimension::length, label),
                     parse(parts[2], dimension::length, label)};
  if (!(b.r_max > 0)) throw bad_parameter(quoted(label, text) + "r_max must be more than 0m");
  if (!(b.z_max > b.z_min))
    throw bad_parameter(quoted(label, text) + "z_max must be more than z_min = " + format(b.z_min, dimension::length));
  s.box = b;
}

void read_coarse_beyond(settings& s, std::string_view text, std::string_view label) {
  if (text == "none") return void(s.coarse_beyond.reset());
  const double r = parse(text, dimension::length, label);
  if (!(r > 0 && r <= 10)) throw bad_parameter(quoted(label, text) + "must be more than 0m and at most 10m, or none");
  s.coarse_beyond = r;
}

void read_fields(settings& s, std::string_view text, std::string_view label) {
  static const std::vector<std::string_view> known = {
      "velocity",      "mass",   "volume", "density",       "energy",         "pressure",     "temperature", "melting_temperature",
      "melt_fraction", "region", "failed", "void_fraction", "plastic_strain", "peak_pressure"};
  for (const auto part : split(text)) {
    if (text == "all" || std::find(known.begin(), known.end(), part) != known.end()) continue;
    std::string list;
    for (const auto k : known) list.append(", ").append(k);
    throw bad_parameter(quoted(label, part) + "no such field; choose from" + list.substr(1) + ", or all");
  }
  s.fields = text;
}

void read_checkpoint_interval(settings& s, std::string_view text, std::string_view label) {
  if (text == "none") return void(s.checkpoint_every.reset());
  checkpoint_interval every;
  if (text.find_first_not_of("0123456789") == text.npos) every.steps = whole<long>(text, label, 1, 1'000'000'000'000);
  else {
    every.time = parse(text, dimension::time, label);
    if (!(every.time > 0 && every.time <= 1))
      throw bad_parameter(quoted(label, text) + "must be a time, more than 0 and at most 1s, or a whole number of steps, or none");
  }
  s.checkpoint_every = every;
}

void read_frames(settings& s, std::string_view text, std::string_view label) {
  if (text == "auto") return void(s.frames.reset());
  s.frames = whole<int>(text, label, 0, 10000);
}

std::vector<option> make_options() {
  const std::string scene = "Scene", physics = "Physics", numerics = "Discretisation", output = "Output";
  using str = std::string_view;
  std::vector<option> o;
  o.push_back({"projectile", "NAME", "material of the sphere (--list-materials)", scene, true,
               [](settings& s, str text, str) { s.projectile = text; }, [](const settings& s) { return s.projectile; }});
  o.push_back({"target", "NAME", "material of the plate", scene, true, [](settings& s, str text, str) { s.target = text; },
               [](const settings& s) { return s.target; }});
  o.push_back(positive("diameter", "LENGTH", "diameter of the sphere", scene, dimension::length, &settings::diameter, 1));
  o.push_back(positive("velocity", "VELOCITY", "impact velocity", scene, dimension::velocity, &settings::velocity, 1e5));
  o.push_back(positive("thickness", "LENGTH", "thickness of the plate", scene, dimension::length, &settings::thickness, 1));
  o.push_back(positive("plate-radius", "LENGTH", "radius of the plate", scene, dimension::length, &settings::plate_radius, 10));
  o.push_back(positive("until", "TIME", "end of the run, from first contact", scene, dimension::time, &settings::until, 1));
  o.push_back(choice("eos", "equation of state", physics, &settings::eos, {std::begin(all_eos), std::end(all_eos)}));
  o.push_back(choice("initial", "state at the start: p = 0 at 293 K, or 0 K", physics, &settings::initial, {"ambient", "cold"}));
  o.push_back({"tension", "PRESSURE|none", "tension at which a point fails; none: only melting fails", physics, true, read_tension,
               [](const settings& s) { return s.tension ? format(*s.tension, dimension::pressure) : std::string("none"); }});
  o.push_back({"viscosity", "Q,L|none", "artificial bulk viscosity: quadratic and linear coefficient", physics, true, read_viscosity,
               [](const settings& s) {
                 const bool none = s.viscosity_quadratic == 0 && s.viscosity_linear == 0;
                 return none ? std::string("none") : to_text(s.viscosity_quadratic) + "," + to_text(s.viscosity_linear);
               }});
  o.push_back(positive("spacing", "LENGTH", "distance of the particles", numerics, dimension::length, &settings::spacing, 1));
  o.push_back(positive("cell", "LENGTH", "cell of the grid", numerics, dimension::length, &settings::cell, 1));
  o.push_back({"coarse-beyond", "RADIUS|none", "particles of 0.75 cells in the plate outside this radius", numerics, true, read_coarse_beyond,
               [](const settings& s) { return s.coarse_beyond ? format(*s.coarse_beyond, dimension::length) : std::string("none"); }});
  o.push_back({"cfl", "NUMBER", "Courant number, of h/(c + |v|)", numerics, true,
               [](settings& s, str text, str label) { s.cfl = number(text, label, 0, 1.5, false); },
               [](const settings& s) { return to_text(s.cfl); }});
  o.push_back(choice("shape", "shape functions", numerics, &settings::shape, {"bspline", "linear"}));
  o.push_back(choice("transfer", "particles to grid and back (apic needs bspline)", numerics, &settings::transfer, {"apic", "flip"}));
  o.push_back(choice("scheme", "when the stress is updated", numerics, &settings::scheme, {"usf", "musl"}));
  o.push_back(choice("precision", "of particles and nodes", numerics, &settings::precision, {"double", "float"}));
  o.push_back({"jitter", "FRACTION", "random shift of the particles, of the spacing (10% or 0.1)", numerics, true, read_jitter,
               [](const settings& s) { return to_text(s.jitter); }});
  o.push_back(
      {"seed", "N", "of the jitter", numerics, true,
       [](settings& s, str text, str label) { s.seed = whole<std::uint64_t>(text, label, 0, std::numeric_limits<std::uint64_t>::max()); },
       [](const settings& s) { return std::to_string(s.seed); }});
  o.push_back(
      {"box", "R,Z1,Z2|none", "material outside r < R, Z1 < z < Z2 leaves (counted)", numerics, true, read_box, [](const settings& s) {
         if (!s.box) return std::string("none");
         return format(s.box->r_max, dimension::length) + "," + format(s.box->z_min, dimension::length) + "," +
                format(s.box->z_max, dimension::length);
       }});
  o.push_back({"threads", "N", "threads; 0: all there are", numerics, true,
               [](settings& s, str text, str label) { s.threads = whole<int>(text, label, 0, 1024); },
               [](const settings& s) { return std::to_string(s.threads); }});
  o.push_back({"step-cap", "N", "a run that needs more steps is stopped", numerics, true,
               [](settings& s, str text, str label) { s.step_cap = whole<long>(text, label, 1, 1'000'000'000'000); },
               [](const settings& s) { return std::to_string(s.step_cap); }});
  o.push_back({"frames", "N|auto", "ParaView frames after the first; auto: every 0.6us; 0: no ParaView files", output, true, read_frames,
               [](const settings& s) { return s.frames ? std::to_string(*s.frames) : std::string("auto"); }});
  o.push_back(
      {"fields", "LIST|all", "fields in the ParaView files", output, true, read_fields, [](const settings& s) { return s.fields; }});
  o.push_back(choice("pictures", "draw the cloud and the radiograph", output, &settings::pictures, {"all", "none"}));
  o.push_back({"out", "DIR", "folder of the results", output, false,
               [](settings& s, str text, str label) {
                 if (text.empty()) throw bad_parameter(quoted(label, text) + "must name a folder");
                 s.out = text;
               },
               [](const settings& s) { return s.out; }});
  o.push_back({"checkpoint-every", "TIME|STEPS|none",
               "keep the state of the run in DIR/checkpoint.h5: every so much simulated time, or so many steps", output, false,
               read_checkpoint_interval, [](const settings& s) {
                 if (!s.checkpoint_every) return std::string("none");
                 return s.checkpoint_every->steps > 0 ? std::to_string(s.checkpoint_every->steps)
                                                      : format(s.checkpoint_every->time, dimension::time);
               }});
  o.push_back({"restart", "FILE", "go on from a checkpoint, with the settings of its run: the same bits as if it had not stopped", output,
               false, [](settings& s, str text, str) { s.restart = text; }, [](const settings& s) { return s.restart; }});
  o.push_back({"ensemble", "N",
               "the run N times with seeds seed, seed + 1, ...: mean and scatter of every measure (jitter 10% unless given)", output, false,
               [](settings& s, str text, str label) { s.ensemble = whole<int>(text, label, 1, 1000); },
               [](const settings& s) { return std::to_string(s.ensemble); }});
  return o;
}

} // namespace

const std::vector<option>& options() {
  static const std::vector<option> table = make_options();
  return table;
}

const option& find_option(std::string_view name) {
  std::string list;
  for (const auto& o : options()) {
    if (o.name == name) return o;
    list += (list.empty() ? "" : ", ") + o.name;
  }
  throw bad_parameter("'" + std::string(name) + "': no such setting; there are " + list);
}

std::vector<std::pair<std::string, std::string>> echo(const settings& s) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& o : options())
    if (o.echoed) all.emplace_back(o.name, o.write(s));
  return all;
}

namespace {
void relate(bool holds, const char* name, double value, const char* relation, double bound) {
  if (!holds)
    throw bad_parameter(std::string("--") + name + " = " + format(value, dimension::length) + ": must be " + relation + " " +
                        format(bound, dimension::length));
}
} // namespace

void check(const settings& s) {
  if (s.transfer == "apic" && s.shape == "linear")
    throw bad_parameter("--transfer = 'apic': unsound with --shape linear (its affine field is amplified at nodes of tiny mass); take "
                        "--shape bspline or --transfer flip");
  if (std::error_code error; std::filesystem::exists(s.out, error) && !std::filesystem::is_directory(s.out, error))
    throw bad_parameter("--out = '" + s.out + "': is there already and no folder");
  if (!has_checkpoints && (s.checkpoint_every || !s.restart.empty()))
    throw bad_parameter(
        std::string(s.restart.empty() ? "--checkpoint-every" : "--restart") +
        ": this program was built without the HDF5 library, which checkpoints need; install it (Debian: libhdf5-dev) and build anew");
  if (!s.restart.empty() && (s.compare || s.ensemble > 1))
    throw bad_parameter("--restart = '" + s.restart + "': goes on with one run; leave --compare and --ensemble away");
  for (const std::string eos : all_eos) {
    if (eos != s.eos && !s.compare) continue;
    check_material(s.projectile, eos, "--projectile");
    check_material(s.target, eos, "--target");
  }
  relate(s.spacing <= s.diameter / 4, "spacing", s.spacing, "at most a quarter of the diameter,", s.diameter / 4);
  relate(s.spacing <= s.thickness / 2, "spacing", s.spacing, "at most half of the plate's thickness,", s.thickness / 2);
  relate(s.plate_radius >= s.diameter / 2, "plate-radius", s.plate_radius, "at least half of the diameter,", s.diameter / 2);
  relate(s.cell >= s.spacing, "cell", s.cell, "at least the spacing,", s.spacing);
  relate(s.cell <= 16 * s.spacing, "cell", s.cell, "at most 16 times the spacing,", 16 * s.spacing);
  if (s.coarse_beyond) {
    relate(*s.coarse_beyond < s.plate_radius, "coarse-beyond", *s.coarse_beyond, "less than the plate's radius,", s.plate_radius);
    relate(*s.coarse_beyond >= s.diameter / 2, "coarse-beyond", *s.coarse_beyond, "at least half of the diameter,", s.diameter / 2);
    relate(s.spacing < coarse_spacing(s), "spacing", s.spacing, "with --coarse-beyond less than that of the rim,", coarse_spacing(s));
  }
  const double particles = (0.3927 * s.diameter * s.diameter + s.plate_radius * s.thickness) / (s.spacing * s.spacing);
  require(particles <= 1e8, "--spacing: number of particles", std::round(particles), "at most 1e8");
}

} // namespace impact
