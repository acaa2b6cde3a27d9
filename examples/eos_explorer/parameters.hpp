// SPDX-License-Identifier: MIT
// The parameters of models by name: `--set name=value` with units.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace explorer {

/// One number of a model: its name, the unit it is kept in ("" for a plain number), and where it is kept.
struct parameter {
  std::string name, unit;
  double* value;
};

/// What the command line sets. Each model takes what bears the name of one of its parameters; what none takes is refused.
class assignments {
public:
  /// "name=value"; throws bolide::bad_parameter for a text that is none.
  void add(const std::string& text);
  /// Gives the parameters their values and remembers their names, values and units for `list`.
  void apply(const std::vector<parameter>& parameters);
  /// Throws bolide::bad_parameter unless all were taken.
  void check(const std::string& model) const;
  bool sets(const std::string& name) const { return given_.count(name) > 0; }
  /// "rho0=2785 kg/m3; c0=5328 m/s; ..." of everything applied.
  const std::string& description() const { return description_; }

private:
  std::map<std::string, std::string> given_;
  std::vector<std::string> known_;
  std::string description_;
};

} // namespace explorer
