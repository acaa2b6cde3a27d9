// SPDX-License-Identifier: MIT
// Any equation of state of the library as an any_eos.
#pragma once

#include "any_eos.hpp"

#include "bolide/eos/query.hpp"
#include "bolide/eos/tabulated.hpp"

#include <cmath>
#include <utility>

namespace explorer {

/// What the output says of a model beside its numbers.
enum class phases {
  by_region,  // solid, mixed, liquid, hot_liquid, gas
  by_formula, // the model's own names of the formulae that it is pieced together from
  single
};

template <class Eos> class adapted_eos : public any_eos {
public:
  adapted_eos(Eos eos, phases named, std::string remark) : eos_(std::move(eos)), named_(named), remark_(std::move(remark)) {}

  bolide::thermal_point<double> evaluate(double rho, double e) const override { return widened(eos_.evaluate(rho, e), rho, e); }
  described_point describe(double rho, double e) const override {
    const auto r = eos_.evaluate(rho, e);
    const bool finite = std::isfinite(r.pressure) && std::isfinite(r.sound_speed_squared);
    return {widened(r, rho, e), region_of(r, rho, e), finite ? bolide::eos::name(bolide::eos::status_at(eos_, rho, e, r)) : "not_finite"};
  }
  double reference_density() const override { return eos_.reference_density(); }
  bool knows_temperature() const override { return bolide::ThermalEquationOfState<Eos>; }
  bool knows_melting() const override { return named_ == phases::by_region; }
  bolide::eos::validity_box validity() const override { return bolide::eos::validity_of(eos_); }
  std::string remark() const override { return remark_; }

private:
  template <class Point> bolide::thermal_point<double> widened(const Point& r, double rho, double e) const {
    const double none = std::nan("");
    if constexpr (bolide::ThermalEquationOfState<Eos>) return r;
    else return {r.pressure, r.sound_speed_squared, none, none, none, none, none, bolide::eos::pressure_energy(eos_, rho, e), none};
  }
  template <class Point> std::string region_of(const Point& r, double rho, double e) const {
    if (named_ == phases::single) return "single";
    if constexpr (bolide::ThermalEquationOfState<Eos>) return bolide::name(bolide::to_region(r.region));
    else return bolide::eos::region_name(eos_, rho, e);
  }

  Eos eos_;
  phases named_;
  std::string remark_;
};

template <class Eos> eos_pointer adapt(Eos eos, phases named, std::string remark = {}) {
  return std::make_shared<adapted_eos<Eos>>(std::move(eos), named, std::move(remark));
}

/// The model itself, or its table with the error that was measured when it was built.
template <class Eos> eos_pointer adapt_or_tabulate(Eos eos, phases named, bool table) {
  if (!table) return adapt(std::move(eos), named);
  bolide::eos::tabulated fast(std::move(eos));
  const auto error = fast.error();
  return adapt(std::move(fast), named,
               "table: measured error of pressure " + bolide::to_text(error.pressure) + ", of c^2 " + bolide::to_text(error.sound_speed_squared) +
                   ", of temperature " + bolide::to_text(error.temperature) + " (relative, docs/eos.md)");
}

} // namespace explorer
