// SPDX-License-Identifier: MIT
// The advisor on a table made up for it, whose answers are known by arithmetic; its refusals; reading CSV.
#include "bolide/advise/advisor.hpp"
#include "bolide/core/math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace bolide::advise {
namespace {

const method cheap{"linear", "flip", "usf", "double"}, good{"bspline", "apic", "usf", "double"}, best{"cubic", "apic", "usf", "double"};

/// Error c/cells^order, cost k cells^3, on cells of 8 to 64.
void add(table& t, const std::string& problem, const std::string& kind, const method& how, double c, double order, double k, double extent = 1, double duration = 1) {
  for (const double cells : {8.0, 16.0, 32.0, 64.0}) {
    row r{.problem = problem, .kind = kind, .extent = extent, .duration = duration, .how = how, .cells = cells, .error = c / std::pow(cells, order), .cost = k * cells * cells * cells};
    r.repeats = 3, r.steps = 100, r.particles = 1000, r.particle_steps = 1e5;
    t.rows.push_back(r);
  }
}
/// Two problems of one kind, the second 1.5 times as hard; `cheap` does not converge below 4 %.
table made_up() {
  table t{{}, "made up"};
  add(t, "easy", "wave", cheap, 0.04, 0, 1e-6);
  add(t, "easy", "wave", good, 0.8, 1, 2e-6);
  add(t, "easy", "wave", best, 6.4, 2, 4e-6);
  add(t, "hard", "wave", cheap, 0.06, 0, 1e-6);
  add(t, "hard", "wave", good, 1.2, 1, 2e-6);
  add(t, "hard", "wave", best, 9.6, 2, 4e-6);
  return t;
}
const scene same{.kind = "wave", .extent = 1, .duration = 1};
const double between = std::sqrt(1.5); // the geometric mean of the two problems over the easier one
const double s = std::log(1.5) / std::sqrt(2.0) * std::sqrt(1.5); // standard deviation of two logarithms ln 1.5 apart, of a third one's distance from their mean

/// cells is the first resolution with whole particles at which c/cells^order falls to `error`: less than a sixth (or one particle) too fine.
void just_fine_enough(const advice& a, double c, double order, double error) {
  const double exact = std::pow(c / error, 1 / order);
  EXPECT_GE(a.cells, exact * (1 - 1e-9));
  EXPECT_LE(a.cells, std::max(exact * 7.0 / 6 + 0.5, exact + 0.5));
  EXPECT_NEAR(a.cells * a.how.per_axis, std::round(a.cells * a.how.per_axis), 1e-9);
  EXPECT_NEAR(a.error, c / std::pow(a.cells, order), 1e-9);
}

TEST(Advisor, TakesTheCheapestThatReaches) {
  const advisor ask(made_up());
  const auto rough = ask.for_accuracy(same, 0.0491, 0.5); // `cheap` on 8 cells: 4.90 %
  EXPECT_EQ(rough.how, cheap);
  EXPECT_EQ(rough.cells, 8);
  EXPECT_NEAR(rough.cost, 1e-6 * 512, 1e-12);
  EXPECT_NE(ask.for_accuracy(same, 0.0489, 0.5).how, cheap);
  const auto fine = ask.for_accuracy(same, 0.02, 0.5); // good on 49 cells: 0.24 s; best on 20: 0.03 s
  EXPECT_EQ(fine.how, best);
  just_fine_enough(fine, 6.4 * between, 2, 0.02);
  EXPECT_NEAR(fine.cost, 4e-6 * std::pow(fine.cells, 3), 1e-9);
  EXPECT_TRUE(fine.reaches);
  EXPECT_FALSE(fine.beyond);
  EXPECT_NE(fine.why.find("the cheapest of 2 methods, of 3, that reach 2 % with 50 % confidence, by the 2 problems of kind wave: easy "), std::string::npos) << fine.why;
}

TEST(Advisor, GoesTwiceAsFineByTheOrderAndNoFurther) {
  const advisor ask(made_up());
  const auto finer = ask.for_accuracy(same, 0.001, 0.5);
  EXPECT_EQ(finer.how, best);
  just_fine_enough(finer, 6.4 * between, 2, 0.001); // 88.5 cells
  EXPECT_NEAR(finer.cost, 4e-6 * std::pow(finer.cells, 3), 1e-6);
  EXPECT_TRUE(finer.beyond && finer.reaches);
  const auto too_fine = ask.for_accuracy(same, 1e-4);
  EXPECT_FALSE(too_fine.reaches);
  EXPECT_EQ(too_fine.cells, 128);
  EXPECT_LT(too_fine.sure, 0.02);
  EXPECT_NE(too_fine.why.find("none of 3 methods reaches 0.01 %"), std::string::npos) << too_fine.why;
}

TEST(Advisor, IsAsSureAsTheProblemsAgree) {
  const advisor ask(made_up());
  EXPECT_NEAR(ask.scatter("wave"), std::log(1.5) / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(ask.exponent("wave"), 0); // both problems have strength 1
  const auto a = ask.for_accuracy(same, 0.02);
  EXPECT_NEAR(a.sure, 0.5 * std::erfc(-std::log(0.02 / a.error) / s / std::sqrt(2.0)), 1e-12);
  EXPECT_GE(a.sure, advisor::usual_confidence);
  just_fine_enough(a, 6.4 * between, 2, 0.02 / std::exp(0.8416212 * s)); // the normal distribution has 80 % below 0.84 deviations
  EXPECT_GT(ask.for_accuracy(same, 0.02, 0.95).cells, a.cells);
  // alone, a problem says nothing of its scatter: that of all kinds
  auto t = made_up();
  add(t, "lonely", "shock", good, 1, 1, 1e-6);
  EXPECT_EQ(advisor(t).scatter("shock"), ask.scatter("wave"));
}

TEST(Advisor, DoesNotBelieveInLuck) {
  table t{{}, "made up"};
  add(t, "one", "wave", good, 0.8, 1, 2e-6);
  t.rows.front().error = 1e-4; // on 8 cells, where 16 have 5 %
  const advisor ask(t);
  EXPECT_EQ(ask.for_accuracy(same, 0.0501, 0.5).cells, 8);
  EXPECT_NEAR(ask.for_accuracy(same, 0.0501, 0.5).error, 0.05, 1e-12);
  EXPECT_GT(ask.for_accuracy(same, 0.04, 0.5).cells, 16);
}

TEST(Advisor, TakesThePowerOfTheStrengthOut) {
  auto t = made_up(); // errors of "hard" are 1.5 times those of "easy": at twice the strength that is a power of log2(1.5), and no scatter
  for (row& r : t.rows) r.strength = r.problem == "hard" ? 2 : 1;
  const advisor ask(t);
  EXPECT_NEAR(ask.exponent("wave"), std::log2(1.5), 1e-12);
  EXPECT_EQ(ask.scatter("wave"), 0.1); // the least
  scene middle = same;
  middle.strength = std::sqrt(2.0);
  EXPECT_NEAR(ask.for_accuracy(middle, 0.02, 0.5).error * square(ask.for_accuracy(middle, 0.02, 0.5).cells), 6.4 * between, 1e-9);
  scene weak = same, far = same; // no further than 1.5 times beyond what was measured
  weak.strength = 1 / 1.5, far.strength = 0.01;
  EXPECT_EQ(ask.for_accuracy(far, 0.02).cells, ask.for_accuracy(weak, 0.02).cells);
  EXPECT_THROW((void)ask.for_accuracy({.kind = "wave", .extent = 1, .duration = 1, .strength = 0}, 0.1), bad_parameter);
}

TEST(Advisor, CarriesCostToAnotherScene) {
  const advisor ask(made_up());
  const auto one = ask.for_accuracy(same, 0.02), large = ask.for_accuracy({.kind = "wave", .extent = 3, .duration = 2}, 0.02);
  EXPECT_NEAR(large.cost / one.cost, 6, 1e-9);
  EXPECT_EQ(large.cells, one.cells);
  // a tube: 4 extent cells particles in place of extent cells^2
  const auto tube = ask.for_accuracy({.kind = "wave", .extent = 1, .duration = 1, .tube = true}, 0.02);
  EXPECT_NEAR(tube.cost / one.cost, 4 / one.cells, 1e-9);
}

TEST(Advisor, FillsABudget) {
  const advisor ask(made_up());
  const auto a = ask.for_budget(same, 0.2); // best: no more than (0.2/4e-6)^(1/3) = 36.8 cells
  EXPECT_EQ(a.how, best);
  EXPECT_LE(a.cells, std::cbrt(0.2 / 4e-6));
  EXPECT_GE(a.cells, std::cbrt(0.2 / 4e-6) * 6 / 7 - 0.5);
  EXPECT_NEAR(a.error, 6.4 * between / a.cells / a.cells, 1e-9);
  EXPECT_LE(a.cost, 0.2 * (1 + 1e-9));
  const auto poor = ask.for_budget(same, 1e-5);
  EXPECT_FALSE(poor.reaches);
  EXPECT_EQ(poor.how, cheap);
}

TEST(Advisor, FrontAndPresetsAreOfTheTable) {
  const advisor ask(made_up());
  const auto front = ask.front(same);
  ASSERT_GE(front.size(), 4u);
  for (std::size_t k = 1; k < front.size(); ++k) {
    EXPECT_GT(front[k].cost, front[k - 1].cost);
    EXPECT_LT(front[k].error, front[k - 1].error);
  }
  EXPECT_EQ(ask.preset(same, "reference").cells, 64);
  EXPECT_EQ(ask.preset(same, "reference").how, best);
  EXPECT_EQ(ask.preset(same, "standard").how, ask.for_accuracy(same, 0.02).how);
  EXPECT_EQ(ask.preset(same, "draft").cells, ask.for_accuracy(same, 0.05).cells);
  EXPECT_THROW((void)ask.preset(same, "fast"), bad_parameter);
}

/// Far out of reach the probability of reaching it is highest for the method that scatters most: it used to be named the nearest.
TEST(Advisor, TheNearestIsTheMostAccurateNotTheLeastCertain) {
  const method erratic{"gimp", "flip", "usf", "double"};
  auto t = made_up();
  add(t, "easy", "wave", erratic, 0.004, 0, 1e-6);
  add(t, "hard", "wave", erratic, 0.4, 0, 1e-6);
  const auto nearest = advisor(t).for_accuracy(same, 1e-9);
  EXPECT_FALSE(nearest.reaches);
  EXPECT_EQ(nearest.how, best);
  EXPECT_EQ(nearest.cells, 128);
}

TEST(Advisor, OffersOnlyWhatCanBeComposed) {
  advisor ask(made_up());
  ask.offer([](const method& m) { return m.shape != "cubic"; });
  EXPECT_EQ(ask.for_accuracy(same, 0.02).how, good);
  EXPECT_THROW(ask.offer([](const method&) { return false; }), bad_parameter);
}

TEST(Advisor, RefusesWithASentence) {
  const advisor ask(made_up());
  const auto message = [&](auto&& call) -> std::string {
    try {
      (void)call();
    } catch (const bad_parameter& e) { return e.what(); }
    return "";
  };
  EXPECT_EQ(message([&] { return ask.for_accuracy({.kind = "shock", .extent = 1, .duration = 1}, 0.01); }), "kind of the scene = 'shock': was not measured; there are wave");
  EXPECT_NE(message([&] { return ask.for_accuracy(same, 0); }).find("accuracy = 0: must be more than 0"), std::string::npos);
  EXPECT_NE(message([&] { return ask.for_accuracy(same, 1); }).find("accuracy"), std::string::npos);
  EXPECT_NE(message([&] { return ask.for_budget(same, -1); }).find("budget = -1 s"), std::string::npos);
  EXPECT_NE(message([&] { return ask.for_budget(same, std::nan("")); }).find("budget"), std::string::npos);
  EXPECT_NE(message([&] { return ask.for_accuracy({.kind = "wave", .extent = 0, .duration = 1}, 0.1); }).find("extent"), std::string::npos);
  auto twice = made_up();
  twice.rows.push_back(twice.rows.front());
  EXPECT_NE(message([&] { return advisor(twice); }).find("rows of cells = 8: must be one"), std::string::npos);
}

/// The text of a CSV file with one row that `change` may spoil.
template <class F> std::string csv(F&& change) {
  std::vector<std::string> cells = {"bar, long", "plasticity", "6.7", "95", "0", "bspline", "flip", "usf", "double", "2", "0.4", "0", "1", "8", "0.004", "0.28", "0.01", "3", "1200", "4000", "5e6", "0.7"};
  change(cells);
  std::string text;
  for (const char* name : column_names) text += std::string(text.empty() ? "" : ",") + name;
  text += "\n";
  for (std::size_t k = 0; k < cells.size(); ++k) text += (k ? "," : "") + (cells[k].find(',') == std::string::npos ? cells[k] : "\"" + cells[k] + "\"");
  return text + "\r\n";
}

TEST(AdviseTable, ReadsWhatTheExampleWrites) {
  const auto t = parse_table(csv([](auto&) {}), "own.csv");
  ASSERT_EQ(t.rows.size(), 1u);
  const row& r = t.rows.front();
  EXPECT_EQ(r.problem, "bar, long");
  EXPECT_EQ(name(r.how), "bspline flip usf double, 2 per axis, CFL 0.4");
  EXPECT_EQ(r.cells, 8);
  EXPECT_EQ(r.error, 0.004);
  EXPECT_EQ(r.steps, 1200);
  EXPECT_EQ(r.strength, 0.7);
  EXPECT_TRUE(r.skip && !r.tube);
  const std::string path = testing::TempDir() + "bolide_advise.csv";
  std::ofstream(path) << csv([](auto&) {});
  EXPECT_EQ(read_table(path).rows.size(), 1u);
}

TEST(AdviseTable, RefusesBadFiles) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      (void)parse_table(text, "own.csv");
    } catch (const bad_parameter& e) { return e.what(); }
    return "";
  };
  EXPECT_NE(message("").find("'own.csv': is empty"), std::string::npos);
  EXPECT_NE(message("a,b\n1,2\n").find("has no column \"problem\""), std::string::npos);
  EXPECT_NE(message(csv([](auto& c) { c[14] = "small"; })).find("'own.csv' line 2, error (1): expected a number, found 'small'"), std::string::npos);
  EXPECT_NE(message(csv([](auto& c) { c[14] = "-1"; })).find("error = -1: must be positive"), std::string::npos);
  EXPECT_NE(message(csv([](auto& c) { c.pop_back(); })).find("has 21 cells, the header 22"), std::string::npos);
  EXPECT_NE(message(csv([](auto& c) { c[9] = "40"; })).find("per_axis = 40: must be 1 to 16"), std::string::npos);
  const std::string whole = csv([](auto&) {});
  EXPECT_NE(message(whole.substr(0, whole.find('\n') + 1)).find("rows of 'own.csv' = 0"), std::string::npos);
  EXPECT_THROW((void)read_table("no/such/file.csv"), bad_parameter);
}

} // namespace
} // namespace bolide::advise
