// SPDX-License-Identifier: MIT
// The equations of state and cold curves of the library on the command line: CSV in, CSV and pictures out.
//
//   bash examples/run.sh eos_explorer list
//   printf 'x,e\n0.7,5e6\n' | bash examples/run.sh eos_explorer points --eos mixed
//   bash examples/run.sh eos_explorer hugoniot --eos paper --up 1000,2000,3000 --plot hugoniot.png
// Exit codes: 0 done, 1 a file cannot be written, 2 bad input (one sentence on standard error, nothing on standard output).
#include "commands.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/observe/whole_file.hpp"

#include <cstdio>
#include <iostream>

namespace {

void deliver(const explorer::request& r, const explorer::answer& a) {
  if (!r.plot.empty() && a.plot) write_figure(*a.plot, r.plot);
  for (const auto& remark : a.remarks) std::cerr << "eos_explorer: " << remark << "\n";
  if (!r.out.empty() && r.out != "-") return bolide::observe::write_whole_file(r.out, a.csv);
  std::cout << a.csv << std::flush;
  if (!std::cout) throw bolide::observe::output_error("cannot write to standard output");
}

} // namespace

int main(int argc, char** argv) {
  try {
    const explorer::request r = explorer::read_command_line(argc, argv);
    if (r.exit_code >= 0) return r.exit_code;
    if (r.command == "quick") return explorer::quick_tour();
    deliver(r, explorer::run(r));
    return 0;
  } catch (const bolide::bad_parameter& e) {
    std::cerr << "eos_explorer: " << e.what() << "\n";
    return 2;
  } catch (const std::exception& e) { // a file that cannot be written, memory
    std::cerr << "eos_explorer: " << e.what() << "\n";
    return 1;
  }
}
