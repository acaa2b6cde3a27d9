// SPDX-License-Identifier: MIT
// Shared by the conformance tests: the whole table is the message where a report is not as expected.
#pragma once

#include "bolide/conformance/report.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace bolide::test {

inline void expect_passed(const conformance::report& r) { EXPECT_TRUE(r.passed()) << r; }

inline std::set<std::string> failed_checks(const conformance::report& r) {
  std::set<std::string> failed;
  for (const auto& f : r.findings)
    if (f.result == conformance::outcome::failed) failed.insert(f.check);
  return failed;
}
/// These checks fail, and no other.
inline void expect_fails(const conformance::report& r, const std::set<std::string>& checks) {
  EXPECT_FALSE(r.passed());
  EXPECT_EQ(failed_checks(r), checks) << r;
}

} // namespace bolide::test
