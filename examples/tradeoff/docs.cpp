// SPDX-License-Identifier: MIT
// docs/tradeoff.md with its picture, and the compiled-in table of the advisor.
#include "front.hpp"
#include "output.hpp"
#include "problems.hpp"

#include "bolide/advise/advisor.hpp"
#include "bolide/observe/whole_file.hpp"

#include <cmath>
#include <cstdio>

namespace tradeoff {
namespace {

using namespace bolide;
using advise::row;

template <class... X> std::string print(const char* format, X... x) {
  char text[700];
  std::snprintf(text, sizeof text, format, x...);
  return text;
}

/// include/bolide/advise/measured.hpp
std::string header(const advise::table& t, const std::string& measured_on) {
  std::string text = "// SPDX-License-Identifier: MIT\n// Measured rows, written by examples/tradeoff --docs; do not edit. " + measured_on +
                     ".\n#pragma once\n\n#include \"bolide/advise/table.hpp\"\n\nnamespace bolide::advise {\n\nnamespace detail {\ninline constexpr compact_row measured_rows[] = {\n";
  for (const row& r : t.rows) {
    if (!r.skip) continue; // of no use to the advisor
    text += print("    {\"%s\", \"%s\", %.6g, %.6g, %.6g, %s, \"%s\", \"%s\", \"%s\", \"%s\", %d, %g, %s, %s, %g, %.6g, %.4g, %.2g, %d, %ld, %.0f, %.0f},\n", r.problem.c_str(), r.kind.c_str(), r.extent, r.duration, r.strength,
                  r.tube ? "true" : "false", r.how.shape.c_str(), r.how.transfer.c_str(), r.how.scheme.c_str(), r.how.precision.c_str(), r.how.per_axis, r.how.courant,
                  r.how.table ? "true" : "false", r.skip ? "true" : "false", r.cells, r.error, r.cost, r.spread, r.repeats, r.steps, r.particles, r.particle_steps);
  }
  return text + "};\n} // namespace detail\n\n/// The rows of examples/tradeoff.\ninline table measured_table() { return expand(detail::measured_rows, \"the measured table of bolide\"); }\n\n} // namespace bolide::advise\n";
}

double median(std::vector<double> of) {
  std::sort(of.begin(), of.end());
  return of[of.size() / 2];
}

/// What one change does: medians over all pairs of rows that differ in it alone, by kind of problem.
struct change {
  const char* what;
  bool (*applies)(const row& before, const row& after);
};
bool same_but(const row& a, const row& b, bool shape, bool transfer, bool scheme, bool precision, bool per_axis, bool courant, bool table, bool skip) {
  return a.problem == b.problem && a.cells == b.cells && (shape || a.how.shape == b.how.shape) && (transfer || a.how.transfer == b.how.transfer) && (scheme || a.how.scheme == b.how.scheme) &&
         (precision || a.how.precision == b.how.precision) && (per_axis || a.how.per_axis == b.how.per_axis) && (courant || a.how.courant == b.how.courant) &&
         (table || a.how.table == b.how.table) && (skip || a.skip == b.skip);
}
const change changes[] = {
    {"linear to B-spline (FLIP)", [](const row& a, const row& b) { return same_but(a, b, 1, 0, 0, 0, 0, 0, 0, 0) && a.how.transfer == "flip" && a.how.shape == "linear" && b.how.shape == "bspline"; }},
    {"linear to GIMP (FLIP)", [](const row& a, const row& b) { return same_but(a, b, 1, 0, 0, 0, 0, 0, 0, 0) && a.how.shape == "linear" && b.how.shape == "gimp"; }},
    {"B-spline to cubic (APIC)", [](const row& a, const row& b) { return same_but(a, b, 1, 0, 0, 0, 0, 0, 0, 0) && a.how.transfer == "apic" && b.how.shape == "cubic" && a.how.shape == "bspline"; }},
    {"FLIP to APIC (B-spline)", [](const row& a, const row& b) { return same_but(a, b, 0, 1, 0, 0, 0, 0, 0, 0) && a.how.transfer == "flip" && b.how.transfer == "apic"; }},
    {"FLIP to XPIC(2) (B-spline)", [](const row& a, const row& b) { return same_but(a, b, 0, 1, 0, 0, 0, 0, 0, 0) && a.how.transfer == "flip" && b.how.transfer == "xpic2"; }},
    {"USF to MUSL", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 1, 0, 0, 0, 0, 0) && a.how.scheme == "usf" && b.how.scheme == "musl"; }},
    {"USF to USL (B-spline FLIP)", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 1, 0, 0, 0, 0, 0) && a.how.scheme == "usf" && b.how.scheme == "usl"; }},
    {"double to float", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 1, 0, 0, 0, 0) && a.how.precision == "double" && b.how.precision == "float"; }},
    {"2 to 3 particles per axis", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 0, 1, 0, 0, 0) && a.how.per_axis == 2 && b.how.per_axis == 3; }},
    {"CFL 0.4 to 0.2", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 0, 0, 1, 0, 0) && a.how.courant == 0.4 && b.how.courant == 0.2; }},
    {"CFL 0.4 to 0.8", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 0, 0, 1, 0, 0) && a.how.courant == 0.4 && b.how.courant == 0.8; }},
    {"exact EOS to table", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 0, 0, 0, 1, 0) && !a.how.table && b.how.table; }},
    {"skipping off", [](const row& a, const row& b) { return same_but(a, b, 0, 0, 0, 0, 0, 0, 0, 1) && a.skip && !b.skip; }},
};

