// SPDX-License-Identifier: MIT
// The command line (CLI11).
#include "commands.hpp"
#include "text.hpp"

#include "bolide/core/contract.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>

namespace explorer {
namespace {

struct texts {
  std::map<std::string, std::string> values;
  std::vector<std::string> set, set2;
  bool table = false, quick = false;
};

/// Options are added to subcommands by these; each keeps its text under its name.
struct options {
  texts& t;
  void text(CLI::App* on, const std::string& name, const char* value, const std::string& help) const {
    on->add_option("--" + name, t.values[name], help)->type_name(value)->allow_extra_args(false)->multi_option_policy(
        CLI::MultiOptionPolicy::TakeLast);
  }
  void output(CLI::App* on, bool plots) const {
    text(on, "out", "FILE", "write the table here instead of to standard output");
    if (plots) text(on, "plot", "FILE.png|svg", "draw the curve");
  }
  void model(CLI::App* on) const {
    text(on, "eos", "NAME", "equation of state (default mixed; `list` has the names)");
    text(on, "cold", "NAME", "cold curve of paper, mixed and helm (default cai-ye)");
    on->add_option("--set", t.set, "a parameter with its unit, rho0=2785kg/m3; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    on->add_flag("--table", t.table, "answer from the fast table instead of the exact model");
  }
  void initial(CLI::App* on) const {
    text(on, "initial", "cold|ambient", "state ahead: reference density and e = 0, or p = 0 at --temperature (default cold)");
    text(on, "temperature", "KELVIN", "of --initial ambient (default 293)");
    text(on, "density", "RHO", "scale the model so that the state ahead has this density (kg/m3)");
  }
};

void add_commands(CLI::App& app, const options& o) {
  auto* list = app.add_subcommand("list", "names, validity boxes, parameters and their sources");
  o.output(list, false);
  auto* points = app.add_subcommand("points", "the state of every line of a CSV with the columns x,e or rho,e (x = V/V0, J/kg, kg/m3)");
  o.model(points);
  o.text(points, "in", "FILE", "read this instead of standard input");
  o.output(points, false);
  auto* cold = app.add_subcommand("cold", "energy and pressure of the lattice at 0 K");
  o.text(cold, "cold", "NAME", "cold curve (default cai-ye; `list` has the names)");
  cold->add_option("--set", o.t.set, "a parameter with its unit")->type_name("NAME=VALUE")->allow_extra_args(false);
  cold->add_flag("--table", o.t.table, "answer from the fast table instead of the exact model");
  o.text(cold, "x", "X,...", "volume ratios V/V0 (or a CSV with the column x)");
  o.text(cold, "in", "FILE", "read the CSV here instead of from standard input");
  o.text(cold, "compare", "NAME,...", "further cold curves in the plot");
  o.output(cold, true);
  auto* hugoniot = app.add_subcommand("hugoniot", "the states behind shocks of given particle speeds");
  o.model(hugoniot);
  o.initial(hugoniot);
  o.text(hugoniot, "from", "RHO,E", "start from this state instead (kg/m3, J/kg): a secondary Hugoniot");
  o.text(hugoniot, "up", "UP,...", "particle speeds in m/s (or a CSV with the column up)");
  o.text(hugoniot, "in", "FILE", "read the CSV here instead of from standard input");
  o.text(hugoniot, "compare", "NAME,...", "further equations of state in the plot");
  o.output(hugoniot, true);
  auto* isentrope = app.add_subcommand("isentrope", "the isentrope from one density to another");
  o.model(isentrope);
  o.text(isentrope, "from", "RHO,E", "where it starts (kg/m3, J/kg)");
  o.text(isentrope, "to", "RHO2", "where it ends (kg/m3)");
  o.text(isentrope, "rows", "N", "states, evenly in density (default 101)");
  o.output(isentrope, true);
  auto* release = app.add_subcommand("release", "the isentrope from a shocked state down to zero pressure");
  o.model(release);
  o.initial(release);
  o.text(release, "up", "UP", "particle speed of the shock (m/s)");
  o.text(release, "pressure", "P", "where it ends (Pa, default 0)");
  o.text(release, "rows", "N", "states, evenly in density (default 101)");
  o.output(release, true);
  auto* match = app.add_subcommand("match", "a flyer of --eos hits a target of --eos2: speed and pressure of the interface");
  o.model(match);
  o.text(match, "eos2", "NAME", "equation of state of the target");
  o.text(match, "cold2", "NAME", "its cold curve (default cai-ye)");
  match->add_option("--set2", o.t.set2, "a parameter of the target")->type_name("NAME=VALUE")->allow_extra_args(false);
  o.initial(match);
  o.text(match, "density2", "RHO", "the same of the target");
  o.text(match, "velocity", "V", "of the flyer (m/s)");
  o.output(match, true);
  auto* melt = app.add_subcommand("melt", "where melting begins and ends, on the Hugoniot and on release to zero pressure");
  o.model(melt);
  o.initial(melt);
  o.output(melt, true);
  auto* riemann = app.add_subcommand("riemann", "the exact solution of two states that meet at x = 0");
  o.model(riemann);
  o.text(riemann, "eos2", "NAME", "equation of state on the right (default: the same)");
  o.text(riemann, "cold2", "NAME", "its cold curve (default cai-ye)");
  riemann->add_option("--set2", o.t.set2, "a parameter of it")->type_name("NAME=VALUE")->allow_extra_args(false);
  o.text(riemann, "left", "RHO,U,P", "kg/m3, m/s, Pa");
  o.text(riemann, "right", "RHO,U,P", "kg/m3, m/s, Pa");
  o.text(riemann, "time", "T", "s");
  o.text(riemann, "x", "X,...", "places in m (or a CSV with the column x)");
  o.text(riemann, "in", "FILE", "read the CSV here instead of from standard input");
  o.output(riemann, true);
}

std::string taken(std::map<std::string, std::string>& given, const std::string& name, const std::string& otherwise = {}) {
  const auto at = given.find(name);
  if (at == given.end()) return otherwise;
  std::string text = at->second;
  given.erase(at);
  return text;
}

void fill(request& r, const CLI::App& command, texts& t) {
  r.command = command.get_name();
  for (const auto* o : command.get_options())
    if (o->count() > 0 && t.values.count(o->get_name().substr(2)) > 0) r.given[o->get_name().substr(2)] = t.values[o->get_name().substr(2)];
  r.model.eos = taken(r.given, "eos", r.model.eos);
  r.model.cold = taken(r.given, "cold", r.model.cold);
  r.model.table = r.other.table = t.table;
  for (const auto& s : t.set) r.model.set.add(s);
  r.other.eos = taken(r.given, "eos2");
  r.other.cold = taken(r.given, "cold2", r.other.cold);
  for (const auto& s : t.set2) r.other.set.add(s);
  r.in = taken(r.given, "in"), r.out = taken(r.given, "out"), r.plot = taken(r.given, "plot");
  if (!r.plot.empty()) check_figure_name(r.plot);
  if (const std::string names = taken(r.given, "compare"); !names.empty()) r.compare = split_list(names);
}

} // namespace

request read_command_line(int argc, const char* const* argv) {
  CLI::App app{"Equations of state and cold curves: numbers in, CSV and pictures out. SI units, 17 digits, exact models, no floors.\n"
               "Exit codes: 0 done, 1 a file cannot be written, 2 bad input (nothing is written then).\n"
               "  eos_explorer COMMAND --help    explains a command",
               "eos_explorer"};
  app.set_help_flag("-h,--help", "this text");
  app.set_version_flag("--version", "eos_explorer (bolide " BOLIDE_VERSION ")");
  texts t;
  app.add_flag("--quick", t.quick, "a small tour of every command, with a summary");
  add_commands(app, {t});
  app.require_subcommand(0, 1);

  request r;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    r.exit_code = e.get_exit_code() == 0 ? app.exit(e) : 2;
    if (r.exit_code == 2) std::cerr << "eos_explorer: " << e.what() << "; --help lists the options\n";
    return r;
  }
  if (t.quick) r.command = "quick";
  else if (app.get_subcommands().empty()) throw bolide::bad_parameter("a command is missing; --help lists them");
  else fill(r, *app.get_subcommands().front(), t);
  return r;
}

answer run(const request& r) {
  static const std::map<std::string, answer (*)(const request&)> commands = {
      {"list", list_models},   {"points", points}, {"cold", cold}, {"hugoniot", hugoniot_curve}, {"isentrope", isentrope},
      {"release", release},    {"match", match},   {"melt", melt}, {"riemann", riemann}};
  return commands.at(r.command)(r);
}

} // namespace explorer
