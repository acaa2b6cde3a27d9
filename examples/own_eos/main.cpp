// SPDX-License-Identifier: MIT
// A user's equation of state, complete, in a flyer impact: water as a stiffened gas, 1 km/s, against the exact shock pressure.
#include "bolide/failure/none.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"
#include <cstdio>
using namespace bolide;
using z = vec<double, 1>;

struct stiffened_gas {
  double g = 4.4, p_inf = 6e8, rho0 = 1000; // ratio of specific heats; Pa; kg/m3, where p = 0 at e = 0
  template <class V> eos_point<V> evaluate(V rho, V e) const { // V: double, float or a SIMD lane of them; scalar_t<V>: its number type
    const V p = scalar_t<V>(g - 1) * rho * e + scalar_t<V>(g * p_inf) * (rho * scalar_t<V>(1 / rho0) - scalar_t<V>(1));
    return {p, scalar_t<V>(g) * (p + scalar_t<V>(p_inf)) / rho}; // pressure, sound speed squared
  }
  double reference_density() const { return rho0; }
};
static_assert(EquationOfState<stiffened_gas>); // the contract, checked where it is written

int main() {
  const stiffened_gas eos{};
  const double mm = 1e-3, up = 500; // m; m/s: behind the shocks both bodies move at half the flyer's speed
  const material water{eos, strength::none{}, failure::none{}};
  const body flyer{"flyer", box{z(-10 * mm), z(0)}, water, 0.025 * mm, {eos.rho0, 0}, z(2 * up)};
  const body plate{"plate", box{z(0), z(10 * mm)}, water, 0.025 * mm, {eos.rho0, 0}};
  solver s{space::planar_1d{}, grid::sparse{5e-5}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, flyer, plate};
  s.run(2e-6);
  double p = 0, n = 0; // mean 0.5 to 1.5 mm off the interface: behind the shock, 10 cells away from the contact
  s.for_each_body([&](const auto& set) {
    for (std::size_t i = 0; i < set.columns.size(); ++i)
      if (const double d = set.columns.template get<field::position>()[i] - up * s.time(); std::abs(std::abs(d) - mm) < 0.5 * mm)
        p += set.columns.template get<field::pressure>()[i], ++n;
  });
  const double a = (eos.g + 1) / 4 * up, us = a + std::sqrt(a * a + eos.g * eos.p_inf / eos.rho0), exact = eos.rho0 * us * up;
  std::printf("shock pressure %.4f GPa, exact %.4f GPa; %.2f s\n", p / n / 1e9, exact / 1e9, s.solver_seconds());
  return std::abs(p / n / exact - 1) < 0.002 ? 0 : 1;
}
