// SPDX-License-Identifier: MIT
// An equation of state chosen at run time, and the two handles under which the library's templates see it.
//
// with_model(eos, f) calls f with a handle that is a ThermalEquationOfState where the model knows a temperature, and one that is an
// EquationOfState with dp/de where it knows none: so each analysis is compiled twice, not once for every model.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/eos/validity.hpp"

#include <memory>
#include <string>

namespace explorer {

/// A point with its names.
struct described_point {
  bolide::thermal_point<double> at;
  std::string region; // as the output tables have it
  std::string status; // "ok", or why the answer is not to be trusted
};

class any_eos {
public:
  virtual ~any_eos() = default;
  /// The raw answer; NaN for what the model does not know.
  virtual bolide::thermal_point<double> evaluate(double rho, double e) const = 0;
  virtual double reference_density() const = 0;
  virtual bool knows_temperature() const = 0;
  virtual bool knows_melting() const = 0;
  virtual described_point describe(double rho, double e) const = 0;
  virtual bolide::eos::validity_box validity() const = 0;
  /// What its user should be told: how far a table is from the exact model. Empty for an exact model.
  virtual std::string remark() const = 0;

  std::string region(double rho, double e) const { return describe(rho, e).region; }
  std::string status(double rho, double e) const { return describe(rho, e).status; }
};
using eos_pointer = std::shared_ptr<const any_eos>;

struct caloric_handle {
  const any_eos* eos;
  bolide::caloric_point<double> evaluate(double rho, double e) const {
    const auto r = eos->evaluate(rho, e);
    return {r.pressure, r.sound_speed_squared, r.pressure_energy};
  }
  double reference_density() const { return eos->reference_density(); }
};
struct thermal_handle {
  const any_eos* eos;
  bolide::thermal_point<double> evaluate(double rho, double e) const { return eos->evaluate(rho, e); }
  double reference_density() const { return eos->reference_density(); }
};
static_assert(bolide::EquationOfState<caloric_handle> && bolide::ThermalEquationOfState<thermal_handle>);

template <class F> auto with_model(const any_eos& eos, const F& f) {
  return eos.knows_temperature() ? f(thermal_handle{&eos}) : f(caloric_handle{&eos});
}

} // namespace explorer
