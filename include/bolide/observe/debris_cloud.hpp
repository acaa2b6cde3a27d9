// SPDX-License-Identifier: MIT
// The measures of a debris cloud, each with a written definition (docs/debris_cloud.md says why and what was rejected).
//
// The flight is along +z, the last component of the positions; r is the first, in 3-D hypot(x, y) about the axis x = y = 0. All lengths
// are mass quantiles: the single fastest particles of a run are no measure of anything. What lies beyond the quantiles is reported as outliers, not
// dropped silently. Masses in an axisymmetric snapshot are those of rings, so a mass fraction is one of the whole cloud. A measure
// that the snapshot cannot give (no column, nothing downstream) is NaN.
// Sets:  downstream   z > rear face of the plate  and  v_z >  5 % of the impact speed
//        ejecta       z < front face of the plate and  v_z < -5 % of the impact speed
//        projectile, plate: by body
// Cost: a few sorts of the downstream particles; 10 ms for 50,000.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/observe/snapshot.hpp"
#include "bolide/observe/weighted_quantile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

/// What the measures must know of the scene.
struct impact_scene {
  double plate_front_z = 0; // m, face that is hit
  double plate_rear_z = 0;  // m
  double impact_speed = 0;  // m/s
  int projectile = 0;       // body index
  int plate = 1;            // body index
  /// Pa, a pressure that no particle should exceed in earnest (shock detachment or jet stagnation, whichever is larger); NaN: none.
  double reference_pressure = std::numeric_limits<double>::quiet_NaN();

  void validate() const {
    require(plate_rear_z > plate_front_z, "z of the plate's rear face", plate_rear_z,
            "above that of its front face " + to_text(plate_front_z), "m");
    require(impact_speed > 0, "impact speed", impact_speed, "more than 0", "m/s");
  }
  double thickness() const { return plate_rear_z - plate_front_z; }
};

/// Particles beyond a quantile: how many, how heavy, how far the furthest is.
struct outliers {
  long count = 0;
  double mass = 0;                                               // kg
  double furthest = std::numeric_limits<double>::quiet_NaN();    // m, the coordinate of the furthest
};

/// One row of a report: name, unit and value in that unit.
struct measure {
  std::string name, unit;
  double value;
};

struct debris_cloud {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double moving = 0.05; // of the impact speed: slower material is no debris

  // ---- lengths, m -----------------------------------------------------------------------------------------------------------
  double front_z = nan;               ///< 99.9 % mass quantile of z of the downstream material
  double length_plate_to_front = nan; ///< front_z less the z of the plate's rear face
  double length_impact_face_to_front = nan; ///< front_z less the z of the face that is hit
  double veil_tip_z = nan;            ///< 0.1 % mass quantile of z of the ejecta; the plate's front face where there is none
  double length_veil_to_front = nan;  ///< front_z less veil_tip_z
  double bubble_start_z = nan;        ///< going back from the widest station of the outline, where it has narrowed to
                                      ///< throat + 10 % of (widest - throat); throat: its least radius between the plate and there
  double bubble_length = nan;         ///< front_z less bubble_start_z
  double width = nan;                 ///< twice the 99.9 % mass quantile of the radius of the downstream material
  double width_p99 = nan;             ///< the same with 99 %
  double widest_z = nan;              ///< station at which the outline is widest
  double hole_diameter = nan;         ///< see hole_diameter_of()

  // ---- speeds, m/s ----------------------------------------------------------------------------------------------------------
  double front_speed = nan;     ///< mass median of v_z in the foremost 1 % of the downstream mass
  double rear_speed = nan;      ///< mass median of v_z in the rearmost 1 % of the projectile's downstream mass
  double expansion_speed = nan; ///< mass median of v_r in the outermost 1 % (by radius) of the downstream mass

  // ---- amounts --------------------------------------------------------------------------------------------------------------
  double mass_downstream = 0, projectile_mass_downstream = 0, plate_mass_downstream = 0, mass_ejecta = 0; // kg
  double momentum_downstream = 0, momentum_ejecta = 0;                                                    // kg m/s along z
  double kinetic_energy_downstream = 0;                                                                   // J
  double projectile_mass = 0;                                                                             // kg, all of it
  /// kg downstream by region (index: bolide::region), NaN without that column.
  std::array<double, 5> mass_by_region{nan, nan, nan, nan, nan};
  double molten_mass = nan;                ///< kg downstream: mass times melt fraction, summed
  double molten_fraction_projectile = nan; ///< mass times melt fraction over all of the projectile, over its mass
  double median_temperature = nan;         ///< K, mass median downstream

