// SPDX-License-Identifier: MIT
// The page of the verification table from a small input: counts, verdicts, order, notes, and what is no row.
#include "table/page.hpp"

#include "verify/table.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace bolide {
namespace {

std::string line(const verify::row& r) { // through the file that the tests append to
  const std::string file = testing::TempDir() + "bolide_table_" + std::to_string(getpid()) + ".jsonl";
  std::remove(file.c_str());
  setenv("BOLIDE_VERIFY_TABLE", file.c_str(), 1);
  testing::internal::CaptureStdout();
  verify::record(r);
  testing::internal::GetCapturedStdout();
  unsetenv("BOLIDE_VERIFY_TABLE");
  std::ifstream in(file);
  std::string text;
  std::getline(in, text);
  std::remove(file.c_str());
  return text + "\n";
}
std::string page(const std::vector<std::string>& lines) {
  std::string all;
  for (const auto& l : lines) all += l;
  std::istringstream in(all);
  return table::render(table::read_rows(in), {{"compiler", "some"}});
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::vector<std::string>& input() {
  static const std::vector<std::string> lines{
      line({.section = "shocks", .problem = "Sod", .composition = "B", .measure = "L1 of p, 400 cells", .value = 4.1e-3, .bound = 6e-3, .order = 0.9, .expected_order = 1, .seconds = 0.41}),
      line({.section = "shocks", .problem = "Sod", .composition = "A", .measure = "L1 of p, 400 cells", .value = -0.07, .bound = 0.06, .note = "it \"drifts\" | so"}),
      line({.section = "shocks", .problem = "Sod", .composition = "A", .measure = "L1 of p, 50 cells", .value = 0.2}),
      line({.section = "shocks", .problem = "Noh", .composition = "A", .measure = "order", .value = 1, .order = 0.7, .expected_order = 1, .note = "wall heating"}),
      line({.section = "smooth", .problem = "bar", .composition = "A", .measure = "period", .value = 1e-4, .bound = 1e-3, .unit = "s"}),
      line({.section = "zoo", .problem = "p", .composition = "A", .measure = "m", .value = verify::none}),
  };
  return lines;
}

TEST(VerificationPage, CountsWhatIsAskedAndWhatIsMissed) {
  const auto text = page(input());
  EXPECT_TRUE(holds(text, "**3 of 5 rows that something is asked of are missed**; 1 more are reported only."));
  EXPECT_TRUE(holds(text, "| [shocks](#shocks) | 4 | 1 | 2 | 1 | 0.41 |"));
  EXPECT_TRUE(holds(text, "- compiler: some\n"));
}
TEST(VerificationPage, SaysEachRow) {
  const auto text = page(input());
  EXPECT_TRUE(holds(text, "| B | L1 of p, 400 cells | 0.0041 | 0.006 | 0.90 (1) | 0.41 | met |"));
  EXPECT_TRUE(holds(text, "| A | L1 of p, 400 cells | -0.07 | 0.06 |  |  | **missed** [1] |"));
  EXPECT_TRUE(holds(text, "[1] it \"drifts\" | so\n"));
  EXPECT_TRUE(holds(text, "| A | period | 0.0001 s | 0.001 |  |  | met |"));
  EXPECT_TRUE(holds(text, "- shocks, Noh, A: order 1, order 0.70 (1). wall heating\n"));
  EXPECT_TRUE(holds(text, "- zoo, p, A: m none. No reason was stated.\n"));
}
TEST(VerificationPage, DoesNotDependOnWhichTestRanFirst) {
  auto lines = input();
  const auto text = page(lines);
  std::sort(lines.begin(), lines.end());
  do EXPECT_EQ(page(lines), text);
  while (std::next_permutation(lines.begin(), lines.end()));
  EXPECT_LT(text.find("## smooth"), text.find("## shocks"));
  EXPECT_LT(text.find("## shocks"), text.find("## zoo"));
  EXPECT_LT(text.find("50 cells"), text.find("| A | L1 of p, 400 cells"));
}
TEST(VerificationPage, ComparesNumbersByValue) {
  EXPECT_LT(table::compare("p, 50 cells", "p, 400 cells"), 0);
  EXPECT_GT(table::compare("p, 50 cells", "p, 49 cells"), 0);
  EXPECT_LT(table::compare("p", "p, 49 cells"), 0);
  EXPECT_EQ(table::compare("p 7", "p 7"), 0);
  EXPECT_LT(table::compare("a 007", "b 7"), 0);
}
TEST(VerificationPage, RefusesALineThatIsNoRow) {
  for (const std::string bad : {"not json\n", "{\"section\":\"shocks\"}\n"}) {
    std::istringstream in(input()[0] + bad);
    try {
      table::read_rows(in);
      FAIL() << bad;
    } catch (const std::runtime_error& e) { EXPECT_TRUE(holds(e.what(), "line 2 is no row")) << e.what(); }
  }
}

} // namespace
} // namespace bolide
