// SPDX-License-Identifier: MIT
// One particle without a grid: the constitutive update driven by a velocity gradient of the test's choice.
#pragma once

#include "bolide/material/material.hpp"
#include "bolide/particles/columns.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/planar_1d.hpp"

#include <array>

namespace bolide::test {

template <class Material, class Space = space::planar_1d, class T = double> class material_point {
public:
  using columns_type = particles::columns<T, Space, typename Material::particle_fields>;
  using gradient = typename Space::template gradient<double>;

  material_point(const Material& m, double density, double energy, double mass = 1e-6) : material_(m) {
    p.append(3);
    p.template get<field::mass>()[0] = static_cast<T>(mass);
    material_.initialise(p, 0, 1, density, energy);
  }
  /// The stress for the velocity gradient l, and its work unless told not to.
  update_report advance(const gradient& l, double dt, bool with_work = true, double courant = 0.4) {
    T lanes[Space::gradient_size][chunk_size] = {};
    for (std::size_t c = 0; c < l.size(); ++c) lanes[c][0] = static_cast<T>(l[c]);
    update_report report;
    const step_context<T> step{static_cast<T>(dt), static_cast<T>(cell), static_cast<T>(courant), T(0), true};
    material_.template update<Space>(p, 0, 1, lanes, step, report);
    if (with_work) material_.template work<Space>(p, 0, 1, lanes, static_cast<T>(dt), report);
    return report;
  }
  template <class Tag> T& get(int component = 0) { return p.template get<Tag>(component)[0]; }
  double density() { return static_cast<double>(get<field::mass>() / get<field::volume>()); }
  double own_density() { return static_cast<double>(get<field::mass>()) / material_.material_volume(p, 0); }
  thermal_point<double> thermodynamics() { return material_.thermodynamics(p, 0); }
  const Material& material() const { return material_; }

  columns_type p;
  static constexpr double cell = 1e-4; // m

private:
  Material material_;
};
template <class Material> material_point(Material, double, double) -> material_point<Material>;

} // namespace bolide::test