  // ---- pressures, Pa: the largest that a particle ever had --------------------------------------------------------------------
  double peak_pressure = nan;                  ///< of all particles: a single particle's spike, not a measure
  double peak_pressure_p999 = nan;             ///< 99.9 % mass quantile over the projectile
  double mass_fraction_over_150_GPa = nan;     ///< of the projectile's mass
  double mass_fraction_over_1p5_reference = nan; ///< of the projectile's mass, above 1.5 x scene.reference_pressure

  // ---- what the quantiles leave out -------------------------------------------------------------------------------------------
  outliers ahead_of_front; ///< downstream, z > front_z; furthest: largest z
  outliers beyond_width;   ///< downstream, r > width / 2; furthest: largest r
  outliers behind_veil;    ///< ejecta, z < veil_tip_z; furthest: smallest z
  long not_finite = 0;     ///< particles whose place, velocity or mass is no number: left out of everything above

  debris_cloud() = default;
  debris_cloud(const snapshot& s, const impact_scene& scene);

  /// All measures in the units of the field, for a table or a file.
  std::vector<measure> rows() const;
};

namespace detail {
/// Radius and radial velocity of a particle: of (r, z) the first component, of (x, y, z) those about the z axis.
struct about_axis {
  const column &x, &v;
  explicit about_axis(const snapshot& s) : x(s.at("position")), v(s.at("velocity")) {}
  double radius(std::size_t i) const { return x.components == 3 ? std::hypot(x(i, 0), x(i, 1)) : std::fabs(x(i, 0)); }
  double radial_velocity(std::size_t i) const {
    if (x.components < 3) return v(i, 0);
    const double r = radius(i);
    return r > 0 ? (x(i, 0) * v(i, 0) + x(i, 1) * v(i, 1)) / r : 0.0;
  }
};
} // namespace detail

/// The outer edge of the downstream material along z: the 99 % mass quantile of the radius in slices of `slice` metres from the plate's
/// rear face to the front. A slice with less than 1e-5 of the downstream mass has no point.
inline std::vector<std::pair<double, double>> outline(const snapshot& s, const impact_scene& scene, double slice = 0.5e-3) {
  require(slice > 0, "slice of the outline", slice, "more than 0", "m");
  scene.validate();
  const column &x = s.at("position"), &v = s.at("velocity"), &mass = s.at("mass");
  const detail::about_axis about(s);
  const int axial = s.dimension - 1;
  weighted_samples along;
  std::vector<std::size_t> cloud;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (x(i, axial) > scene.plate_rear_z && v(i, axial) > debris_cloud::moving * scene.impact_speed) {
      cloud.push_back(i);
      along.add(x(i, axial), mass(i));
    }
  std::vector<std::pair<double, double>> edge;
  if (along.size() == 0) return edge;
  const double front = along.quantile(0.999), total = along.weight();
  const auto slices = static_cast<std::size_t>(std::ceil((front - scene.plate_rear_z) / slice));
  std::vector<weighted_samples> radius(slices);
  for (const std::size_t i : cloud) {
    const auto k = static_cast<std::size_t>((x(i, axial) - scene.plate_rear_z) / slice);
    if (k < slices) radius[k].add(about.radius(i), mass(i));
  }
  for (std::size_t k = 0; k < slices; ++k)
    if (radius[k].weight() >= 1e-5 * total)
      edge.emplace_back(scene.plate_rear_z + (static_cast<double>(k) + 0.5) * slice, radius[k].quantile(0.99));
  return edge;
}

