// SPDX-License-Identifier: MIT
// A made-up debris cloud with the looks of the real one, for tests and for trying out pictures: plate with a hole, expanding bubble,
// arcs of spalled projectile, a flat dense nose, ejecta and a few runaways. No physics in it.
#pragma once

#include "bolide/observe/snapshot.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace bolide::observe::test {

inline snapshot synthetic_cloud(double spacing = 0.05e-3, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  const double mm = 1e-3, t = 6.6e-6;
  std::vector<double> x, v, mass, temperature, region, failed, volume, peak, melt;
  snapshot s;
  const auto add = [&](double r, double z, double vr, double vz, double m, double T, int body, int where, bool broken) {
    x.insert(x.end(), {std::fabs(r), z});
    v.insert(v.end(), {vr, vz});
    mass.push_back(m), temperature.push_back(T), region.push_back(where), failed.push_back(broken), s.body.push_back(body);
    volume.push_back(m / 2785);
    peak.push_back(body == 0 ? 90e9 : 60e9 * uniform(random));
    melt.push_back(where >= 2 ? 1 : where == 1 ? 0.5 : 0);
    s.id.push_back(static_cast<std::uint32_t>(s.id.size()));
  };
  const auto ring = [&](double r) { return 2 * 3.14159265358979 * r * spacing * spacing * 2785; };
  for (double r = 10.3 * mm + spacing / 2; r < 50 * mm; r += spacing)
    for (double z = spacing / 2; z < 2.2 * mm; z += spacing)
      add(r, z, 3 * uniform(random), 2, ring(r), 293 + 40 * std::exp(-(r / mm - 10) / 2), 1, 0, false);
  const auto bubble = [](double z) { return 10.5 + 8 * std::sin(1.5707963 * std::min(1.0, z / 23)); };
  for (int i = 0; i < int(4000 * 0.05 * mm / spacing * 0.05 * mm / spacing); ++i) { // outer bubble: plate material
    const double z = 2.2 + 27 * std::pow(uniform(random), 0.8), r = bubble(z) - (z > 23 ? (z - 23) * 0.7 : 0) + 0.12 * normal(random);
    add(r * mm, z * mm, r * mm / t, (z - 2) * mm / t, ring(8 * mm * uniform(random)), 450 + 10 * z, 1, 0, true);
  }
  for (int i = 0; i < int(9000 * 0.05 * mm / spacing * 0.05 * mm / spacing); ++i) { // arcs of spalled projectile and the nose
    const double u = uniform(random);
    if (u < 0.45) {
      const double shell = std::floor(7 * uniform(random)), radius = 10 + shell * 1.6, angle = 1.3 * std::sqrt(uniform(random));
      const double z = 17 + shell * 1.2 + radius * std::cos(angle) - 3, r = radius * std::sin(angle);
      if (r < 15)
        add(r * mm + 0.05 * mm * normal(random), z * mm + 0.08 * mm * normal(random), r * mm / t, z * mm / t,
            ring(4 * mm * std::sqrt(uniform(random))), 600 + 40 * shell, 0, 0, true);
    } else {
      const double r = 15 * std::sqrt(uniform(random)), front = 39.5 - 0.15 * r - 0.035 * r * r, depth = 5 * std::pow(uniform(random), 2);
      const double T = 750 + 500 * uniform(random) - 15 * r, z = front - depth;
      add(r * mm, z * mm, r * mm / t, z * mm / t, ring(4 * mm * std::sqrt(uniform(random))), T,
          uniform(random) < 0.7 ? 0 : 1, T > 1050 ? 2 : T > 900 ? 1 : 0, true);
    }
  }
  for (int i = 0; i < 1500; ++i) { // ejecta veil
    const double z = -22 * std::pow(uniform(random), 1.5), r = 10.6 - 0.28 * z + 0.15 * normal(random);
    add(r * mm, z * mm, r * mm / t * 0.5, z * mm / t, ring(5 * mm * uniform(random)), 500 - 5 * z, 1, 0, true);
  }
  for (int i = 0; i < 40; ++i)
    add(3 * mm * std::fabs(normal(random)), (41 + 2 * uniform(random)) * mm, 200, 6600, ring(0.3 * mm), 1300, 0, 3, true);
  s.time = t, s.step = 2400, s.axisymmetric = true, s.spacing = spacing, s.body_names = {"sphere", "plate"};
  s.add("position", "m", 2, x), s.add("velocity", "m/s", 2, v), s.add("mass", "kg", 1, mass);
  s.add("temperature", "K", 1, temperature), s.add("region", "1", 1, region), s.add("failed", "1", 1, failed);
  s.add("volume", "m3", 1, volume), s.add("peak_pressure", "Pa", 1, peak);
  s.add("melt_fraction", "1", 1, melt);
  return s;
}

} // namespace bolide::observe::test