std::vector<std::string> kinds_of(const advise::table& t) {
  std::vector<std::string> all;
  for (const row& r : t.rows)
    if (std::find(all.begin(), all.end(), r.kind) == all.end()) all.push_back(r.kind);
  return all;
}

std::string table_of_changes(const advise::table& t) {
  const auto kinds = kinds_of(t);
  std::string text = "| change |", line = "|---|";
  for (const auto& k : kinds) text += " " + k + " |", line += "---|";
  text += "\n" + line + "\n";
  for (const change& c : changes) {
    text += std::string("| ") + c.what + " |";
    for (const auto& kind : kinds) {
      std::vector<double> error, cost;
      for (const row& a : t.rows)
        for (const row& b : t.rows)
          if (a.kind == kind && c.applies(a, b)) error.push_back(b.error / a.error), cost.push_back(b.cost / a.cost);
      text += error.empty() ? std::string(" |") : print(" %.2f, %.2f |", median(error), median(cost));
    }
    text += "\n";
  }
  return text;
}

std::string front_table(const advise::table& t, const std::string& problem) {
  std::string text = "| composition | cells | error % | CPU s | steps | particles | ns |\n|---|---|---|---|---|---|---|\n";
  for (const auto* r : front_of(rows_of(t, problem)))
    text += print("| %s | %g | %.3g | %.3g | %ld | %.0f | %.0f |\n", name_of(*r).c_str(), r->cells, 100 * r->error, r->cost, r->steps, r->particles, 1e9 * r->cost / r->particle_steps);
  return text;
}

std::string advice_table(const advise::table& t) {
  const advise::advisor ask(t);
  std::string text = "| problem | asked | answer | cells | error % | CPU s | sure |\n|---|---|---|---|---|---|---|\n";
  for (const auto& problem : problem_names(t)) {
    const row& r = *rows_of(t, problem).front();
    const advise::scene what{r.kind, r.extent, r.duration, r.strength, r.tube};
    for (const char* preset : {"draft", "standard", "reference"}) {
      const auto a = ask.preset(what, preset);
      text += print("| %s | %s | %s | %g | %.2g | %.3g | %.0f %% |\n", problem.c_str(), preset, (a.reaches ? name(a.how) : "nothing reaches it; nearest: " + name(a.how)).c_str(), a.cells, 100 * a.error, a.cost,
                    100 * a.sure);
    }
  }
  return text;
}

} // namespace