/// The hole in the plate. Plate material that stays (|v| < 5 % of the impact speed) inside the band between the two original faces is
/// collected in annuli, thickness/10 wide but at least two spacings; the undisturbed areal density is the median of the outer half.
/// Coming from outside, the plate ends with the last annulus above half of it; the hole's radius is put where the material of that
/// annulus and the next one inwards would fill up: pi (R^2 - r_hole^2) areal density = its mass (a thickened lip counts as full).
/// Stray particles further in do not count. NaN: no hole. Good to half a spacing in radius.
/// 3-D: the same with the annuli about the z axis that lie within a rectangular plate; a half or a quarter of the scene gives the same diameter.
inline double hole_diameter_of(const snapshot& s, const impact_scene& scene) {
  const column &x = s.at("position"), &v = s.at("velocity"), &mass = s.at("mass");
  if (!(s.axisymmetric || s.dimension == 3) || s.body.size() != s.size()) return debris_cloud::nan;
  const detail::about_axis about(s);
  const int axial = s.dimension - 1;
  const double step = std::max(0.1 * scene.thickness(), 2 * s.spacing), slow = debris_cloud::moving * scene.impact_speed;
  std::vector<double> in_annulus;
  double reach[2] = {0, 0}; // of the plate along x and y
  for (std::size_t i = 0; i < s.size(); ++i) {
    double speed2 = 0;
    for (int d = 0; d < s.dimension; ++d) speed2 += v(i, d) * v(i, d);
    if (s.body[i] != scene.plate || !(speed2 < slow * slow)) continue;
    if (!(x(i, axial) >= scene.plate_front_z && x(i, axial) <= scene.plate_rear_z)) continue;
    const double r = s.axisymmetric ? x(i, 0) : about.radius(i);
    if (!(r >= 0 && r < 1e5 * step)) continue;
    const auto k = static_cast<std::size_t>(r / step);
    if (k >= in_annulus.size()) in_annulus.resize(k + 1, 0.0);
    in_annulus[k] += mass(i);
    for (int d = 0; d < axial; ++d) reach[d] = std::max(reach[d], std::fabs(x(i, d)));
  }
  if (s.dimension == 3) { // whole annuli only: the corners of a rectangular plate would look like less material
    const auto whole = static_cast<std::size_t>((std::min(reach[0], reach[1]) + s.spacing / 2) / step);
    if (whole < in_annulus.size()) in_annulus.resize(whole);
  }
  const auto area = [step](std::size_t k) { return 3.14159265358979323846 * step * step * (2 * static_cast<double>(k) + 1); };
  weighted_samples undisturbed;
  for (std::size_t k = in_annulus.size() / 2; k < in_annulus.size(); ++k) undisturbed.add(in_annulus[k] / area(k), 1);
  const double areal = undisturbed.median();
  std::size_t k = in_annulus.size();
  while (k > 0 && in_annulus[k - 1] < 0.5 * areal * area(k - 1)) --k; // the plate's own outer border
  while (k > 0 && in_annulus[k - 1] >= 0.5 * areal * area(k - 1)) --k;
  if (k == 0 || !(areal > 0)) return debris_cloud::nan;
  const auto filled = [&](std::size_t n) { return n < in_annulus.size() ? std::min(in_annulus[n] / areal, area(n)) : 0.0; };
  const double outer = static_cast<double>(k + 1) * step;
  return 2 * std::sqrt(std::max(0.0, outer * outer - (filled(k) + filled(k - 1)) / 3.14159265358979323846));
}

namespace detail {
/// The sums and samples of one pass over the particles.
struct cloud_samples {
  weighted_samples z, r, temperature, projectile_z, ejecta_z;
  std::vector<std::size_t> downstream, ejecta;
};

/// Mass median of velocity(i) over those particles for which `chosen` holds.
template <class Velocity, class Chosen>
double median_velocity(const snapshot& s, const std::vector<std::size_t>& among, Velocity&& velocity, Chosen&& chosen) {
  const column& mass = s.at("mass");
  weighted_samples samples;
  for (const std::size_t i : among)
    if (chosen(i)) samples.add(velocity(i), mass(i));
  return samples.median();
}

/// Where the bubble begins (see debris_cloud::bubble_start_z) and the widest station of the outline.
inline std::pair<double, double> bubble_start(const std::vector<std::pair<double, double>>& edge) {
  if (edge.empty()) return {debris_cloud::nan, debris_cloud::nan};
  std::size_t widest = 0;
  for (std::size_t k = 1; k < edge.size(); ++k)
    if (edge[k].second > edge[widest].second) widest = k;
  double throat = edge[widest].second;
  for (std::size_t k = 0; k < widest; ++k) throat = std::min(throat, edge[k].second);
  const double level = throat + 0.1 * (edge[widest].second - throat);
  std::size_t k = widest;
  while (k > 0 && edge[k - 1].second > level) --k;
  if (k == 0) return {edge[0].first, edge[widest].first};
  const auto &below = edge[k - 1], &above = edge[k];
  const double t = above.second > below.second ? (level - below.second) / (above.second - below.second) : 0;
  return {below.first + t * (above.first - below.first), edge[widest].first};
}

inline void measure_peaks(debris_cloud& c, const snapshot& s, const impact_scene& scene) {
  const column *peak = s.find("peak_pressure"), &mass = s.at("mass");
  if (!peak) return;
  weighted_samples projectile;
  double over_150 = 0, over_reference = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (std::isfinite((*peak)(i))) c.peak_pressure = std::fmax(c.peak_pressure, (*peak)(i)); // fmax: the number beside a NaN
    if (s.body.size() != s.size() || s.body[i] != scene.projectile) continue;
    projectile.add((*peak)(i), mass(i));
    if ((*peak)(i) > 150e9) over_150 += mass(i);
    if ((*peak)(i) > 1.5 * scene.reference_pressure) over_reference += mass(i);
  }
  c.peak_pressure_p999 = projectile.quantile(0.999);
  if (projectile.size() == 0) return;
  c.mass_fraction_over_150_GPa = over_150 / projectile.weight();
  if (std::isfinite(scene.reference_pressure)) c.mass_fraction_over_1p5_reference = over_reference / projectile.weight();
}

