// SPDX-License-Identifier: MIT
// Extremes 12 and 14: dilation to stretch 20 and 100, shear to 10 and 100. Spin: spin_slow_test.cpp.
#include "extreme/extreme.hpp"

#include "bolide/failure/tension.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

namespace bolide {
namespace {
using namespace extreme;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
template <class Method> class Deformation : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_musl, float_apic_musl>;
TYPED_TEST_SUITE(Deformation, methods, method_names);

template <class Method, class Space> void record(const std::string& problem, const char* measure, double got, double bound,
                                                 const std::string& note = "", const char* unit = "") {
  verify::record({.section = "extremes",
                  .problem = problem,
                  .composition = composition<Method, Space>(),
                  .measure = measure,
                  .value = got,
                  .bound = bound,
                  .unit = unit,
                  .note = note});
  if (!std::isnan(bound)) { EXPECT_LE(std::abs(got), bound) << problem << ": " << measure; }
}

/// A bar that has failed flies apart, v = H x: it must feel no stress and keep its linear velocity. Where two points are more than a
/// support apart, the grid no longer sees one body: numerical fracture, by the stretch at which the volumes of the particles fall behind.
TYPED_TEST(Deformation, FailedMaterialDilatesWithoutStress) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm, rate = 1e6, length = 4 * mm;
  const material al{eos::mie_grueneisen{{.constant_gamma = true}}, strength::elastic_perfectly_plastic{27.6e9, 0.3e9},
                    failure::tension{1.5e9}};
  for (const double stretch : {20.0, 100.0}) {
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<T>(), body{"bar", box{point{-length / 2}, point{length / 2}}, al, h / 2, initial_state{2785, 0}});
    std::vector<double> start(sim.particle_count());
    sim.for_each_body([&](auto& s) {
      auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        start[p.id()[i]] = value<field::position>(s, i);
        p.template get<field::velocity>()[i] = static_cast<T>(rate * start[p.id()[i]]);
        p.template get<field::failed>()[i] = T(1);
        if constexpr (TypeParam::transfer_type::affine) p.template get<field::affine_velocity>()[i] = static_cast<T>(rate);
      }
    });
    double onset = 0, worst_stress = 0;
    while (1 + rate * sim.time() < stretch) {
      sim.step((stretch - 1) / rate - sim.time() + 1e-12);
      double volume = 0;
      for_each_particle(sim, [&](const auto& s, std::size_t i) {
        worst_stress = std::max(worst_stress, std::abs(value<field::pressure>(s, i)));
        volume += value<field::volume>(s, i);
      });
      if (onset == 0 && std::abs(volume / (length * (1 + rate * sim.time())) - 1) > 0.2) onset = 1 + rate * sim.time();
    }
    is_sound(sim);
    double worst = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      worst = std::max(worst, std::abs(value<field::velocity>(s, i) / (rate * start[s.columns.id()[i]]) - 1));
    });
    const std::string name = "failed bar dilated to stretch " + to_text(stretch);
    record<TypeParam, space::planar_1d>(name, "largest pressure over the bulk modulus", worst_stress / (2785 * 5328. * 5328.),
                                        sizeof(T) == 8 ? 1e-12 : 1e-6);
    record<TypeParam, space::planar_1d>(name, "velocity against H x, largest relative change", worst,
                                        TypeParam::transfer_type::affine ? 0.05 : 1e-3,
                                        TypeParam::transfer_type::affine ? "APIC smooths the linear field at the free ends" : "");
    record<TypeParam, space::planar_1d>(name, "stretch at which the volumes are 20 % off (0: never)", onset, verify::none,
                                        "numerical fracture: points a support apart");
  }
}

/// Simple shear of a block far from its free ends, v_x = gamma' y: without a yield stress Jaumann's rate turns the stress, s_xy = G
/// sin(gamma), whose amplitude is exact; with one the stress stays at Y/sqrt(3). By the material alone: the same update that a solver
/// calls.
template <class T> void simple_shear() {
  using space = space::plane_strain;
  using Method = method<shape::linear, transfer::flip, scheme::usf, T>; // its number type only
  const double g = 27.6e9, yield = 0.3e9, rate = 1e6;
  const auto shear = [&](double y, double until, double& most, double& least_after) {
    const material al{eos::mie_grueneisen{{.constant_gamma = true}}, strength::elastic_perfectly_plastic{g, y}, failure::none{},
                      viscosity::none{}};
    using fields_type = typename decltype(al)::particle_fields;
    particles::columns<T, space, fields_type> p;
    p.append(0);
    p.template get<field::mass>()[0] = T(2785e-9);
    al.initialise(p, 0, 1, 2785, 0);
    T l[space::gradient_size][chunk_size] = {};
    l[1][0] = static_cast<T>(rate); // v_x,y
    const step_context<T> step{static_cast<T>(1e-3 / rate), T(1e-4), T(0.4), 0, true};
    update_report report;
    most = least_after = 0;
    constexpr int xy = space::deviator_size - 1;
    bool yielded = false;
    for (double strain = 0; strain < until; strain += 1e-3) {
      al.template update<space>(p, 0, 1, l, step, report);
      const double s = static_cast<double>(p.template get<field::deviator>(xy)[0]);
      most = std::max(most, s);
      yielded = yielded || s > 0.9999 * y / std::sqrt(3.0);
      if (yielded) least_after = least_after == 0 ? s : std::min(least_after, s);
    }
  };
  for (const double until : {10.0, 100.0}) {
    double most = 0, least = 0;
    const std::string name = "simple shear to " + to_text(until);
    shear(yield, until, most, least);
    record<Method, space>(name + ", perfectly plastic", "largest shear stress over Y/sqrt(3), less 1", most * std::sqrt(3.0) / yield - 1,
                          1e-3);
    record<Method, space>(name + ", perfectly plastic", "smallest after yield over Y/sqrt(3), less 1", least * std::sqrt(3.0) / yield - 1,
                          0.01);
    shear(1e30, until, most, least);
    record<Method, space>(
        name + ", elastic, Jaumann", "amplitude of the shear stress over G, less 1", most / g - 1, 0.1,
        "oscillates as the exact G sin(gamma): cap it by a yield stress; steps of 1e-3 turn it by Euler, exp(5e-4 gamma)");
  }
}
TEST(Shear, OscillatesOnlyWithoutAYieldStress) { simple_shear<double>(); }
TEST(Shear, OscillatesOnlyWithoutAYieldStressInFloat) { simple_shear<float>(); }

} // namespace
} // namespace bolide
