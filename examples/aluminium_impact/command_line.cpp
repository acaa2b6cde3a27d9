// SPDX-License-Identifier: MIT
// The command line (CLI11) and the config file.
#include "advice.hpp"
#include "options.hpp"

#include "bolide/core/contract.hpp"
#include "materials.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>

namespace impact {

request read_command_line(int argc, char** argv) {
  CLI::App app{"A sphere hits a plate at hypervelocity: the debris cloud of Li and Wang's paper, in axial symmetry.\n"
               "Quantities carry units: 9.5mm, 6640m/s, 1.5GPa, 6.6us. Results go to the folder --out; the table to standard output.\n"
               "Exit codes: 0 done, 1 a check failed or a file could not be written, 2 bad input, 3 the run stopped, 130 interrupted.",
               "aluminium_impact"};
  app.set_help_flag("-h,--help", "this text");
  app.set_version_flag("--version", "aluminium_impact (bolide " BOLIDE_VERSION ")");
  std::map<std::string, std::string> given;
  const settings defaults;
  for (const option& o : options())
    app.add_option("--" + o.name, given[o.name], o.help)
        ->type_name(o.value)
        ->default_str(o.write(defaults))
        ->group(o.group)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast); // of a repeated option the last counts
  std::string config;
  bool quick = false, compare = false, list = false;
  app.add_option("--config", config, "read settings from a JSON file (or an earlier summary.json); the command line goes before it")
      ->type_name("FILE")
      ->group("Output");
  app.add_flag("--compare", compare, "all six equations of state and the experiment, side by side")->group("Output");
  app.add_flag("--quick", quick, "coarse: spacing 0.1mm, cell 0.2mm, one frame (what is given goes before)")->group("Output");
  wish w;
  const auto advised = [&](const char* name, std::string& to, const char* value, const char* help) { app.add_option(name, to, help)->type_name(value)->group("Discretisation"); };
  advised("--accuracy", w.accuracy, "SHARE", "the cheapest measured discretisation that reaches this error (1% or 0.01); what is given besides is kept");
  advised("--budget", w.budget, "TIME", "the most accurate measured discretisation within this CPU time (10s)");
  advised("--preset", w.preset, "draft|standard|reference", "the cheapest within 5 %, within 2 %, or the most accurate measured");
  app.add_flag("--list-materials", list, "print the materials and what they have parameters for");

  request r;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    r.exit_code = e.get_exit_code() == 0 ? app.exit(e) : 2;
    if (r.exit_code == 2) std::cerr << "aluminium_impact: " << e.what() << "; --help lists the options\n";
    return r;
  }
  if (list) {
    print_materials(std::cout);
    r.exit_code = 0;
    return r;
  }
  try {
    if (quick) make_quick(r.chosen);
    if (!config.empty()) read_config(r.chosen, config);
    for (const option& o : options())
      if (app.count("--" + o.name) > 0) o.read(r.chosen, given[o.name], "--" + o.name);
    r.chosen.compare = compare;
    if (compare && app.count("--eos") > 0)
      throw bolide::bad_parameter("--eos = '" + r.chosen.eos + "': --compare runs all equations of state; leave one of them away");
    if (quick && w.any()) throw bolide::bad_parameter("--quick: is a discretisation too; leave it or --accuracy, --budget and --preset away");
    if (w.any()) {
      const std::string said = take_advice(r.chosen, w, [&](std::string_view name) { return app.count("--" + std::string(name)) > 0; });
      std::cerr << "aluminium_impact: " << said << "\n";
    }
    if (r.chosen.ensemble > 1 && r.chosen.jitter == 0) r.chosen.jitter = 0.1;
    check(r.chosen);
  } catch (const bolide::bad_parameter& e) {
    std::cerr << "aluminium_impact: " << e.what() << "\n";
    r.exit_code = 2;
  }
  return r;
}

} // namespace impact
