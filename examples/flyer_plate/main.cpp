// SPDX-License-Identifier: MIT
// A flyer hits a plate: shock state and release of aluminium at 4 km/s in one dimension, against the exact solution.
//
// Run:  bash examples/run.sh flyer_plate [--quick]
//
// Two shocks run from the contact plane; behind them both bodies move at half the flyer's speed in the Hugoniot state. The one in the flyer
// reaches its free rear at t1 = L/us; from there a centred fan of the release isentrope runs forward. All of it is exact until the
// fan catches up with the shock in the plate. Three particles per cell: with two, neighbours alternate by 1 % behind the shock (the page says more).
#include "bolide/analysis/isentrope.hpp"
#include "bolide/core/unit.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/data/aluminium.hpp"
#include "bolide/observe/chart.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"

#include <cstdio>
#include <string_view>

using namespace bolide;
using unit::GPa, unit::mm;
using z = vec<double, 1>;

struct profile { std::vector<double> z, p; };

/// Pressure against place at time t: undisturbed flyer is gone (t > t1), so from the left: free surface, fan, Hugoniot state, plate at rest.
profile exact_profile(const eos::mie_grueneisen& eos, const analysis::shock_state& shock, double L, double plate, double t) {
  const double t1 = L / shock.shock_speed, z1 = -L + 2 * shock.particle_speed * t1; // when and where the shock meets the rear
  const auto fan = analysis::release(eos, shock, 60).states;                        // particle_speed: up plus what expansion gains
  const auto speed = [&](const auto& s) { return 2 * shock.particle_speed - s.particle_speed; }; // here it is gained backwards
  profile x;
  const auto add = [&](double at, double p) { x.z.push_back(at / mm), x.p.push_back(p / GPa); };
  add(z1 + speed(fan.back()) * (t - t1), 0);
  for (auto s = fan.rbegin(); s != fan.rend(); ++s) add(z1 + (speed(*s) + s->sound_speed) * (t - t1), s->pressure);
  add(shock.shock_speed * t, shock.pressure);
  add(shock.shock_speed * t, 0);
  add(plate, 0);
  return x;
}

int main(int argc, char** argv) {
  using unit::um, unit::us;
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double speed = 4000, L = 2 * mm, thickness = 8 * mm, h = (quick ? 20 : 10) * um;

  // ---- the heart: material, bodies, solver ----
  const eos::mie_grueneisen eos{data::aluminium.mie_grueneisen};
  const material aluminium{eos, strength::none{}, failure::none{}, viscosity::bulk{1.5, 0.5}};
  const initial_state rest{eos.reference_density(), 0};
  const body flyer{"flyer", box{z(-L), z(0)}, aluminium, h / 3, rest, z(speed)};
  const body plate{"plate", box{z(0), z(thickness)}, aluminium, h / 3, rest};
  solver sim{space::planar_1d{}, grid::sparse{h}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, flyer, plate};
  const double t = 0.7 * us;
  sim.run(t);

  const auto shock = analysis::hugoniot(eos, rest.density, rest.energy, 0, speed / 2);
  const profile exact = exact_profile(eos, shock, L, thickness, t);
  profile found;
  double sum = 0, n = 0;
  const double from = exact.z[exact.z.size() - 4] * mm + 15 * h, to = shock.shock_speed * t - 15 * h; // head of the fan, shock front
  sim.for_each_body([&](const auto& set) {
    const auto& c = set.columns;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double at = c.template get<field::position>()[i], p = c.template get<field::pressure>()[i];
      found.z.push_back(at / mm), found.p.push_back(p / GPa);
      if (at > from && at < to) sum += p, ++n;
    }
  });
  observe::chart plot{"Al on Al, 4 km/s, flyer 2 mm, after 0.7 \u00b5s", "z (mm)", "p (GPa)"};
  plot.marks("particles", found.z, found.p).line("exact", exact.z, exact.p);
  png::write_png("flyer_plate.png", observe::draw_chart(plot, {.mark = 1.5}));

  const double error = sum / n / shock.pressure - 1;
  std::printf("plateau %.3f GPa over %.0f particles, Hugoniot %.3f GPa (us %.0f m/s), error %+.2f %%; %zu particles, %.2f s; flyer_plate.png\n",
              sum / n / GPa, n, shock.pressure / GPa, shock.shock_speed, 100 * error, sim.particle_count(), sim.solver_seconds());
  return std::abs(error) < 0.002 ? 0 : 1;
}
