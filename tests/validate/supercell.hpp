// SPDX-License-Identifier: MIT
// The paper's molecular dynamics as a reference for tests: a periodic block of N x N x N cubic cells of any embedded-atom potential.
//
//   E_p = sum_i F(rho_i) + sum_{i<j} phi(r_ij),  rho_i = sum_j f(r_ij)                                      the paper's (13)
//   f_i = -dE_p/dr_i = sum_j f_ij (r_i - r_j)/r_ij,  f_ij = -[phi' + (F'_i + F'_j) f'](r_ij)                (12)
//   E   = sum_i m v_i^2/2 + E_p                                                                            (14)
//   p   = [2/3 sum_i m v_i^2/2 + 1/3 sum_{i<j} r_ij f_ij]/V                                                (15)
// The paper prints (15) with a minus sign, which is right for f = +dE/dr; with the force of (12) it is a plus, and the force must hold
// the embedding part. At 0 K the kinetic term is nothing.
//
// Sums run over explicit images, so the block may be smaller than the potential's reach (one cell is enough for the perfect lattice).
// Pairs beyond reach() count as nothing. The list of pairs reaches `skin` further and is made anew before an atom has moved skin/2.
// Units: angstrom, eV, atomic mass units, femtoseconds, kelvin; pressures in pascal. Cost: some 30 ns per pair and step.
#pragma once

#include "bolide/concepts/potential.hpp"
#include "bolide/core/algebra.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/unit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace supercell {

using vector3 = bolide::vec<double, 3>;

inline constexpr double boltzmann = 1.380649e-23 / bolide::unit::eV;               // eV/K, CODATA 2018, exact
inline constexpr double acceleration = bolide::unit::eV / bolide::unit::u * 1e-10; // angstrom/fs^2 of 1 eV/angstrom on 1 u
inline constexpr double pascal = bolide::unit::eV / 1e-30;                         // Pa of 1 eV/angstrom^3

