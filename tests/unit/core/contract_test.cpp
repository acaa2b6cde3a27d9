// SPDX-License-Identifier: MIT
// require() lets good values pass and answers bad ones with name, value, bound and unit.
#include "bolide/core/contract.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace {

std::string refusal(double value) {
  try {
    bolide::require(value > 0, "density", value, "above 0", "kg/m3");
  } catch (const bolide::bad_parameter& refused) { return refused.what(); }
  return "";
}

TEST(Contract, GoodValuePasses) { EXPECT_EQ(refusal(2785), ""); }

TEST(Contract, RefusalNamesValueBoundAndUnit) {
  EXPECT_EQ(refusal(-1.5), "density = -1.5 kg/m3: must be above 0 (unit: kg/m3)");
}

TEST(Contract, NotANumberIsRefused) {
  EXPECT_EQ(refusal(std::numeric_limits<double>::quiet_NaN()), "density = nan kg/m3: must be above 0 (unit: kg/m3)");
}

TEST(Contract, UnitMayBeLeftOut) {
  try {
    bolide::require(false, "cfl", 2, "in (0, 1]");
    FAIL();
  } catch (const std::invalid_argument& refused) { EXPECT_STREQ(refused.what(), "cfl = 2: must be in (0, 1]"); }
}

TEST(Contract, TextReadsBackAsTheSameNumber) {
  for (const double x : {0.1, 1.0 / 3.0, 6.6e-6, -2785.0, 5e-324, 1.7976931348623157e308}) EXPECT_EQ(std::strtod(bolide::to_text(x).c_str(), nullptr), x);
}

} // namespace
