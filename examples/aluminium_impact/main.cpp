// SPDX-License-Identifier: MIT
// The aluminium impact of Li and Wang's paper, end to end: a sphere hits a plate at 6.64 km/s, and after 6.6 us the debris cloud is
// measured and drawn beside the paper's figures.
//
//   bash examples/run.sh                                    the paper's case, 58,010 particles
//   bash examples/run.sh aluminium_impact --quick           the same, coarse, in seconds
//   bash examples/run.sh aluminium_impact --compare         all six equations of state
// docs/start.md explains every option. The units: options and command_line read the settings, make_simulation turns names into types,
// material_* and composition_* are what is compiled for each, run_case runs one, run_many several.
#include "interrupt.hpp"
#include "options.hpp"
#include "outcome.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/observe/whole_file.hpp"

#include <cstdio>
#include <iostream>

int main(int argc, char** argv) {
  using namespace impact;
  const request r = read_command_line(argc, argv);
  if (r.exit_code >= 0) return r.exit_code;
  catch_interrupts();
  try {
    const settings& s = r.chosen;
    if (s.compare || s.ensemble > 1) return run_many(s);
    const outcome o = run_case(s, s.out);
    if (!o.message.empty()) std::cerr << "aluminium_impact: " << o.message << "\n";
    print_table(o);
    return exit_code_of(o);
  } catch (const bolide::bad_parameter& e) {
    std::cerr << "aluminium_impact: " << e.what() << "\n";
    return 2;
  } catch (const std::exception& e) { // a file that cannot be written, memory
    std::cerr << "aluminium_impact: " << e.what() << "\n";
    return 1;
  }
}
