// SPDX-License-Identifier: MIT
// Modifier: gives a temperature and a melting temperature to an equation of state that has none.
//
//   T = T_s(V) + (e - e_s(V))/c_v,  the isentrope through (V0, T0, e = 0):  dT_s/dV = -Gamma T_s/V,  de_s/dV = -p,  Gamma = p_e/rho
//   T_m(V) by eos::lindemann
// Pressure and sound speed are those of the wrapped model, unchanged. e/c_v alone as a temperature would count the energy of cold
// compression as heat (6600 K where 3000 K is right).
// Only theta(V) = T_s - e_s/c_v is needed (T = theta + e/c_v): it is tabulated at set-up against eta = rho/rho0,
// 0.1 <= eta <= 4, and goes on linearly in eta outside (the isentrope itself has no meaning there). T <= 0 is reported as it is.
// cold_energy is -c_v theta(V): the energy at which T = 0 at this volume, with this modifier's constant c_v.
// melt_fraction is 1 for T > T_m and 0 else: a model without a latent heat has no mixed phase; region is liquid or solid.
// The set-up integrates with 4th-order Runge-Kutta, eight steps per table interval; docs/eos.md gives the error.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/lindemann.hpp"
#include "bolide/eos/pressure_energy.hpp"
#include "bolide/eos/query.hpp"
#include "bolide/eos/polynomial_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bolide::eos {

template <class Eos> class isentrope_temperature {
  static_assert(EquationOfState<Eos>, "bolide: eos::isentrope_temperature needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  /// c_v in J/(kg K), T0 in K: the temperature at (rho0, e = 0). Defaults: aluminium.
  explicit isentrope_temperature(Eos eos, double c_v = 875, double T0 = 293, lindemann melting = {})
      : eos_(std::move(eos)), c_v_(c_v), T0_(T0), melting_(melting), theta_(eta_low, 1.0 / per_unit, rows),
        inverse_density_(1 / eos_.reference_density()), inverse_c_v_(1 / c_v) {
    require(c_v > 0, "eos::isentrope_temperature c_v", c_v, "> 0", "J/(kg K)");
    require(T0 > 0, "eos::isentrope_temperature T0", T0, "> 0", "K");
    melting_.validate();
    fill();
  }

  template <class V> BOLIDE_INLINE thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const auto p = eos_.evaluate(rho, e);
    const V eta = rho * T(inverse_density_);
    const auto at = theta_.find(eta);
    const V theta = at.c[0] + at.t * (at.c[1] + at.t * (at.c[2] + at.t * at.c[3]));
    const V temperature = theta + e * T(inverse_c_v_), t_m = melting_.melting_temperature(V(T(1)) / eta);
    const auto molten = temperature > t_m;
    return {p.pressure, p.sound_speed_squared, temperature, t_m, select(molten, V(T(1)), V(T(0))), T(-c_v_) * theta,
            select(molten, V(region_value<V>(region::liquid)), V(region_value<V>(region::solid))), eos::pressure_energy(eos_, rho, e), V(T(inverse_c_v_))};
  }

  double reference_density() const { return eos_.reference_density(); }
  const Eos& base() const { return eos_; }
  double heat_capacity() const { return c_v_; }
  double reference_temperature() const { return T0_; }
  /// The wrapped model's box, within the densities of the isentrope.
  validity_box validity() const {
    validity_box box = validity_of(eos_);
    box.density_low = std::max(box.density_low, eta_low * eos_.reference_density());
    box.density_high = std::min(box.density_high, theta_.left(rows - 1) * eos_.reference_density());
    return box;
  }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const { return continuation_mask(eos_, rho, e); }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e); }
  /// The wrapped model's; the jump of melt_fraction at T_m is not among them (p, c and T have none there).
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho); }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  static constexpr double eta_low = 0.1;
  static constexpr int per_unit = 250, rows = 976; // 975 intervals to eta = 4, and the row of the continuation above
  static constexpr int reference_row = 225;        // eta = 1

  struct slope {
    double T, e; // d/d eta of T_s, e_s
  };
  /// dT_s/d eta = Gamma T_s/eta, de_s/d eta = p V0/eta^2.
  slope at(double eta, double T, double e) const {
    const double rho0 = eos_.reference_density(), rho = eta * rho0;
    return {pressure_energy(eos_, rho, e) / rho * T / eta, eos_.evaluate(rho, e).pressure / (rho0 * eta * eta)};
  }
  /// Follows the isentrope over h in eta.
  void advance(double eta, double h, double& T, double& e) const {
    const slope a = at(eta, T, e), b = at(eta + h / 2, T + h / 2 * a.T, e + h / 2 * a.e);
    const slope c = at(eta + h / 2, T + h / 2 * b.T, e + h / 2 * b.e), d = at(eta + h, T + h * c.T, e + h * c.e);
    T += h / 6 * (a.T + 2 * b.T + 2 * c.T + d.T);
    e += h / 6 * (a.e + 2 * b.e + 2 * c.e + d.e);
  }
  struct node {
    double theta, slope;
  };
  node node_at(double eta, double T, double e) const {
    const slope s = at(eta, T, e);
    return {T - e / c_v_, s.T - s.e / c_v_};
  }
  void set(int row, const node& a, const node& b) {
    const double h = theta_.step(), rise = b.theta - a.theta;
    theta_.set(static_cast<std::size_t>(row),
               {a.theta, h * a.slope, 3 * rise - h * (2 * a.slope + b.slope), h * (a.slope + b.slope) - 2 * rise});
  }
  void fill() {
    const double h = theta_.step();
    const int fine = 8;
    for (const int direction : {1, -1}) {
      double T = T0_, e = 0, eta = 1;
      node here = node_at(eta, T, e);
      for (int row = reference_row; direction > 0 ? row < rows - 1 : row > 1; row += direction) {
        for (int k = 0; k < fine; ++k) advance(eta + direction * h * k / fine, direction * h / fine, T, e);
        eta = theta_.left(static_cast<std::size_t>(row + direction));
        const node next = node_at(eta, T, e);
        if (direction > 0) set(row, here, next);
        else set(row - 1, next, here);
        here = next;
      }
      require(std::isfinite(here.theta) && std::isfinite(here.slope), "eos::isentrope_temperature theta at the end of its table",
              here.theta, "finite (the wrapped model must answer for 0.1 to 4 times its reference density)", "K");
      // The first and the last row are the linear continuations.
      if (direction > 0) theta_.set(static_cast<std::size_t>(rows - 1), {here.theta, h * here.slope, 0, 0});
      else theta_.set(0, {here.theta - h * here.slope, h * here.slope, 0, 0});
    }
  }

  Eos eos_;
  double c_v_, T0_;
  lindemann melting_;
  polynomial_table<4> theta_;
  double inverse_density_, inverse_c_v_; // m3/kg, kg K/J
};

} // namespace bolide::eos
