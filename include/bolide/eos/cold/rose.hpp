// SPDX-License-Identifier: MIT
// Rose's universal binding curve (Rose, Smith, Guinea and Ferrante, Phys. Rev. B 29 (1984) 2963); it is also exactly the cold curve of
// Johnson's analytic nearest-neighbour embedded-atom models.
//
//   e_c = E_c [1 - (1 + u) e^-u],  u = eta (x^(1/3) - 1),  eta = 3 sqrt(B/(rho0 E_c))        (p_c, dp_c/dx: cold::universal_binding)
// p_c(1) = 0. Validity for aluminium: about 6 % soft at x = 0.5 against static data. B' = 1 + 2 eta/3. Cost: one cube root, one exponential.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/unit.hpp"
#include "bolide/eos/cold/universal_binding.hpp"

#include <cmath>

namespace bolide::cold {

/// Defaults: aluminium.
struct rose_parameters {
  double density = 2697.8;                                       // rho0, kg/m3 at x = 1
  double bulk_modulus = 79.4e9;                                  // B at x = 1, Pa
  double cohesive_energy = 3.36 * unit::eV / (26.982 * unit::u); // E_c, J/kg
};

class rose {
public:
  explicit rose(const rose_parameters& parameters = {}) : q_(parameters) {
    require(q_.density > 0, "cold::rose density", q_.density, "> 0", "kg/m3");
    require(q_.bulk_modulus > 0, "cold::rose bulk_modulus", q_.bulk_modulus, "> 0", "Pa");
    require(q_.cohesive_energy > 0, "cold::rose cohesive_energy", q_.cohesive_energy, "> 0", "J/kg");
    curve_ = {q_.density, q_.cohesive_energy, 3 * std::sqrt(q_.bulk_modulus / (q_.density * q_.cohesive_energy))};
  }

  template <class V> BOLIDE_INLINE cold_point<V> evaluate(V x) const { return curve_.evaluate(x); }
  double reference_density() const { return q_.density; }
  double cohesive_energy() const { return q_.cohesive_energy; }
  double eta() const { return curve_.eta; }
  const rose_parameters& parameters() const { return q_; }

private:
  rose_parameters q_;
  universal_binding curve_{};
};

static_assert(ColdCurve<rose> && ColdCurve<rose, pack<float, 4>>);

} // namespace bolide::cold
