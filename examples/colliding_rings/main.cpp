// SPDX-License-Identifier: MIT
// Two elastic rings collide, bounce and ring: kinetic and elastic energy against time for each transfer, the ladder of their dissipation.
//
// Run:  bash examples/run.sh colliding_rings [--quick]
//
// Plane strain, E 100 MPa, nu 0.2, density 1000 kg/m3, radii 3 and 4 mm, +-30 m/s (a peer's case in mm instead of m: the equations know no length).
// Nothing in the physics dissipates: all that the energy loses is the numerics', and FLIP should lose next to nothing.
#include "bolide/core/unit.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/observe/chart.hpp"
#include "bolide/observe/every.hpp"
#include "bolide/observe/picture.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/viscosity/none.hpp"

#include <cstdio>
#include <string>
#include <string_view>

using namespace bolide;
using unit::MPa, unit::mm, unit::us;
using xy = vec<double, 2>;

/// An equation of state of one's own for small strains, p = K (rho/rho0 - 1): no heat enters, so elastic energy is all that is stored.
struct linear_elastic {
  double rho0, K; // kg/m3, Pa
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(K) * (rho * T(1 / rho0) - T(1)), V(T(K / rho0))};
  }
  double reference_density() const { return rho0; }
};
static_assert(EquationOfState<linear_elastic>);

/// Kinetic energy and what the stresses could give back, p^2/(2K) and s:s/(4G) per volume, J per metre of depth.
template <class Sim> double mechanical_energy(Sim& sim, double K) {
  double sum = sim.energies().now.kinetic;
  sim.for_each_body([&](const auto& set) {
    const auto& c = set.columns;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double p = c.template get<field::pressure>()[i];
      sum += 0.5 * p * p / K * c.template get<field::volume>()[i] + c.template get<field::mass>()[i] * set.material.shear_energy(c, i);
    }
  });
  return sum;
}

struct run { std::string name; std::vector<double> time, energy; double seconds; observe::snapshot contact; };

template <class Transfer> run collide(const char* name, Transfer transfer, double h) {
  const double E = 100 * MPa, nu = 0.2, rho = 1000, K = E / (3 * (1 - 2 * nu));
  const material rubber{linear_elastic{rho, K}, strength::elastic{E / (2 * (1 + nu))}, failure::none{}, viscosity::none{}};
  const body left{"left", shell{xy{-4.2 * mm, 0}, 3 * mm, 4 * mm}, rubber, h / 2, {rho, 0}, xy{30, 0}};
  const body right{"right", shell{xy{4.2 * mm, 0}, 3 * mm, 4 * mm}, rubber, h / 2, {rho, 0}, xy{-30, 0}};
  transfer.heat = 0; // what a transfer loses shall be seen, not kept as heat
  solver sim{space::plane_strain{}, grid::sparse{h}, shape::quadratic_bspline{}, transfer, scheme::usf{}, controls<>{.energy_bound = 1}, left, right};
  run r{name, {}, {}, 0, {}};
  observe::every watch(us, [&](const auto&) {
    r.time.push_back(sim.time() / us), r.energy.push_back(mechanical_energy(sim, K) / sim.energies().initial.total());
  });
  sim.run(60 * us, watch);
  r.contact = observe::take_snapshot(sim);
  sim.run(200 * us, watch);
  r.seconds = sim.solver_seconds();
  return r;
}

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double h = (quick ? 0.4 : 0.2) * mm;

  const run runs[] = {collide("FLIP", transfer::pic{.flip = 1}, h), collide("0.99 FLIP + 0.01 PIC", transfer::pic{.flip = 0.99}, h),
                      collide("APIC", transfer::apic{}, h), collide("XPIC(5)", transfer::xpic<5>{}, h), collide("PIC", transfer::pic{.flip = 0}, h)};
  observe::chart plot{"Two elastic rings, +-30 m/s: kinetic + elastic energy", "t (\u00b5s)", "of the initial energy"};
  for (const run& r : runs) {
    plot.line(r.name, r.time, r.energy);
    std::printf("%-22s energy at the end %.4f of the initial, %.2f s\n", r.name.c_str(), r.energy.back(), r.seconds);
  }
  plot.horizontal_range = {0, 200}, plot.vertical_range = {0, 1.1};
  const auto how = observe::paint::of("speed", "speed (m/s)", 1, observe::color_map::ocean()).between(0, 30);
  const auto rings = [&](const run& r) {
    return observe::draw_panel({&r.contact, how, r.name, {}}, {-7 * mm, 7 * mm, -5.2 * mm, 5.2 * mm}, {.width = 640});
  };
  const auto below = observe::arrange({rings(runs[0]), rings(runs[2])}, 2);
  png::write_png("colliding_rings.png", observe::arrange({observe::draw_chart(plot, {.width = below.width() - 200}), below}, 1));
  return std::abs(runs[0].energy.back() - 1) < (quick ? 0.05 : 0.02) ? 0 : 1; // FLIP keeps its energy
}
