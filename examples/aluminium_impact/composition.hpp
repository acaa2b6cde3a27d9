// SPDX-License-Identifier: MIT
// One composition of the solver behind the interface `simulation`; material_*.cpp bring the materials, composition_*.cpp the types.
#pragma once

#include "chosen_material.hpp"
#include "simulation.hpp"

#include "bolide/observe/take_snapshot.hpp"
#include "bolide/solver/solver.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace impact {

template <class T, class Shape, class Transfer, class Scheme> class composition final : public simulation {
public:
  composition(const settings& s, const chosen_material<T>& ball, const chosen_material<T>& plate)
      : two_sizes_(s.coarse_beyond.has_value()), thermal_energy_{ball.thermal_energy, plate.thermal_energy, plate.thermal_energy}, solver_(make_solver(s, ball, plate)) {
    if (s.box) {
      bolide::leaving_box<2> b;
      b.low << -s.box->r_max, s.box->z_min;
      b.high << s.box->r_max, s.box->z_max;
      solver_.add(b);
    }
  }

  void start() override { solver_.run(0); }
  void step(double most) override try { solver_.step(most); } catch (const bolide::run_stopped& why) {
    throw stopped(why.what());
  }
  double time() const override { return solver_.time(); }
  double dt() const override { return solver_.dt(); }
  bolide::step_cause cause() const override { return solver_.cause(); }
  long steps() const override { return solver_.steps(); }
  std::uint64_t particle_steps() const override { return solver_.particle_steps(); }
  double solver_seconds() const override { return solver_.solver_seconds(); }
  std::size_t particle_count() const override { return solver_.particle_count(); }
  double geometric_mass() const override { return solver_.geometric_mass(); }
  int threads() const override { return solver_.threads(); }
  const bolide::ledger& energies() override { return solver_.energies(); }
  bolide::observe::snapshot snapshot() const override {
    auto shot = bolide::observe::take_snapshot(solver_);
    if (!two_sizes_) shot.body_names.pop_back(); // a rim without particles
    return shot;
  }

#if defined(BOLIDE_HDF5)
  void archive(bolide::hdf5::writer& a) override { solver_.archive(a); }
  void archive(bolide::hdf5::reader& a) override { solver_.archive(a); }
#endif

  census count() const override {
    census c;
    bool first = true;
    std::size_t body = 0;
    solver_.for_each_body([&](const auto& set) {
      const auto& p = set.columns;
      const auto& thermal_energy = thermal_energy_[body++];
      for (std::size_t i = 0; i < p.size(); ++i, first = false) {
        const double m = p.template get<bolide::field::mass>()[i], pressure = p.template get<bolide::field::pressure>()[i];
        const double v_r = p.template get<bolide::field::velocity>(0)[i], v_z = p.template get<bolide::field::velocity>(1)[i];
        const double density = m / set.material.material_volume(p, i);
        const auto at = set.material.thermodynamics(p, i);
        c.mass += m;
        c.cold += m * at.cold_energy;
        c.thermal += m * thermal_energy(density, at);
        c.shear += m * set.material.shear_energy(p, i);
        c.least_pressure = first ? pressure : std::fmin(c.least_pressure, pressure);
        c.most_pressure = first ? pressure : std::fmax(c.most_pressure, pressure);
        c.least_density = first ? density : std::fmin(c.least_density, density);
        c.most_density = std::fmax(c.most_density, density);
        c.most_speed = std::fmax(c.most_speed, std::hypot(v_r, v_z));
        c.most_temperature = std::fmax(c.most_temperature, at.temperature);
      }
    });
    return c;
  }

private:
  using material_type = bolide::any_material<T, bolide::space::axisymmetric>;
  using solver_type = bolide::solver<T, bolide::space::axisymmetric, bolide::grid::sparse, Shape, Transfer, Scheme, bolide::contact::single_field, material_type, material_type, material_type>;

  /// The plate between two radii; of no width: no particle.
  struct part_of_plate {
    static constexpr int dim = 2;
    double from, to, thickness;
    bolide::vec<double, 2> anchor() const { return low(); }
    bolide::vec<double, 2> low() const { return {from, 0}; }
    bolide::vec<double, 2> high() const { return {to, thickness}; }
    bool contains(const bolide::vec<double, 2>& x, double) const { return x[0] > from && x[0] < to && x[1] > 0 && x[1] < thickness; }
    double volume(bool) const { return std::numbers::pi * (to * to - from * from) * thickness; }
  };

  /// The sphere touches the plate at the origin and flies along z. The rim, of wider particles, is welded to the target: they share one velocity field.
  static solver_type make_solver(const settings& s, const chosen_material<T>& ball, const chosen_material<T>& plate) {
    using namespace bolide;
    using point = vec<double, 2>;
    const double radius = s.diameter / 2, seam = s.coarse_beyond.value_or(s.plate_radius);
    const jitter shaken{s.jitter, s.seed}, shaken_otherwise{s.jitter, s.seed + 0x9e3779b97f4a7c15u};
    const body projectile{"projectile", sphere{point{0, -radius}, radius},        ball.material,
                          s.spacing,    initial_state{ball.density, ball.energy}, point{0, s.velocity},
                          shaken};
    const body target{"target",  part_of_plate{0, seam, s.thickness},        plate.material,
                      s.spacing, initial_state{plate.density, plate.energy}, point{0, 0},
                      shaken_otherwise};
    const body rim{"rim",
                   part_of_plate{seam, s.plate_radius, s.thickness},
                   plate.material,
                   s.coarse_beyond ? coarse_spacing(s) : s.spacing,
                   initial_state{plate.density, plate.energy},
                   point{0, 0},
                   jitter{s.jitter, s.seed + 2 * 0x9e3779b97f4a7c15u}};
    controls<T> c;
    c.courant = s.cfl;
    c.threads = s.threads;
    c.step_cap = s.step_cap;
    return solver_type{space::axisymmetric{}, grid::sparse{s.cell}, Shape{}, Transfer{}, Scheme{}, c, projectile, target, rim};
  }

  bool two_sizes_;
  std::vector<decltype(chosen_material<T>::thermal_energy)> thermal_energy_;
  solver_type solver_;
};

/// The composition with one of the schemes.
template <class T, class Shape, class Transfer>
std::unique_ptr<simulation> compose(const settings& s, const chosen_material<T>& ball, const chosen_material<T>& plate) {
  if (s.scheme == "musl") return std::make_unique<composition<T, Shape, Transfer, bolide::scheme::musl>>(s, ball, plate);
  return std::make_unique<composition<T, Shape, Transfer, bolide::scheme::usf>>(s, ball, plate);
}

} // namespace impact
