// SPDX-License-Identifier: MIT
// Cost of a step, in ns per particle, for the compositions of examples/tradeoff: {linear FLIP, B-spline FLIP, B-spline APIC} x {USF, MUSL} x
// {double, float}, and GIMP, USL, XPIC(2) and cubic B-splines in double, one thread; the rows "fluid" have a material that costs next to nothing. See
// docs/performance.md for how to run it and what it gave.
//
// Scene: an aluminium block of 100 x 200 particles in r-z, 2 x 2 per cell, that flies at 2 km/s and is compressed at 2e5 /s along both
// axes: every particle has viscosity, plastic flow and a strain rate, and changes cell and block. Every 200 steps the scene starts anew,
// untimed, so that the mean is over the same states whatever the number of iterations.
#include "run_benchmarks.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/strength/johnson_cook.hpp"
#include "bolide/strength/none.hpp"
#include "bolide/transfer/xpic.hpp"
#include "bolide/viscosity/none.hpp"

#include <memory>

namespace {
using namespace bolide;
using point = vec<double, 2>;

/// What the aluminium impact is made of by default.
struct aluminium {
  static auto make() {
    return material{eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}}, strength::johnson_cook{}, failure::tension_or_melt{}};
  }
};
/// The cheapest material: what is left of the cost is that of the sweeps. The inner pressure gives it aluminium's sound speed.
struct fluid {
  static auto make() {
    const eos::stiffened_gas model({.gamma = 4.4, .p_inf = 17e9, .rho0 = 2700});
    return material{model, strength::none{}, failure::none{}, viscosity::none{}};
  }
};

template <class Material, class T, class Shape, class Transfer, class Scheme> auto scene() {
  static const auto m = Material::make();
  static const auto start = eos::ambient_state(m.eos);
  const double dx = 5e-5, rate = 2e5;
  const body block{"block", box{point{0, 0}, point{100 * dx, 200 * dx}}, m, dx, {start.density, start.energy}, point{0, 2000}};
  controls<T> c;
  c.threads = 1;
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, Shape{}, Transfer{}, Scheme{}, c, block};
  sim.for_each_body([&](auto& set) {
    auto& p = set.columns;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (int d = 0; d < 2; ++d) p.template get<field::velocity>(d)[i] -= static_cast<T>(rate) * p.template get<field::position>(d)[i];
  });
  sim.run(0);
  return sim;
}

template <class T, class Shape, class Transfer, class Scheme, class Material = aluminium> void step(benchmark::State& state) {
  const auto fresh = [] { return scene<Material, T, Shape, Transfer, Scheme>(); };
  auto sim = std::make_unique<decltype(fresh())>(fresh());
  double particles = 0;
  for (auto _ : state) {
    if (sim->steps() == 200) {
      state.PauseTiming();
      *sim = fresh();
      state.ResumeTiming();
    }
    sim->step();
    particles += static_cast<double>(sim->particle_count());
  }
  state.counters["per_particle"] = benchmark::Counter(particles, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

using linear = shape::linear;
using bspline = shape::quadratic_bspline;
using transfer::apic;
using transfer::flip;
using scheme::musl;
using scheme::usf;
using scheme::usl;
BENCHMARK(step<double, linear, flip, usf>);
BENCHMARK(step<double, linear, flip, musl>);
BENCHMARK(step<double, bspline, flip, usf>);
BENCHMARK(step<double, bspline, flip, musl>);
BENCHMARK(step<double, bspline, apic, usf>);
BENCHMARK(step<double, bspline, apic, musl>);
BENCHMARK(step<double, shape::gimp, flip, usf>);
BENCHMARK(step<double, bspline, flip, usl>);
BENCHMARK(step<double, bspline, transfer::xpic<2>, usf>);
BENCHMARK(step<double, shape::cubic_bspline, apic, usf>);
BENCHMARK(step<float, linear, flip, usf>);
BENCHMARK(step<float, linear, flip, musl>);
BENCHMARK(step<float, bspline, flip, usf>);
BENCHMARK(step<float, bspline, flip, musl>);
BENCHMARK(step<float, bspline, apic, usf>);
BENCHMARK(step<float, bspline, apic, musl>);
BENCHMARK(step<double, linear, flip, usf, fluid>);
BENCHMARK(step<double, bspline, flip, usf, fluid>);
BENCHMARK(step<double, bspline, apic, usf, fluid>);
BENCHMARK(step<float, bspline, apic, usf, fluid>);

} // namespace

int main(int argc, char** argv) { return run_benchmarks(argc, argv); }
