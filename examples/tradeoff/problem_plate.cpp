// SPDX-License-Identifier: MIT
#include "plate.hpp"

#include "bolide/core/math.hpp"

#include <numbers>

namespace tradeoff {

outcome measure_plates(const settings& s, const plate_figures& f, const chosen_material& material) {
  const double h = shocked_length / s.cells, slab = std::ceil(f.slab / h) * h, radius = 4 * h;
  scene of{{{block({0, -slab}, {radius, slab}), material}}, {bolide::grid::mirror{0, radius, false}}, {}, h};
  of.at_start = [&](const point& x, int) { return start{{0, x[1] < 0 ? f.speed : 0}}; };
  const auto sim = compose(s, of);
  sim->advance(f.end);

  const auto& shock = f.shock;
  const double t = sim->time(), centre = shock.particle_speed * t, half = (shock.shock_speed - shock.particle_speed) * t;
  double sum = 0;
  sim->each([&](const particle& p) {
    const bool shocked = std::abs(p.x[1] - centre) < half;
    const double pressure = shocked ? shock.pressure : 0, density = shocked ? shock.density : f.density;
    const double velocity = shocked ? shock.particle_speed : p.x[1] < centre ? f.speed : 0;
    sum += p.volume * (std::abs(p.pressure - pressure) / shock.pressure + std::abs(p.mass / p.volume - density) / (shock.density - f.density) +
                       std::abs(p.v[1] - velocity) / shock.particle_speed);
  });
  outcome o = sim->costs();
  o.error = sum / (3 * bolide::square(radius) * std::numbers::pi * 2 * half);
  return o;
}

problem plate_problem(std::string name, const plate_figures& f, double sound_speed_behind) {
  return {std::move(name),
          "shock",
          "mean L1 error of p, rho and v over the particles, of the shocked state",
          shocked_length,
          2 * f.slab / shocked_length,
          f.end * (sound_speed_behind + f.speed) / shocked_length,
          f.shock.particle_speed / f.shock.shock_speed,
          true,
          false,
          {25, 50, 100, 200, 400},
          {}};
}

} // namespace tradeoff