/// Melt fraction of a particle: the column, or else what the region says, or NaN.
inline double melt_fraction(const column* fraction, const column* where, std::size_t i) {
  if (fraction) return (*fraction)(i);
  return where ? ((*where)(i) > 1.5 ? 1.0 : 0.0) : debris_cloud::nan;
}
} // namespace detail

inline debris_cloud::debris_cloud(const snapshot& s, const impact_scene& scene) {
  scene.validate();
  require(s.dimension >= 2, "dimension of the snapshot of a debris cloud", s.dimension, "at least 2");
  const column &x = s.at("position"), &v = s.at("velocity"), &mass = s.at("mass");
  const column *temperature = s.find("temperature"), *where = s.find("region"), *fraction = s.find("melt_fraction");
  const int axial = s.dimension - 1;
  const bool bodies = s.body.size() == s.size();
  const double threshold = moving * scene.impact_speed;
  const detail::about_axis about(s);
  const auto radius = [&](std::size_t i) { return about.radius(i); };
  detail::cloud_samples c;
  double molten_projectile = 0;
  if (where) mass_by_region.fill(0);
  if (where || fraction) molten_mass = 0;

  for (std::size_t i = 0; i < s.size(); ++i) {
    const double z = x(i, axial), vz = v(i, axial), m = mass(i);
    if (!std::isfinite(z) || !std::isfinite(radius(i)) || !std::isfinite(vz) || !std::isfinite(m)) {
      ++not_finite;
      continue;
    }
    const bool of_projectile = bodies && s.body[i] == scene.projectile;
    const double melted = detail::melt_fraction(fraction, where, i);
    if (of_projectile) {
      projectile_mass += m;
      molten_projectile += m * melted;
    }
    if (z > scene.plate_rear_z && vz > threshold) {
      c.downstream.push_back(i);
      c.z.add(z, m), c.r.add(radius(i), m);
      if (temperature) c.temperature.add((*temperature)(i), m);
      mass_downstream += m, momentum_downstream += m * vz;
      double speed2 = 0;
      for (int k = 0; k < s.dimension; ++k) speed2 += v(i, k) * v(i, k);
      kinetic_energy_downstream += 0.5 * m * speed2;
      if (of_projectile) c.projectile_z.add(z, m), projectile_mass_downstream += m;
      else if (bodies && s.body[i] == scene.plate) plate_mass_downstream += m;
      if (where && (*where)(i) > -0.5 && (*where)(i) < 4.5) mass_by_region[static_cast<std::size_t>((*where)(i) + 0.5)] += m;
      molten_mass += m * melted;
    } else if (z < scene.plate_front_z && vz < -threshold) {
      c.ejecta.push_back(i);
      c.ejecta_z.add(z, m);
      mass_ejecta += m, momentum_ejecta += m * vz;
    }
  }
  if (projectile_mass > 0) molten_fraction_projectile = molten_projectile / projectile_mass;
  median_temperature = c.temperature.median();
  detail::measure_peaks(*this, s, scene);
  hole_diameter = hole_diameter_of(s, scene);
  veil_tip_z = c.ejecta.empty() ? scene.plate_front_z : c.ejecta_z.quantile(0.001);
  if (c.downstream.empty()) return;

  front_z = c.z.quantile(0.999);
  length_plate_to_front = front_z - scene.plate_rear_z;
  length_impact_face_to_front = front_z - scene.plate_front_z;
  length_veil_to_front = front_z - veil_tip_z;
  width = 2 * c.r.quantile(0.999);
  width_p99 = 2 * c.r.quantile(0.99);
  const double slice = std::max({length_plate_to_front / 100, 2 * s.spacing, 1e-9});
  const auto [start, widest] = detail::bubble_start(outline(s, scene, slice));
  bubble_start_z = start, widest_z = widest, bubble_length = front_z - start;

  const double nose = c.z.quantile(0.99), limb = c.r.quantile(0.99), tail = c.projectile_z.quantile(0.01);
  const auto along = [&](std::size_t i) { return v(i, axial); };
  const auto outwards = [&](std::size_t i) { return about.radial_velocity(i); };
  front_speed = detail::median_velocity(s, c.downstream, along, [&](std::size_t i) { return x(i, axial) >= nose; });
  expansion_speed = detail::median_velocity(s, c.downstream, outwards, [&](std::size_t i) { return radius(i) >= limb; });
  rear_speed = detail::median_velocity(s, c.downstream, along, [&](std::size_t i) {
    return bodies && s.body[i] == scene.projectile && x(i, axial) <= tail;
  });

  const auto count = [&](outliers& o, std::size_t i, double place, bool further) {
    ++o.count, o.mass += mass(i);
    if (further || std::isnan(o.furthest)) o.furthest = place;
  };
  for (const std::size_t i : c.downstream) {
    if (x(i, axial) > front_z) count(ahead_of_front, i, x(i, axial), x(i, axial) > ahead_of_front.furthest);
    if (radius(i) > width / 2) count(beyond_width, i, radius(i), radius(i) > beyond_width.furthest);
  }
  for (const std::size_t i : c.ejecta)
    if (x(i, axial) < veil_tip_z) count(behind_veil, i, x(i, axial), x(i, axial) < behind_veil.furthest);
}

