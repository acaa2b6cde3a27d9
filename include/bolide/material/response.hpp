// SPDX-License-Identifier: MIT
// What a material answers to a fixed set of states: a fingerprint of its models and their parameters that needs to know neither.
//
// The constitutive update is run on single particles of densities from 800 to 20,000 kg/m3 and energies from 0 to 8 MJ/kg that have
// yielded by 0.3 and are compressed, stretched and sheared by some 2 %; every column of the result is recorded. Where the material can fail, the
// density at which stretched material starts to fail is found by bisection for two energies, and the energy at which it fails at one density. A changed
// parameter of the equation of state, strength, viscosity or failure law moves some of these numbers, unless it acts in other states only
// (a fracture strain that is never reached, say). The same numbers come out on every machine but for rounding.
// Cost: some 300 updates of one particle; for checks when a run starts, not for the time loop.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/material/report.hpp"
#include "bolide/particles/columns.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace bolide {

/// One number of a fingerprint and what it is.
struct response_number {
  double value;
  std::string what;
};

template <class T, class Space, class Material> class material_response {
public:
  explicit material_response(const Material& m) : material_(&m) {
    for (double density = 800; density < 2e4; density *= 1.25)
      for (const double energy : {0.0, 2e5, 1.5e6, 8e6})
        for (const double strain : {-0.02, 0.02}) record({density, energy, strain});
    if constexpr (columns::template has<field::failed>) {
      const double cold = failing_density(0), warm = failing_density(3e5);
      numbers_.push_back({cold, "density at which stretched material of energy 0 J/kg fails (kg/m3)"});
      numbers_.push_back({warm, "density at which stretched material of energy 3e5 J/kg fails (kg/m3)"});
      numbers_.push_back({failing_energy(1.05 * cold), "energy at which stretched material fails at 1.05 of that density (J/kg)"});
    }
  }
  const std::vector<response_number>& numbers() const { return numbers_; }
  static constexpr double tolerance = sizeof(T) == 4 ? 1e-4 : 1e-6; // what rounding moves stays below it

private:
  using columns = particles::columns<T, Space, typename Material::particle_fields>;
  struct state {
    double density, energy, strain;
  };
  const Material* material_;
  std::vector<response_number> numbers_;

  /// A particle of 1 mg after one update of 10 ns.
  columns answer(const state& at) const {
    constexpr double mass = 1e-6, dt = 1e-8;
    columns p;
    p.append(0);
    const auto set = [&]<class Tag>(Tag, double x) {
      if constexpr (columns::template has<Tag>) p.template get<Tag>()[0] = static_cast<T>(x);
    };
    set(field::mass{}, mass);
    set(field::volume{}, mass / at.density);
    set(field::material_volume{}, mass / at.density);
    set(field::energy{}, at.energy);
    set(field::sound_speed{}, 5000);
    set(field::plastic_strain{}, 0.3);
    T gradient[Space::gradient_size][chunk_size] = {};
    for (int c = 0; c < Space::gradient_size; ++c) gradient[c][0] = static_cast<T>(at.strain / dt * (1 - 0.15 * c));
    update_report report;
    material_->template update<Space>(p, 0, 1, gradient, step_context<T>{static_cast<T>(dt), T(1e-4), T(0.4), 0, false}, report);
    return p;
  }
  void record(const state& at) {
    const columns p = answer(at);
    const auto record_fields = [&]<class... F>(fields<F...>) {
      const auto one = [&]<class Tag>(Tag) {
        const std::string what = std::string(Tag::name) + " (" + Tag::unit + ") after a strain of " + to_text(at.strain) + " at " + to_text(at.density) +
                                 " kg/m3 and " + to_text(at.energy) + " J/kg";
        for (int c = 0; c < Space::components(Tag::order); ++c) numbers_.push_back({static_cast<double>(p.template get<Tag>(c)[0]), what});
      };
      (one(F{}), ...);
    };
    record_fields(typename columns::field_list{});
  }
  bool fails(double density, double energy) const { return answer({density, energy, 0.02}).template get<field::failed>()[0] > T(0); }
  /// From dense to thin: where does it start to fail? 0 where it never does.
  double failing_density(double energy) const {
    double sound = 2e4, failed = sound;
    while (failed > 100 && !fails(failed, energy)) sound = failed, failed /= 1.03;
    if (failed <= 100) return 0;
    for (int i = 0; i < 40; ++i) (fails((sound + failed) / 2, energy) ? failed : sound) = (sound + failed) / 2;
    return failed;
  }
  double failing_energy(double density) const {
    if (!(density > 0)) return 0;
    double sound = 0, failed = 1e4;
    while (failed < 1e9 && !fails(density, failed)) sound = failed, failed *= 1.3;
    if (failed >= 1e9) return 0;
    for (int i = 0; i < 40; ++i) (fails(density, (sound + failed) / 2) ? failed : sound) = (sound + failed) / 2;
    return failed;
  }
};

} // namespace bolide