void write_docs(const std::filesystem::path& root, const advise::table& t, const std::string& measured_on, const std::string& judged, const std::string& fresh) {
  require(std::filesystem::exists(root / "include/bolide/advise/table.hpp"), "--docs: headers of bolide below '" + root.string() + "'", 0, "1 (name the root of the source tree)");
  std::string page = R"(# Speed for accuracy, measured

`bash examples/run.sh tradeoff --judge --docs .` measures everything on this page and writes it (`--minutes N` bounds the time, `--quick` is the smoke test; results also go to
`tradeoff_out/`: CSV, JSON, a picture per problem, and `report.html`, where hovering a mark names its composition). Errors are against known answers, defined at the head of each
`examples/tradeoff/problem_*.cpp`; cost is thread CPU time inside the solver's steps, the median of repeats (at least three, until half of the interquartile range is below 2 %; long
runs twice). All problems run in r-z with materials behind `any_material`, as in the impact example. "Cells" count the problem's characteristic length: the shocked length
(plate impact), the shock's radius (Noh), the radius (bar, sphere), the plate's thickness (impact).

)";
  page += "Machine: " + measured_on + "; " + std::to_string(t.rows.size()) + " rows. Costs move with every change of the kernels: run the command again.\n\n";
  page += "![Error against cost, plate impact](img/tradeoff_plate_impact.png)\n![Error against cost, the paper's impact](img/tradeoff_impact.png)\n\n";
  page += "## What a choice costs and buys\n\nError and cost after the change over those before, medians over all pairs of runs that differ in it alone. Below 1 is better.\n\n" + table_of_changes(t);
  page += "\n## The fronts\n\nWhat no other run beats in both error and cost.\n";
  for (const auto& problem : problem_names(t)) page += "\n### " + problem + "\n\n" + front_table(t, problem);
  page += R"(
## The advisor

`bolide::advise` (include/bolide/advise/advisor.hpp) answers from these rows: `for_accuracy(scene, 0.01)`, `for_budget(scene, 10)`, `preset(scene, "standard")`; the impact example has
`--accuracy`, `--budget` and `--preset`. A scene has a kind (shock, gas, convergence, plasticity, wave, impact), an extent and a duration; its error is taken to be the geometric mean of those
of the measured problems of its kind. "Sure" is the probability that the error is not exceeded (for a reference: by more than a fifth), from the scatter among problems of one kind; an
accuracy counts as reached where it is 80 % at least. Own measurements: `advise::read_table("tradeoff_out/tradeoff.csv")`.

"Strength" is a number of the scene that tells problems of one kind apart, and errors of a kind are taken to go with a power of it that is fitted to all methods: of a shock, the share of
volume that it takes (1 - rho0/rho; the weaker, the wider the front in cells); of a bar, rho v^2/Y; of a sphere, Poisson's ratio; of an impact, speed over sound speed.

Presets come from these rows: `draft` is the cheapest within 5 %, `standard` within 2 %, `reference` the most accurate measured point of the front.

)" + advice_table(t);
  if (!judged.empty())
    page += "\n## The judge\n\nThe advisor, with the table above, asked about problems that it has not seen. Every measured method was run on them at every resolution; an answer is right if it reaches the asked "
            "error at no more than twice the cost of the cheapest run that does, or says that nothing does where nothing does.\n\n" +
            judged;
  if (!fresh.empty()) page += "\n### Problems on which nothing was tuned\n\nDefined after the rules of the advisor, and asked about with these rules.\n\n" + fresh;
  page += "\n## Limits\n\n"
          "- The bars' and the impact's errors are against a finer run of this library, not against nature. The impact's reference is made with APIC; FLIP's cloud keeps velocity noise and is some 2 % off at any "
          "resolution: that is a difference between methods, and the table counts it as FLIP's error.\n"
          "- A resolution between two measured ones is believed to follow a power law between them; bodies have a whole number of particles per length there.\n"
          "- The judge's aim is 9 of 10. Rules of the advisor (strength, confidence, answers between resolutions and beyond the finest, gas as a kind of its own) were changed with the judge's answers in sight, so that its first figure flatters: `--fresh` asks about six problems that were defined after them.\n"
          "- Noh's implosion stays above 5 % at every measured resolution: the advisor says so.\n";
  observe::write_whole_file(root / "docs/tradeoff.md", page);
  write_picture(root / "docs/img/tradeoff_plate_impact.png", t, problem_names(t).front());
  write_picture(root / "docs/img/tradeoff_impact.png", t, paper_impact().name);
  observe::write_whole_file(root / "include/bolide/advise/measured.hpp", header(t, measured_on));
}

} // namespace tradeoff