inline std::vector<measure> debris_cloud::rows() const {
  std::vector<measure> out;
  const auto mm = [&](const char* name, double value) { out.push_back({name, "mm", value * 1e3}); };
  const auto add = [&](std::string name, const char* unit, double value) { out.push_back({std::move(name), unit, value}); };
  mm("length_plate_to_front_mm", length_plate_to_front);
  mm("length_impact_face_to_front_mm", length_impact_face_to_front);
  mm("length_veil_to_front_mm", length_veil_to_front);
  mm("bubble_length_mm", bubble_length);
  mm("width_mm", width);
  mm("width_p99_mm", width_p99);
  mm("widest_z_mm", widest_z);
  mm("front_z_mm", front_z);
  mm("veil_tip_z_mm", veil_tip_z);
  mm("bubble_start_z_mm", bubble_start_z);
  mm("hole_diameter_mm", hole_diameter);
  add("front_speed_m_s", "m/s", front_speed);
  add("rear_speed_m_s", "m/s", rear_speed);
  add("expansion_speed_m_s", "m/s", expansion_speed);
  add("mass_downstream_kg", "kg", mass_downstream);
  add("projectile_mass_downstream_kg", "kg", projectile_mass_downstream);
  add("plate_mass_downstream_kg", "kg", plate_mass_downstream);
  add("mass_ejecta_kg", "kg", mass_ejecta);
  add("momentum_downstream_kg_m_s", "kg m/s", momentum_downstream);
  add("momentum_ejecta_kg_m_s", "kg m/s", momentum_ejecta);
  add("kinetic_energy_downstream_J", "J", kinetic_energy_downstream);
  for (std::size_t k = 0; k < mass_by_region.size(); ++k)
    add(std::string("mass_downstream_") + name(static_cast<region>(static_cast<int>(k))) + "_kg", "kg", mass_by_region[k]);
  add("molten_mass_downstream_kg", "kg", molten_mass);
  add("molten_fraction_projectile", "1", molten_fraction_projectile);
  add("median_debris_temperature_K", "K", median_temperature);
  add("peak_pressure_GPa", "GPa", peak_pressure / 1e9);
  add("peak_pressure_p999_GPa", "GPa", peak_pressure_p999 / 1e9);
  add("mass_fraction_over_150_GPa", "1", mass_fraction_over_150_GPa);
  add("mass_fraction_over_1p5_reference", "1", mass_fraction_over_1p5_reference);
  const auto beyond = [&](const std::string& set, const outliers& o) {
    add("outliers_" + set + "_count", "1", static_cast<double>(o.count));
    add("outliers_" + set + "_mass_kg", "kg", o.mass);
    add("outliers_" + set + "_furthest_mm", "mm", o.furthest * 1e3);
  };
  beyond("ahead_of_front", ahead_of_front);
  beyond("beyond_width", beyond_width);
  beyond("behind_veil", behind_veil);
  add("particles_not_finite", "1", static_cast<double>(not_finite));
  return out;
}

} // namespace bolide::observe