/// Where the atoms of one cubic cell sit, in its edge.
inline std::vector<vector3> cell_sites(bolide::lattice structure) {
  if (structure == bolide::lattice::bcc) return {{0, 0, 0}, {0.5, 0.5, 0.5}};
  return {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
}

/// How a relaxation ended.
struct relaxation {
  int steps;
  double largest_force; // eV/angstrom
  double energy;        // eV, of the whole block
};

template <bolide::EmbeddedAtomPotential P> class block {
public:
  /// The perfect lattice of edge `a` (angstrom) at rest.
  block(P potential, int cells, double a, double skin = 0) : potential_(std::move(potential)), edge_(cells * a), skin_(skin) {
    bolide::require(cells > 0, "supercell cells", cells, "> 0");
    bolide::require(a > 0, "supercell lattice constant", a, "> 0", "angstrom");
    bolide::require(skin >= 0, "supercell skin", skin, ">= 0", "angstrom");
    const std::vector<vector3> sites = cell_sites(potential_.structure());
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j)
        for (int k = 0; k < cells; ++k)
          for (const vector3& site : sites) position_.push_back(a * (vector3(i, j, k) + site));
    velocity_.assign(atoms(), vector3::Zero());
    list_pairs();
    evaluate();
  }

  std::size_t atoms() const { return position_.size(); }
  double volume() const { return edge_ * edge_ * edge_; } // angstrom^3
  double edge() const { return edge_; }                   // angstrom
  const std::vector<vector3>& positions() const { return position_; }
  const std::vector<vector3>& velocities() const { return velocity_; }
  const std::vector<vector3>& forces() const { return force_; } // eV/angstrom
  double potential_energy() const { return energy_; }           // eV
  double kinetic_energy() const {
    double sum = 0;
    for (const vector3& v : velocity_) sum += v.squaredNorm();
    return 0.5 * potential_.mass() * sum / acceleration;
  }
  /// Of the 3(n - 1) degrees of freedom that are left when the block as a whole is at rest.
  double temperature() const { return 2 * kinetic_energy() / (3 * static_cast<double>(atoms() - 1) * boltzmann); }
  double pressure() const { return (2 * kinetic_energy() + virial_) / (3 * volume()) * pascal; } // Pa

  // ---- changes of the block ----------------------------------------------------------------------------------------------------------

  void move(std::size_t atom, const vector3& by) {
    position_.at(atom) += by;
    refresh();
  }

  /// Every coordinate of every atom by a normal deviate of standard deviation `amplitude` (angstrom).
  void perturb(double amplitude, unsigned seed) {
    deviates random(seed);
    for (vector3& x : position_) x += amplitude * random.three();
    refresh();
  }

  /// Box and atoms alike, all lengths times `factor`.
  void stretch(double factor) {
    edge_ *= factor;
    for (vector3& x : position_) x *= factor;
    list_pairs();
    evaluate();
  }

  void remove(std::size_t atom) {
    const auto at = static_cast<std::ptrdiff_t>(atom);
    position_.erase(position_.begin() + at);
    velocity_.erase(velocity_.begin() + at);
    list_pairs();
    evaluate();
  }

  /// Normal velocities of the given temperature (exactly that of temperature()), the block as a whole at rest.
  void heat(double kelvin, unsigned seed) {
    deviates random(seed);
    vector3 mean = vector3::Zero();
    for (vector3& v : velocity_) {
      v = random.three();
      mean += v;
    }
    mean /= static_cast<double>(atoms());
    for (vector3& v : velocity_) v -= mean;
    scale_temperature(kelvin);
  }
  void scale_temperature(double kelvin) {
    const double factor = std::sqrt(kelvin / temperature());
    for (vector3& v : velocity_) v *= factor;
  }

  // ---- motion ------------------------------------------------------------------------------------------------------------------------

  /// One step of velocity Verlet (second order, reversible, conserves momentum), dt in fs.
  void step(double dt) {
    kick(0.5 * dt);
    for (std::size_t i = 0; i < atoms(); ++i) position_[i] += dt * velocity_[i];
    refresh();
    kick(0.5 * dt);
  }

  /// Down to rest by the fast inertial relaxation engine (Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201, with its own constants):
  /// velocities turn towards the forces while the power f.v is positive and stop where it is not. Ends at the given largest force.
  relaxation relax(double force_tolerance = 1e-9, int most_steps = 5000) {
    const double dt_start = 2, dt_most = 10, mixing_start = 0.1;
    double dt = dt_start, mixing = mixing_start;
    int downhill = 0, steps = 0;
    for (vector3& v : velocity_) v.setZero();
    while (largest_force() > force_tolerance && steps < most_steps) {
      double power = 0, vv = 0, ff = 0;
      for (std::size_t i = 0; i < atoms(); ++i) {
        power += force_[i].dot(velocity_[i]);
        vv += velocity_[i].squaredNorm();
        ff += force_[i].squaredNorm();
      }
      if (power > 0) {
        const double along = mixing * std::sqrt(vv / ff);
        for (std::size_t i = 0; i < atoms(); ++i) velocity_[i] = (1 - mixing) * velocity_[i] + along * force_[i];
        if (++downhill > 5) {
          dt = std::min(1.1 * dt, dt_most);
          mixing *= 0.99;
        }
      } else if (steps > 0) {
        for (vector3& v : velocity_) v.setZero();
        dt *= 0.5;
        mixing = mixing_start;
        downhill = 0;
      }
      step(dt);
      ++steps;
    }
    for (vector3& v : velocity_) v.setZero();
    return {steps, largest_force(), energy_};
  }

private:
  struct pair_of_atoms {
    std::size_t i, j;
    vector3 shift; // angstrom: atom j stands at position_[j] + shift
  };
  struct bond {
    vector3 from_j_to_i;
    double r, pair_slope, density_slope;
  };
  struct deviates {
    explicit deviates(unsigned seed) : engine(seed) {}
    vector3 three() {
      const double x = normal(engine), y = normal(engine), z = normal(engine);
      return {x, y, z};
    }
    std::mt19937 engine;
    std::normal_distribution<double> normal;
  };

  double largest_force() const {
    double most = 0;
    for (const vector3& f : force_) most = std::max(most, f.norm());
    return most;
  }

  void kick(double dt) {
    const double factor = dt * acceleration / potential_.mass();
    for (std::size_t i = 0; i < atoms(); ++i) velocity_[i] += factor * force_[i];
  }

  void refresh() {
    const double far = 0.25 * skin_ * skin_;
    bool moved_far = skin_ == 0;
    for (std::size_t i = 0; i < atoms() && !moved_far; ++i) moved_far = (position_[i] - listed_[i]).squaredNorm() > far;
    if (moved_far) list_pairs();
    evaluate();
  }

  /// Each pair once: of two atoms every image of the second within reach, of one atom half of its own images.
  void list_pairs() {
    pairs_.clear();
    listed_ = position_;
    const double reach = potential_.reach() + skin_, reach2 = reach * reach;
    for (std::size_t i = 0; i < atoms(); ++i)
      for (std::size_t j = i; j < atoms(); ++j) {
        const vector3 d = position_[i] - position_[j];
        int low[3], high[3]; // images whose distance along each axis is within reach
        for (int k = 0; k < 3; ++k) {
          low[k] = static_cast<int>(std::ceil((d[k] - reach) / edge_));
          high[k] = static_cast<int>(std::floor((d[k] + reach) / edge_));
        }
        for (int p = low[0]; p <= high[0]; ++p)
          for (int q = low[1]; q <= high[1]; ++q)
            for (int s = low[2]; s <= high[2]; ++s) {
              const bool first_half = p > 0 || (p == 0 && (q > 0 || (q == 0 && s > 0)));
              if (i == j && !first_half) continue;
              const vector3 shift = edge_ * vector3(p, q, s);
              if ((d - shift).squaredNorm() <= reach2) pairs_.push_back({i, j, shift});
            }
      }
  }

  void evaluate() {
    const double reach = potential_.reach();
    bonds_.resize(pairs_.size());
    density_.assign(atoms(), 0);
    force_.assign(atoms(), vector3::Zero());
    double pair_energy = 0, embedding_energy = 0;
    for (std::size_t n = 0; n < pairs_.size(); ++n) {
      const auto& [i, j, shift] = pairs_[n];
      bond& b = bonds_[n];
      b.from_j_to_i = position_[i] - position_[j] - shift;
      b.r = b.from_j_to_i.norm();
      if (b.r > reach) {
        b.r = 0; // listed for later, not a bond now
        continue;
      }
      const bolide::potential_value phi = potential_.pair(b.r), f = potential_.density(b.r);
      pair_energy += phi.value;
      density_[i] += f.value;
      density_[j] += f.value;
      b.pair_slope = phi.first;
      b.density_slope = f.first;
    }
    for (double& rho : density_) { // from here on density_ holds F'
      const bolide::potential_value F = potential_.embedding(rho);
      embedding_energy += F.value;
      rho = F.first;
    }
    virial_ = 0;
    for (std::size_t n = 0; n < pairs_.size(); ++n) {
      const bond& b = bonds_[n];
      if (b.r == 0) continue;
      const std::size_t i = pairs_[n].i, j = pairs_[n].j;
      const double f = -(b.pair_slope + (density_[i] + density_[j]) * b.density_slope);
      const vector3 on_i = (f / b.r) * b.from_j_to_i;
      force_[i] += on_i;
      force_[j] -= on_i;
      virial_ += b.r * f;
    }
    energy_ = pair_energy + embedding_energy;
  }

  P potential_;
  double edge_, skin_; // angstrom
  std::vector<vector3> position_, velocity_, force_, listed_;
  std::vector<pair_of_atoms> pairs_;
  std::vector<bond> bonds_;
  std::vector<double> density_;
  double energy_ = 0, virial_ = 0; // eV
};

} // namespace supercell
