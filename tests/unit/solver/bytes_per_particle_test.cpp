// SPDX-License-Identifier: MIT
// What a particle of ten compositions takes: every field that some model declares, once, and four bytes of identity. Nothing else is stored.
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/failure/softening.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/steinberg_guinan.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/solver/scenes.hpp"

namespace bolide {
namespace {
using namespace test;

template <class T, class Space, class Shape, class Transfer, class Scheme, class Material> constexpr std::size_t bytes() {
  using sim = solver<T, Space, grid::sparse, Shape, Transfer, Scheme, contact::single_field, Material>;
  return decltype(sim::template set_type<Material>::columns)::bytes_per_particle;
}
using eos_type = eos::mie_grueneisen;
using thermal_eos = eos::isentrope_temperature<eos::mie_grueneisen>;
using quadratic = shape::quadratic_bspline;

TEST(BytesPerParticle, ArePinnedForTenCompositions) {
  using fluid = material<eos_type, strength::none, failure::none, viscosity::none>;
  using shocked_fluid = material<eos_type, strength::none, failure::none>;
  using elastic = material<eos_type, strength::elastic, failure::none, viscosity::none>;
  using plastic = material<eos_type, strength::elastic_perfectly_plastic, failure::none>;
  using impact = material<thermal_eos, strength::johnson_cook, failure::tension_or_melt>;
  using softening = material<thermal_eos, strength::johnson_cook, failure::softening<failure::tension_or_melt>>;
  using damage = material<thermal_eos, strength::johnson_cook, failure::johnson_cook_damage>;
  // mass, volume, energy, pressure; position, velocity, carrying velocity: 4 + 3 dim numbers, and the id
  EXPECT_EQ((bytes<double, space::planar_1d, shape::linear, transfer::flip, scheme::usf, fluid>()), 8 * (4 + 3) + 4u);
  EXPECT_EQ((bytes<float, space::planar_1d, shape::linear, transfer::flip, scheme::usf, fluid>()), 4 * (4 + 3) + 4u);
  // sound speed and viscous pressure
  EXPECT_EQ((bytes<double, space::planar_1d, quadratic, transfer::flip, scheme::musl, shocked_fluid>()), 8 * (4 + 3 + 2) + 4u);
  // a deviator of three numbers
  EXPECT_EQ((bytes<double, space::plane_strain, shape::gimp, transfer::flip, scheme::usl, elastic>()), 8 * (4 + 6 + 3) + 4u);
  // a deviator of five, plastic strain, viscosity, and an affine velocity of nine
  EXPECT_EQ((bytes<double, space::cartesian_3d, quadratic, transfer::apic, scheme::usf, plastic>()), 8 * (4 + 9 + 5 + 1 + 2 + 9) + 4u);
  // the paper's case by the paper's method: viscosity, deviator, plastic strain, failed and its own volume
  EXPECT_EQ((bytes<double, space::axisymmetric, shape::linear, transfer::flip, scheme::usf, impact>()), 8 * (4 + 6 + 2 + 3 + 1 + 2) + 4u);
  // the same by default (APIC) and in single precision
  EXPECT_EQ((bytes<double, space::axisymmetric, quadratic, transfer::apic, scheme::usf, impact>()), 8 * (18 + 4) + 4u);
  EXPECT_EQ((bytes<float, space::axisymmetric, quadratic, transfer::apic, scheme::usf, impact>()), 4 * (18 + 4) + 4u);
  // XPIC(2): residual and loss; softening: lost capacity and held tension
  EXPECT_EQ((bytes<double, space::axisymmetric, shape::cubic_bspline, transfer::xpic<2>, scheme::usl, softening>()), 8 * (18 + 3 + 2) + 4u);
  // damage
  EXPECT_EQ((bytes<double, space::axisymmetric, shape::linear, transfer::pic, scheme::usf, damage>()), 8 * (18 + 1) + 4u);
}

} // namespace
} // namespace bolide
