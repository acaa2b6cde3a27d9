// SPDX-License-Identifier: MIT
// The named materials: every set composes into models that accept it, its numbers agree with one another, names are unique.
#include "bolide/eos/state.hpp"
#include "bolide/material/data/library.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace bolide;

class ParameterSet : public ::testing::TestWithParam<data::parameter_set> {};

TEST_P(ParameterSet, ModelsAcceptIt) {
  const auto& m = GetParam();
  EXPECT_NO_THROW(eos::mie_grueneisen{m.mie_grueneisen});
  EXPECT_NO_THROW(m.strength.validate());
  EXPECT_NO_THROW(m.melting.validate());
  if (m.tillotson) { EXPECT_NO_THROW(eos::tillotson{*m.tillotson}); }
  if (m.phases) { EXPECT_NO_THROW(m.phases->validate()); }
  EXPECT_GT(m.heat_capacity, 100);
  EXPECT_LT(m.heat_capacity, 1000);
  EXPECT_FALSE(m.source.empty());
}

TEST_P(ParameterSet, NumbersAgreeWithOneAnother) {
  const auto& m = GetParam();
  EXPECT_TRUE(m.mie_grueneisen.constant_gamma); // scenes expand
  EXPECT_NEAR(m.mie_grueneisen.rho0, m.density, 0.01 * m.density);
  const double bulk = m.density * m.mie_grueneisen.c0 * m.mie_grueneisen.c0;
  EXPECT_LT(m.strength.shear_modulus, bulk); // Poisson's ratio above 0.13
  EXPECT_LT(m.strength.a, 0.05 * m.strength.shear_modulus);
  if (m.tillotson) {
    // two fits of one metal: the bulk modulus within 15 %; iron's us-up line is that of its high-pressure phase, softer at zero pressure
    const double bound = m.name == "iron" ? 0.3 : 0.15;
    const double c2 = eos::cold_state(eos::tillotson{*m.tillotson}).sound_speed;
    EXPECT_NEAR(m.tillotson->rho0 * c2 * c2, bulk, bound * bulk);
    EXPECT_NEAR(m.tillotson->rho0, m.density, 0.04 * m.density);
  }
}

INSTANTIATE_TEST_SUITE_P(Library, ParameterSet, ::testing::ValuesIn(data::library),
                         [](const auto& at) { return std::string(at.param.name); });

TEST(MaterialLibrary, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const auto& m : data::library) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_EQ(data::find(m.name).name, m.name);
  }
}

TEST(MaterialLibrary, UnknownNameIsRefusedWithTheListOfNames) {
  try {
    data::find("unobtainium", "projectile");
    FAIL();
  } catch (const bad_parameter& e) {
    const std::string text = e.what();
    for (const char* part : {"projectile", "unobtainium", "aluminium_6061", "tungsten"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}
