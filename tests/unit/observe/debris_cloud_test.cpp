// SPDX-License-Identifier: MIT
// Clouds made of few particles whose measures are known exactly.
#include "bolide/observe/debris_cloud.hpp"

#include "synthetic_cloud.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bolide::observe {
namespace {

constexpr double mm = 1e-3;
const impact_scene scene{.plate_front_z = 0, .plate_rear_z = 2 * mm, .impact_speed = 1000};

/// Collects particles and makes a snapshot of them.
struct maker {
  std::vector<double> x, v, m, temperature, region, melt, peak;
  std::vector<int> body;
  void add(int b, double r, double z, double vr, double vz, double mass, double T = 300, int where = 0, double melted = 0, double p = 0) {
    x.insert(x.end(), {r, z}), v.insert(v.end(), {vr, vz}), m.push_back(mass), body.push_back(b);
    temperature.push_back(T), region.push_back(where), melt.push_back(melted), peak.push_back(p);
  }
  snapshot make(bool all = true) const {
    snapshot s;
    s.axisymmetric = true, s.spacing = 0.05 * mm, s.body = body, s.body_names = {"sphere", "plate"};
    s.add("position", "m", 2, x), s.add("velocity", "m/s", 2, v), s.add("mass", "kg", 1, m);
    if (all) {
      s.add("temperature", "K", 1, temperature), s.add("region", "1", 1, region);
      s.add("melt_fraction", "1", 1, melt), s.add("peak_pressure", "Pa", 1, peak);
    }
    return s;
  }
};

/// 1000 equal projectile particles: z = 2 mm + i * 0.01 mm, r = i * 0.005 mm, v_z = i + 100, v_r = 2 i, i = 1..1000.
maker line_of_debris() {
  maker k;
  for (int i = 1; i <= 1000; ++i)
    k.add(0, i * 0.005 * mm, 2 * mm + i * 0.01 * mm, 2.0 * i, i + 100, 1e-6, 300 + i, i > 900 ? 2 : i > 800 ? 1 : 0,
          i > 900 ? 1 : i > 800 ? 0.5 : 0, i * 1e9);
  return k;
}

TEST(debris_cloud, lengths_and_widths_are_mass_quantiles) {
  const debris_cloud c(line_of_debris().make(), scene);
  EXPECT_NEAR(c.front_z, 2 * mm + 9.99 * mm, 1e-12);
  EXPECT_NEAR(c.length_plate_to_front, 9.99 * mm, 1e-12);
  EXPECT_NEAR(c.width, 2 * 4.995 * mm, 1e-12);
  EXPECT_NEAR(c.width_p99, 2 * 4.95 * mm, 1e-12);
  EXPECT_NEAR(c.length_veil_to_front, 11.99 * mm, 1e-12) << "without ejecta the veil starts at the plate's front face";
  EXPECT_EQ(c.ahead_of_front.count, 1);
  EXPECT_EQ(c.beyond_width.count, 1);
  EXPECT_NEAR(c.ahead_of_front.furthest, 12 * mm, 1e-12);
  EXPECT_NEAR(c.ahead_of_front.mass, 1e-6, 1e-18);
}

TEST(debris_cloud, speeds_are_medians_of_the_outermost_percent) {
  const debris_cloud c(line_of_debris().make(), scene);
  // particles 990..1000 lie at or beyond the 99 % quantile: median 995; the rearmost 1 % are 1..10
  EXPECT_EQ(c.front_speed, 995 + 100);
  EXPECT_EQ(c.expansion_speed, 2 * 995);
  EXPECT_EQ(c.rear_speed, 5 + 100);
}

TEST(debris_cloud, amounts) {
  const debris_cloud c(line_of_debris().make(), scene);
  EXPECT_NEAR(c.mass_downstream, 1e-3, 1e-15);
  EXPECT_NEAR(c.momentum_downstream, 1e-6 * (500500 + 100000), 1e-12);
  EXPECT_NEAR(c.mass_by_region[0], 800e-6, 1e-15);
  EXPECT_NEAR(c.mass_by_region[1], 100e-6, 1e-15);
  EXPECT_NEAR(c.mass_by_region[2], 100e-6, 1e-15);
  EXPECT_NEAR(c.molten_mass, 150e-6, 1e-15);
  EXPECT_NEAR(c.molten_fraction_projectile, 0.15, 1e-12);
  EXPECT_EQ(c.median_temperature, 800);
  double energy = 0;
  for (int i = 1; i <= 1000; ++i) energy += 0.5e-6 * (4.0 * i * i + (i + 100.0) * (i + 100.0));
  EXPECT_NEAR(c.kinetic_energy_downstream, energy, 1e-9 * energy);
}

TEST(debris_cloud, peak_pressures) {
  impact_scene with_reference = scene;
  with_reference.reference_pressure = 400e9;
  const debris_cloud c(line_of_debris().make(), with_reference);
  EXPECT_EQ(c.peak_pressure, 1000e9);
  EXPECT_EQ(c.peak_pressure_p999, 999e9);
  EXPECT_NEAR(c.mass_fraction_over_150_GPa, 0.85, 1e-12);
  EXPECT_NEAR(c.mass_fraction_over_1p5_reference, 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(debris_cloud(line_of_debris().make(), scene).mass_fraction_over_1p5_reference));
}

TEST(debris_cloud, who_is_downstream) {
  maker k = line_of_debris();
  k.add(1, 90 * mm, 50 * mm, 0, 49, 1);   // too slow
  k.add(1, 90 * mm, 1.9 * mm, 0, 900, 1); // still in the plate
  k.add(1, 90 * mm, -5 * mm, 0, 900, 1);  // upstream, flying in
  k.add(1, 90 * mm, -5 * mm, 0, -49, 1);  // upstream, slow: no ejecta
  const debris_cloud c(k.make(), scene);
  EXPECT_NEAR(c.mass_downstream, 1e-3, 1e-15);
  EXPECT_NEAR(c.width, 9.99 * mm, 1e-12);
  EXPECT_EQ(c.mass_ejecta, 0);
}

TEST(debris_cloud, ejecta_and_their_tip) {
  maker k = line_of_debris();
  for (int i = 1; i <= 2000; ++i) k.add(1, 12 * mm, -i * 0.01 * mm, 0, -100, 1e-7);
  k.add(1, 12 * mm, -500 * mm, 0, -6000, 1e-8); // a runaway: an outlier, not the tip
  const debris_cloud c(k.make(), scene);
  EXPECT_NEAR(c.veil_tip_z, -19.99 * mm, 1e-9);
  EXPECT_NEAR(c.length_veil_to_front, 11.99 * mm + 19.99 * mm, 1e-9);
  EXPECT_EQ(c.behind_veil.count, 2);
  EXPECT_NEAR(c.behind_veil.furthest, -500 * mm, 1e-12);
  EXPECT_NEAR(c.mass_ejecta, 2e-4 + 1e-8, 1e-15);
}

TEST(debris_cloud, runaways_move_no_measure) {
  maker k = line_of_debris();
  const debris_cloud before(k.make(), scene);
  k.add(0, 80 * mm, 90 * mm, 5000, 9000, 1e-10, 9000, 4, 1, 5e15);
  const debris_cloud after(k.make(), scene);
  // by one particle of the line at most, since 99.9 % of it lies exactly between two
  EXPECT_NEAR(after.front_z, before.front_z, 0.011 * mm);
  EXPECT_NEAR(after.width, before.width, 0.011 * mm);
  EXPECT_NEAR(after.peak_pressure_p999, before.peak_pressure_p999, 1.1e9);
  EXPECT_EQ(after.peak_pressure, 5e15);
  EXPECT_EQ(after.ahead_of_front.count, 1);
  EXPECT_NEAR(after.ahead_of_front.furthest, 90 * mm, 1e-12);
}

/// Plate of radius 30 mm with a hole, as rings on a lattice.
void add_plate(maker& k, double hole_radius, double spacing = 0.05 * mm) {
  for (double r = hole_radius + spacing / 2; r < 30 * mm; r += spacing)
    for (double z = spacing / 2; z < 2 * mm; z += spacing) k.add(1, r, z, 1, 2, 2 * std::numbers::pi * r * spacing * spacing * 2785);
}

TEST(debris_cloud, hole_is_found_between_bins_and_past_strays) {
  for (const double radius : {5.0, 9.87, 10.0, 10.13}) {
    maker k;
    add_plate(k, radius * mm);
    EXPECT_NEAR(debris_cloud(k.make(false), scene).hole_diameter, 2 * radius * mm, 0.05 * mm) << radius;
    k.add(1, 1 * mm, 1 * mm, 0, 0, 1e-6);      // slow strays within the hole
    k.add(1, 8 * mm, 1 * mm, 0, 0, 1e-6);
    k.add(0, 3 * mm, 1 * mm, 0, 0, 1e-2);      // projectile
    k.add(1, 4.9 * mm, 1 * mm, 0, 500, 1e-2);  // moving
    EXPECT_NEAR(debris_cloud(k.make(false), scene).hole_diameter, 2 * radius * mm, 0.05 * mm) << radius;
  }
}

TEST(debris_cloud, no_hole_is_no_number) {
  maker k;
  add_plate(k, 0);
  EXPECT_TRUE(std::isnan(debris_cloud(k.make(false), scene).hole_diameter));
  EXPECT_TRUE(std::isnan(debris_cloud(maker{}.make(false), scene).hole_diameter));
}

TEST(debris_cloud, bubble_starts_where_the_outline_widens) {
  // a tube of radius 5 mm to z = 12 mm, then a cone to 15 mm at z = 22 mm, then a lid of 1 mm
  maker k;
  const auto radius = [](double z) { return z < 12 ? 5.0 : 5 + (z - 12); };
  for (double z = 2.01; z < 22; z += 0.02) k.add(0, radius(z) * mm, z * mm, 0, 500, 1e-6);
  const debris_cloud c(k.make(false), scene);
  EXPECT_NEAR(c.bubble_start_z, 13 * mm, 0.25 * mm); // 10 % of the way from 5 to 15 mm
  EXPECT_NEAR(c.bubble_length, c.front_z - c.bubble_start_z, 1e-15);
  EXPECT_NEAR(c.widest_z, 22 * mm, 0.25 * mm);
}

TEST(debris_cloud, outline_follows_the_edge) {
  const auto edge = outline(test::synthetic_cloud(0.1e-3), {.plate_front_z = 0, .plate_rear_z = 2.2 * mm, .impact_speed = 6640}, 1 * mm);
  ASSERT_GT(edge.size(), 30u);
  for (const auto& [z, r] : edge)
    if (z > 5 * mm && z < 22 * mm) {
      EXPECT_NEAR(r, (10.5 + 8 * std::sin(1.5707963 * z / (23 * mm))) * mm, 0.6 * mm) << z;
    }
}

TEST(debris_cloud, absent_columns_give_no_number_and_no_throw) {
  const debris_cloud c(line_of_debris().make(false), scene);
  EXPECT_TRUE(std::isnan(c.median_temperature));
  EXPECT_TRUE(std::isnan(c.molten_mass));
  EXPECT_TRUE(std::isnan(c.molten_fraction_projectile));
  EXPECT_TRUE(std::isnan(c.mass_by_region[0]));
  EXPECT_TRUE(std::isnan(c.peak_pressure));
  EXPECT_NEAR(c.length_plate_to_front, 9.99 * mm, 1e-12);
}

TEST(debris_cloud, nothing_downstream) {
  maker k;
  k.add(0, 1 * mm, -1 * mm, 0, 1000, 1e-3);
  const debris_cloud c(k.make(), scene);
  EXPECT_TRUE(std::isnan(c.front_z));
  EXPECT_EQ(c.mass_downstream, 0);
  EXPECT_EQ(c.veil_tip_z, 0);
}

TEST(debris_cloud, particles_that_are_no_numbers_are_counted) {
  maker k = line_of_debris();
  k.add(0, std::nan(""), 5 * mm, 0, 500, 1);
  k.add(0, 1 * mm, INFINITY, 0, 500, 1);
  const debris_cloud c(k.make(), scene);
  EXPECT_EQ(c.not_finite, 2);
  EXPECT_NEAR(c.front_z, 11.99 * mm, 1e-12);
}

TEST(debris_cloud, rows_name_each_measure_once) {
  const auto rows = debris_cloud(line_of_debris().make(), scene).rows();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(rows[i].name, rows[j].name);
  EXPECT_EQ(rows[0].name, "length_plate_to_front_mm");
  EXPECT_NEAR(rows[0].value, 9.99, 1e-9);
}

TEST(debris_cloud, scene_is_checked) {
  EXPECT_THROW(debris_cloud(line_of_debris().make(), {.plate_front_z = 0, .plate_rear_z = 0, .impact_speed = 1}), bad_parameter);
  EXPECT_THROW(debris_cloud(line_of_debris().make(), {.plate_front_z = 0, .plate_rear_z = 1, .impact_speed = 0}), bad_parameter);
}

} // namespace
} // namespace bolide::observe
