// SPDX-License-Identifier: MIT
// A solver with three parts of one's own in one file: a scheme, a shape function and a strength, composed with parts of the library.
//
// Run:  bash examples/run.sh custom_solver [--quick]
//
// Taylor's copper bar at 190 m/s. Our scheme and shape must give the length that the library's give with the same strength (asserted);
// the strength of Zerilli and Armstrong in place of Johnson and Cook's then shows what a material model changes.
#include "bolide/core/unit.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/data/copper.hpp"
#include "bolide/observe/picture.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"

#include <cstdio>
#include <string_view>

using namespace bolide;
using unit::GPa, unit::MPa, unit::mm, unit::us;
using rz = vec<double, 2>;

/// A scheme: update stress first, and a drag a = -rate v from time `from` on that brings the bar to rest once the plastic flow is over.
struct settling_usf {
  using particle_fields = fields<>;
  static constexpr bool stress_first = true, maps_velocity_back = false, wants_smooth_shape = false;
  static constexpr const char* name = "settling_usf";
  double from, rate; // s, 1/s

  template <class Phases> void step(Phases& s) const {
    s.map_to_nodes();
    s.update_stress_first();
    s.accelerate_nodes();
    s.map_to_particles();
    if (s.time > from) drag(s, std::exp(-rate * static_cast<double>(s.dt)));
    s.work_and_move();
  }
  template <class Phases> void drag(Phases& s, double factor) const {
    s.for_each_set([&](auto& set) {
      for (std::size_t i = 0; i < set.columns.size(); ++i)
        for (int d = 0; d < Phases::dim; ++d) {
          auto& v = set.columns.template get<field::velocity>(d)[i];
          s.energy.transfer -= 0.5 * set.columns.template get<field::mass>()[i] * square(v) * (1 - square(factor)); // booked: the ledger closes
          v *= factor;
        }
    });
  }
};
static_assert(Scheme<settling_usf>);

/// A shape function: three nodes, like the quadratic B-spline, but of fourth degree and with a continuous curvature. d = x - middle node:
///   N = (q - d)/2, 1 - q, (q + d)/2    adds up to 1 and to d for every q (partition of unity, linear completeness);
///   q = 3/16 + 3 d^2/2 - d^4           meets |d| at d = +-1/2 with slope and curvature.
struct quartic {
  static constexpr int support = 3;
  static constexpr double offset = 0.5;
  static constexpr bool smooth = true;
  static constexpr const char* name = "quartic";

  template <class V> static void value(V f, V* n) {
    using T = scalar_t<V>;
    const V d = f - T(1), q = T(0.1875) + d * d * (T(1.5) - d * d);
    n[0] = T(0.5) * (q - d), n[1] = T(1) - q, n[2] = T(0.5) * (q + d);
  }
  template <class V> static void slope(V f, V* n) {
    using T = scalar_t<V>;
    const V d = f - T(1), q = d * (T(3) - T(4) * d * d);
    n[0] = T(0.5) * (q - T(1)), n[1] = -q, n[2] = T(0.5) * (q + T(1));
  }
  template <class V> static void curvature(V f, V* n) {
    using T = scalar_t<V>;
    const V d = f - T(1);
    n[0] = n[2] = T(1.5) - T(6) * d * d, n[1] = T(-2) * n[0];
  }
};
static_assert(ShapeFunction<quartic> && ShapeFunction<quartic, pack<float, 4>>);

/// A strength: Zerilli and Armstrong (1987) for face-centred cubic metals, Y = C0 + C2 sqrt(eps) exp(-C3 T + C4 T ln edot), copper.
struct zerilli_armstrong {
  using particle_fields = fields<field::deviator, field::plastic_strain>;
  static constexpr bool carries_shear = true, wants_temperature = true;
  static constexpr const char* name = "zerilli_armstrong";
  double shear_modulus = 47.7 * GPa, c0 = 65 * MPa, c2 = 890 * MPa, c3 = 2.8e-3, c4 = 1.15e-4; // 1/K

  template <class V> V yield_floor(V, V) const { return V(scalar_t<V>(c0)); }
  template <class V> V yield_stress(V strain, V rate, V temperature, V) const {
    using T = scalar_t<V>;
    return T(c0) + T(c2) * sqrt(strain) * exp(temperature * (T(c4) * log(max(rate, V(T(1)))) - T(c3)));
  }
};
static_assert(Strength<zerilli_armstrong> && Strength<zerilli_armstrong, pack<double, 2>>);

struct outcome { observe::snapshot bar; double length, seconds; };

template <class Shape, class Scheme, class Strength> outcome run(const char* what, double dx, Shape shape, Scheme scheme, Strength strength) {
  const auto& data = data::copper;
  const eos::isentrope_temperature eos{eos::mie_grueneisen{data.mie_grueneisen}, data.heat_capacity, 293, data.melting};
  const body bar{"bar", box{rz{0, 0}, rz{3.81 * mm, 25.4 * mm}}, material{eos, strength, failure::none{}}, dx, {data.density, 0}, rz{0, -190}};
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, shape, transfer::flip{}, scheme, controls<>{}, bar};
  sim.add(grid::mirror{1, 0, true});
  sim.run(80 * us);
  outcome o{observe::take_snapshot(sim), 0, sim.solver_seconds()};
  for (std::size_t i = 0; i < o.bar.size(); ++i) o.length = std::max(o.length, o.bar.at("position")(i, 1) + dx / 2);
  std::printf("%-42s length %.3f mm, kinetic energy left %7.4f J, ledger closes to %.0e, %.2f s\n", what, o.length / mm, sim.energies().now.kinetic,
              std::abs(sim.energies().residual()), o.seconds);
  return o;
}

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double dx = 3.81 * mm / (quick ? 12 : 24);
  const settling_usf settling{60 * us, 1 / us};
  const auto library = run("library: quadratic B-spline, USF, JC", dx, shape::quadratic_bspline{}, scheme::usf{}, data::copper.strength);
  const auto ours = run("our shape and scheme, JC", dx, quartic{}, settling, data::copper.strength);
  auto za = run("our shape and scheme, Zerilli-Armstrong", dx, quartic{}, settling, zerilli_armstrong{});
  auto jc = ours.bar;
  jc.spacing = za.bar.spacing *= 1.3; // to draw: the foot is stretched, and its particles should not show gaps
  const auto how = observe::paint::of("plastic_strain", "equivalent plastic strain", 1).between(0, 2);
  png::write_png("custom_solver.png",
                 observe::draw_panels({{&jc, how, "our solver, Johnson-Cook", {}}, {&za.bar, how, "our solver, Zerilli-Armstrong", {}}},
                                      {0, 18 * mm, -8 * mm, 8 * mm}, 2, "", {.width = 620}));
  const double difference = ours.length / library.length - 1;
  std::printf("same strength: lengths differ by %+.2f %%; measured bar: 16.2 mm; custom_solver.png\n", 100 * difference);
  return std::abs(difference) < 0.01 ? 0 : 1;
}
