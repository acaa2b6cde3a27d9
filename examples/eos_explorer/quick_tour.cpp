// SPDX-License-Identifier: MIT
// --quick: every command once, with little to do; a few of the numbers are checked against what must hold whatever the model.
#include "cold_curves.hpp"
#include "commands.hpp"
#include "text.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace explorer {
namespace {

using given = std::map<std::string, std::string>;

struct tour {
  int failures = 0;
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("eos_explorer_" + std::to_string(::getpid()));
  ~tour() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }

  /// One command; its table comes back, its picture is drawn and thrown away.
  csv_input ask(const std::string& command, const std::string& eos, const given& options, const std::string& input = "") {
    const auto begin = std::chrono::steady_clock::now();
    request r;
    r.command = command, r.given = options, r.model.eos = eos, r.input = input;
    if (command == "match") r.other.eos = eos;
    if (command == "cold") r.model.cold = eos;
    if (command != "list" && command != "points") r.plot = "yes";
    const answer a = run(r);
    if (a.plot)
      for (const char* ending : {".png", ".svg"}) write_figure(*a.plot, folder / (command + ending));
    const csv_input table = read_csv(a.csv);
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
    std::printf("%-10s %-14s %3zu rows %8.1f ms\n", command.c_str(), eos.c_str(), table.lines.size(), spent.count());
    return table;
  }
  void check(bool holds, const char* what) {
    if (holds) return;
    std::printf("FAILED: %s\n", what);
    ++failures;
  }
};

double number(const csv_input& table, std::size_t line, std::size_t column) { return read_number(table.lines.at(line).cells.at(column), "tour"); }
bool close(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

} // namespace

int quick_tour() {
  tour t;
  for (const auto& entry : all_equations_of_state()) {
    if (entry.name == "jwl") continue; // has no default parameters
    const auto points = t.ask("points", entry.name, {}, "x,e\n1,1e5\n0.8,3e6\n");
    t.check(points.lines[1].cells.back() == "ok", "the state at x = 0.8, e = 3 MJ/kg is inside the validity box");
  }
  for (const auto& entry : all_cold_curves()) {
    if (entry.name.find(':') != std::string::npos) continue; // needs a file
    const auto curve = t.ask("cold", entry.name, {{"x", "0.8,1,1.2"}});
    t.check(number(curve, 0, 2) > 2e10 && std::abs(number(curve, 1, 2)) < 1e8 && number(curve, 2, 2) < 0, "cold pressure falls through 0 at x = 1");
  }
  const auto shock = t.ask("hugoniot", "paper", {{"up", "1000,3320"}});
  const double us = number(shock, 1, 1), rho = number(shock, 1, 2);
  t.check(close(rho * (us - 3320), 2697.8522226174459 * us, 1e-12), "mass is kept across the shock");
  const auto fall = t.ask("isentrope", "tillotson", {{"from", "3500,2e6"}, {"to", "2700"}, {"rows", "5"}});
  t.check(number(fall, 4, 1) < number(fall, 0, 1), "expansion does work");
  const auto release = t.ask("release", "mixed", {{"up", "3320"}, {"initial", "ambient"}, {"rows", "5"}});
  t.check(std::abs(number(release, 4, 2)) < 1, "the release ends at p = 0");
  const auto match = t.ask("match", "mie-gruneisen", {{"velocity", "6640"}});
  t.check(close(number(match, 0, 0), 3320, 1e-9), "a symmetric impact halves the velocity");
  const auto melt = t.ask("melt", "mixed", {{"initial", "ambient"}});
  t.ask("melt", "reference", {{"initial", "ambient"}});
  t.check(number(melt, 0, 4) < number(melt, 1, 4) && number(melt, 2, 4) < number(melt, 3, 4), "melting begins before it is complete");
  const auto tube = t.ask("riemann", "ideal-gas", {{"left", "1,0,1"}, {"right", "0.125,0,0.1"}, {"time", "0.2"}, {"x", "0.1"}});
  t.check(close(number(tube, 0, 3), 0.30313017805, 1e-9), "pressure between the waves of Sod's tube");
  t.ask("list", "mixed", {});
  std::printf(t.failures == 0 ? "all is well\n" : "%d checks failed\n", t.failures);
  return t.failures == 0 ? 0 : 1;
}

} // namespace explorer
