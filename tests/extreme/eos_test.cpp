// SPDX-License-Identifier: MIT
// Extreme 9: equations of state alone, rho/rho0 from 1e-6 to 5 and e from -1 to 1e4 MJ/kg: pressure, temperature and sound speed finite
// everywhere; where c^2 is not positive, a material's floor acts and counts. Jumps at phase borders: tests/unit/eos,
// tests/unit/conformance.
#include "verify/table.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bolide {
namespace {

template <class T, class Eos> void sweep(const std::string& name, const Eos& eos) {
  long total = 0, bad = 0, slow = 0;
  for (int i = 0; i <= 160; ++i) {
    const double x = i <= 100 ? std::pow(10, -6 + 0.06 * i) : 1 + (i - 100) / 15.0; // 1e-6 .. 1 .. 5
    for (int j = -40; j <= 120; ++j) {
      const double e = j <= 0 ? 25e3 * j : std::pow(10, 2 + j / 15.0); // -1 MJ/kg .. 0, 126 J/kg .. 1e10 J/kg
      const auto s = detail::evaluate_all(eos, static_cast<T>(x * eos.reference_density()), static_cast<T>(e));
      ++total;
      const bool good = std::isfinite(s.pressure) && std::isfinite(s.sound_speed_squared) && std::isfinite(s.temperature);
      if (!good && ++bad < 4)
        ADD_FAILURE() << name << " at rho/rho0 " << x << ", e " << e << ": p " << s.pressure << ", c2 " << s.sound_speed_squared << ", T "
                      << s.temperature;
      if (good && !(s.sound_speed_squared > 0)) ++slow;
    }
  }
  const auto row = [&](const char* measure, double value, double bound, const char* note) {
    verify::record({.section = "extremes",
                    .problem = "equation of state alone, rho/rho0 1e-6 to 5, e -1 to 1e4 MJ/kg",
                    .composition = name,
                    .measure = measure,
                    .value = value,
                    .bound = bound,
                    .note = note});
  };
  row("states without finite p, c^2, T, of 25,921", static_cast<double>(bad), 0, "");
  row("share of states with c^2 <= 0", static_cast<double>(slow) / static_cast<double>(total), verify::none,
      "tension and e < 0 in expansion, where material separates: the material's floor acts and counts");
  EXPECT_EQ(bad, 0);
}
template <class Eos> void both(const std::string& name, const Eos& eos) {
  sweep<double>(name + ", double", eos);
  sweep<float>(name + ", float", eos);
}

TEST(EosAlone, MieGrueneisen) {
  both("Mie-Grueneisen", eos::isentrope_temperature{eos::mie_grueneisen{}});
  both("Mie-Grueneisen, constant gamma in expansion", eos::isentrope_temperature{eos::mie_grueneisen{{.constant_gamma = true}}});
  both("Mie-Grueneisen, fading in expansion", eos::mie_grueneisen{{.fading_expansion = true}});
}
TEST(EosAlone, Tillotson) { both("Tillotson", eos::tillotson{}); }
TEST(EosAlone, PaperAndMixed) {
  both("Grover, the paper's branches", eos::grover{cold::cai_ye{}, phase::paper{}});
  both("Grover, mixed branches", eos::grover{cold::cai_ye{}, phase::mixed{}});
}
TEST(EosAlone, Reference) { both("reference", eos::reference{}); }

} // namespace
} // namespace bolide
