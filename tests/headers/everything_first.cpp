// SPDX-License-Identifier: MIT
// With everything_second.cpp: two translation units that include every header link into one program.
#include "everything.hpp"

#include <gtest/gtest.h>

double second_unit();

TEST(Headers, TwoUnitsThatIncludeEverythingLink) { EXPECT_EQ(second_unit(), 9.5e-3); }
