// SPDX-License-Identifier: MIT
// What is asked on the command line, and one function for each command.
#pragma once

#include "figure.hpp"
#include "registry.hpp"

#include "bolide/core/quantity.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace explorer {

struct request {
  int exit_code = -1; // 0 and above: end at once with this
  std::string command;
  model_choice model; // --eos --cold --set --table
  model_choice other{"", "cai-ye", {}, false}; // --eos2 --cold2 --set2
  std::string in, out, plot;
  std::optional<std::string> input;         // CSV at hand, instead of --in or standard input
  std::vector<std::string> compare;         // further names for the plot
  std::map<std::string, std::string> given; // the other options by name, as written
  bool has(const std::string& name) const { return given.count(name) > 0; }
};

struct answer {
  std::string csv;
  std::optional<figure> plot; // made where it is asked for
  std::vector<std::string> remarks; // for standard error
};

answer list_models(const request&);
answer points(const request&);
answer cold(const request&);
answer hugoniot_curve(const request&);
answer isentrope(const request&);
answer release(const request&);
answer match(const request&);
answer melt(const request&);
answer riemann(const request&);

/// The command of the request. Throws bolide::bad_parameter for what is bad in it.
answer run(const request&);
/// Everything once, small, with a summary on standard output; the exit code.
int quick_tour();

/// Reads the command line; what is wrong there is reported with exit code 2.
request read_command_line(int argc, const char* const* argv);

// ---- what several commands read --------------------------------------------------------------------------------------------------

/// The CSV of a request.
std::string input_of(const request&);

/// The numbers (or quantities with units) of the option --NAME, or the numbers in the column NAME of --in or standard input. Each is
/// checked: more than 0 if `positive`.
std::vector<double> numbers_of(const request&, const std::string& name, bolide::quantity::dimension d, bool positive);

/// An answer without remarks but the model's own.
answer answer_of(std::string csv, const any_eos& eos);

/// A model and the state of the material before anything happens.
struct start {
  eos_pointer eos;
  double density, energy, pressure;
};
/// --initial cold|ambient, --temperature, --density (of which the model is scaled), or --from RHO,E as it is.
start start_of(const request&, model_choice choice, const std::string& density_option = "density");

} // namespace explorer
