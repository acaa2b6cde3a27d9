// SPDX-License-Identifier: MIT
// How figures become findings, what a stated violation excuses and what not, and the printed table.
#include "bolide/conformance/difference.hpp"
#include "bolide/conformance/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace {
using namespace bolide;
using namespace bolide::conformance;

std::string where(double ratio, double) { return "x " + detail::short_text(ratio); }
finding judge(const std::vector<std::pair<double, double>>& figures, const std::vector<stated_violation>& stated = {}) {
  measure m("check", 1e-6, stated);
  for (const auto& [figure, ratio] : figures) m.add(figure, ratio);
  return m.close(where, "note");
}

TEST(Measure, TheWorstFigureIsJudged) {
  const finding good = judge({{1e-8, 1}, {5e-7, 2}, {1e-9, 3}}), bad = judge({{1e-8, 1}, {5e-6, 2}, {1e-9, 3}});
  EXPECT_EQ(good.result, outcome::passed);
  EXPECT_EQ(good.worst, 5e-7);
  EXPECT_EQ(good.where, "x 2");
  EXPECT_EQ(bad.result, outcome::failed);
  EXPECT_EQ(bad.worst, 5e-6);
  EXPECT_EQ(judge({}).result, outcome::not_applicable);
}

TEST(Measure, NaNIsTheWorst) {
  const finding f = judge({{1, 1}, {std::nan(""), 2}, {3, 3}});
  EXPECT_EQ(f.result, outcome::failed);
  EXPECT_TRUE(std::isinf(f.worst));
  EXPECT_EQ(f.where, "x 2");
}

TEST(StatedViolation, ExcusesItsCheckUpToItsSizeAndWithinItsRange) {
  const stated_violation here{"check", 0.1, "known", 1, 2};
  EXPECT_EQ(judge({{0.05, 1.5}}, {here}).result, outcome::stated);
  EXPECT_EQ(judge({{0.05, 1.5}}, {here}).note, "note; stated: known");
  EXPECT_EQ(judge({{0.05, 1.5}}, {here}).worst, 0.05);
  EXPECT_EQ(judge({{0.2, 1.5}}, {here}).result, outcome::failed) << "larger than stated";
  EXPECT_EQ(judge({{0.05, 3}}, {here}).result, outcome::failed) << "outside the range";
  EXPECT_EQ(judge({{0.05, 1.5}, {0.01, 3}}, {here}).result, outcome::failed) << "one excused, a smaller one not";
  EXPECT_EQ(judge({{0.05, 1.5}, {0.01, 3}}, {here}).worst, 0.01);
  EXPECT_EQ(judge({{0.05, 1.5}, {0.01, 3}}, {here, {"check", 0.02, "also"}}).result, outcome::stated) << "two statements";
  EXPECT_EQ(judge({{0.05, 1.5}}, {{"other", 0.1, "known"}}).result, outcome::failed) << "of another check";
  EXPECT_EQ(judge({{1e-7, 1.5}}, {here}).note, "note; not seen, though stated: known");
  EXPECT_EQ(judge({{std::nan(""), 1.5}}, {here}).result, outcome::failed) << "NaN";
}

TEST(StatedViolation, OfACheckThatDoesNotExistIsRefused) {
  report r{"model", {judge({})}};
  EXPECT_NO_THROW(require_known_checks(r, {{"check", 1, ""}}));
  EXPECT_THROW(require_known_checks(r, {{"chek", 1, ""}}), bad_parameter);
  EXPECT_THROW(r.at("nothing"), bad_parameter);
}

TEST(Report, PrintsATable) {
  report r{"my model", {judge({{2e-7, 0.5}}), judge({{1, 0.25}}), judge({})}};
  EXPECT_FALSE(r.passed());
  std::ostringstream text;
  text << r;
  EXPECT_EQ(text.str(), "conformance of my model\n"
                        "check  result          worst      bound      where\n"
                        "check  passed          2e-07      1e-06      x 0.5   note\n"
                        "check  FAILED          1          1e-06      x 0.25  note\n"
                        "check  not applicable                                note\n"
                        "FAILED: 3 checks, 1 failed\n");
  r.findings.erase(r.findings.begin() + 1);
  EXPECT_TRUE(r.passed());
}

TEST(DerivativeError, FindsTheDerivativeOfASmoothFunction) {
  const auto f = [](double s) { return std::exp(3 * s); };
  const auto right = derivative_error(f, 3, {1e-2, 1e-3}, 0), wrong = derivative_error(f, 3.003, {1e-2, 1e-3, 1e-4}, 0);
  EXPECT_LT(right.error, 1e-11);
  EXPECT_FALSE(right.one_sided);
  EXPECT_NEAR(wrong.error, 3e-3, 1e-8);
}

TEST(DerivativeError, OneSideOfAKinkOrAJumpIsEnough) {
  for (const double border : {-0.3e-4, 0.0, 2e-4, 5e-3}) {
    const auto kink = [&](double s) { return s < border ? 2 * s + s * s : 7 * s + s * s - 5 * border; };
    const double slope = 0 < border ? 2 : 7, other = 0 < border ? 7 : 2;
    EXPECT_LT(derivative_error(kink, slope, {1e-2, 1e-3, 1e-4}, 1e-9).error, 1e-9) << border;
    const auto jump = [&](double s) { return kink(s) + (s < border ? 0 : 1); };
    EXPECT_LT(derivative_error(jump, slope, {1e-2, 1e-3, 1e-4}, 1e-9).error, 1e-9) << border;
    if (border == 5e-3) {
      EXPECT_GT(derivative_error(kink, other, {1e-3, 1e-4}, 1e-9).error, 1) << "the slope beyond the border";
    }
    EXPECT_GT(derivative_error(kink, 4, {1e-3, 1e-4}, 1e-9).error, 0.1) << "neither slope";
  }
}

TEST(DerivativeError, NaNEverywhereIsNaN) {
  EXPECT_TRUE(std::isnan(derivative_error([](double) { return std::nan(""); }, 1, {1e-2}, 0).error));
}

TEST(FindJump, FindsAJumpInASteepCurveAndNothingInASmoothOne) {
  for (const double border : {1.0003, 1.5, 1.77, 1.99999})
    for (const double size : {1.0, -1.0, 0.05, -0.05, 1e-3, -1e-5}) {
      const auto f = [&](double x) { return 5 * std::pow(x, 3) + (x < border ? 0 : size); };
      const jump j = find_jump(f, 1, 2, 1e-6);
      EXPECT_NEAR(j.size, std::abs(size), 1e-9) << border;
      EXPECT_NEAR(j.at, border, 1e-12);
    }
  EXPECT_EQ(find_jump([](double x) { return std::exp(5 * x); }, 1, 2, 1e-6).size, 0);
  EXPECT_EQ(find_jump([](double x) { return std::abs(x - 1.234); }, 1, 2, 1e-6).size, 0) << "a kink is no jump";
}

TEST(FindJump, AtZero) {
  const jump j = find_jump([](double x) { return x < 0 ? 0.0 : 2.0; }, -1, 3, 1e-6);
  EXPECT_EQ(j.size, 2);
  EXPECT_NEAR(j.at, 0, 1e-14);
}
} // namespace
