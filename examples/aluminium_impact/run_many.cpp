// SPDX-License-Identifier: MIT
// --compare and --ensemble: whole runs one after another, each with all its files in a folder of its own, then one table.
#include "interrupt.hpp"
#include "outcome.hpp"

#include "bolide/core/quantity.hpp"
#include "bolide/observe/csv.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace impact {
namespace {

namespace fs = std::filesystem;
using group = std::vector<outcome>; // the members of one equation of state

double mean_of(const std::vector<statistic>& all, const std::string& name, double* deviation = nullptr) {
  for (const auto& s : all)
    if (s.name == name) {
      if (deviation) *deviation = s.deviation;
      return s.mean;
    }
  return std::nan("");
}

std::string cell(const std::vector<statistic>& all, const std::string& name, int digits, double unit = 1) {
  double deviation = std::nan("");
  const double mean = mean_of(all, name, &deviation);
  char text[64];
  if (std::isnan(deviation)) std::snprintf(text, sizeof text, "%.*f", digits, mean * unit);
  else std::snprintf(text, sizeof text, "%.*f +- %.*f", digits, mean * unit, digits, deviation * unit);
  return text;
}

void print_groups(const std::vector<group>& groups) {
  const settings& s = groups.front().front().used;
  const bool papers = is_the_papers_case(s);
  using bolide::quantity::dimension;
  std::printf("%s, t = %s; %s %s %s %s, spacing %s, cell %s, tension %s", title(s).c_str(), readable(s.until, dimension::time).c_str(),
              s.shape.c_str(), s.transfer.c_str(), s.scheme.c_str(), s.precision.c_str(), readable(s.spacing, dimension::length).c_str(),
              readable(s.cell, dimension::length).c_str(), s.tension ? readable(*s.tension, dimension::pressure).c_str() : "none");
  const std::size_t members = groups.front().size();
  if (members > 1) std::printf("; %zu members of jitter %g: mean +- standard deviation", members, s.jitter);
  std::printf("\n\n");
  const struct {
    const char *name, *heading;
    int digits;
    double unit;
  } columns[] = {{"length_plate_to_front_mm", "length", 2, 1},
                 {"length_impact_face_to_front_mm", "from face", 2, 1},
                 {"width_mm", "width", 2, 1},
                 {"width_p99_mm", "width 99%", 2, 1},
                 {"hole_diameter_mm", "hole", 2, 1},
                 {"front_speed_m_s", "front m/s", 0, 1},
                 {"molten_fraction_projectile", "molten", 3, 1},
                 {"median_debris_temperature_K", "T K", 0, 1},
                 {"peak_pressure_p999_GPa", "p99.9 GPa", 1, 1},
                 {"energy_drift_relative", "drift 1e-3", 3, 1e3}};
  const int wide = members > 1 ? 17 : 11;
  std::printf("%-15s", "mm");
  if (papers) std::printf(" %14s", "paper L x W");
  for (const auto& c : columns) std::printf(" %*s", wide, c.heading);
  std::printf("\n");
  if (papers) std::printf("%-15s %6.1f x %5.1f\n", "experiment", experiment.length, experiment.width);
  for (const group& g : groups) {
    const auto all = statistics(g);
    const auto printed = printed_for(g.front().used.eos);
    std::printf("%-15s", g.front().used.eos.c_str());
    if (papers) std::printf(" %6.1f x %5.1f", printed.length, printed.width);
    for (const auto& c : columns) std::printf(" %*s", wide, cell(all, c.name, c.digits, c.unit).c_str());
    std::printf("\n");
  }
  if (papers && groups.size() > 1)
    std::printf("(the paper prints one row for its new equation of state, of which paper, mixed and helm are variants)\n");
  std::printf("length: from the plate's rear face to the front; from face: from the face that is hit; width: 99.9 %% of the mass\n\n");
}

void write_csv(const fs::path& path, const std::vector<group>& groups) {
  std::vector<std::string> header{"eos", "seed"};
  for (const auto& m : groups.front().front().measures()) header.push_back(m.name);
  bolide::observe::csv_table table(path, header);
  for (const group& g : groups)
    for (const outcome& o : g) {
      std::vector<bolide::observe::csv_cell> row{o.used.eos, o.used.seed};
      for (const auto& m : o.measures()) row.emplace_back(m.value);
      table.row(row);
    }
}

} // namespace

int run_many(const settings& s) {
  std::vector<std::string> eos{s.eos};
  if (s.compare) eos.assign(std::begin(all_eos), std::end(all_eos));
  const fs::path out = s.out;
  std::vector<group> groups;
  int worst = 0;
  double solver = 0;
  for (const auto& e : eos) {
    group g;
    for (int k = 0; k < s.ensemble && !interrupted(); ++k) {
      settings member = s;
      member.eos = e;
      member.seed = s.seed + static_cast<std::uint64_t>(k);
      fs::path folder = s.compare ? out / e : out;
      if (s.ensemble > 1) folder /= "seed_" + std::to_string(member.seed);
      g.push_back(run_case(member, folder, k == 0)); // only the first member of each is drawn
      worst = std::max(worst, exit_code_of(g.back()));
      solver += g.back().solver;
      for (const auto& failed : g.back().failed_checks) std::fprintf(stderr, "aluminium_impact: FAILED: %s\n", failed.c_str());
      if (!g.back().message.empty()) std::fprintf(stderr, "aluminium_impact: %s\n", g.back().message.c_str());
      if (k > 0) g.back().last = {};
    }
    if (!g.empty()) groups.push_back(std::move(g));
    if (interrupted()) break;
  }
  if (groups.empty()) return 128 + interrupted(); // before the first run
  const std::string kind = s.compare ? "compare" : "ensemble";
  print_groups(groups);
  write_csv(out / (kind + ".csv"), groups);
  write_statistics(out / (kind + ".json"), groups);
  std::vector<outcome> drawn;
  for (group& g : groups) drawn.push_back(std::move(g.front()));
  if (s.compare && s.pictures == "all") {
    write_comparison_picture(out / "compare.png", drawn);
    std::printf("%s\n", (out / "compare.png").string().c_str());
  }
  for (const outcome& o : drawn)
    for (const auto& p : o.pictures) std::printf("%s\n", p.string().c_str());
  std::printf("%s\n\nsolver %.2f s for all runs\n", (out / (kind + ".json")).string().c_str(), solver);
  std::printf("%s\n", worst == 0 ? "checked: the energy ledger of every run closes" : "FAILED: see standard error");
  return worst;
}

} // namespace impact
