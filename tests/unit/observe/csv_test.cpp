// SPDX-License-Identifier: MIT
#include "bolide/observe/csv.hpp"

#include "test_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bolide::observe {
namespace {

TEST(csv, rows_are_whole_at_any_moment) {
  const test::folder f("csv");
  const auto path = f.path / "sub" / "history.csv";
  csv_table table(path, {"time (s)", "step", "cause"});
  EXPECT_EQ(test::bytes_of(path), "time (s),step,cause\n");
  table.row({0.5, 3, "sound"});
  EXPECT_EQ(test::bytes_of(path), "time (s),step,cause\n0.5,3,sound\n") << "while the table is open";
  EXPECT_EQ(table.rows(), 1u);
}

TEST(csv, doubles_read_back_the_same) {
  for (const double x : {1.0 / 3, 6.02214076e23, -1e-308, 0.1, 3.0000000000000004})
    EXPECT_EQ(std::strtod(csv_cell(x).text().c_str(), nullptr), x);
  EXPECT_EQ(csv_cell(0.1f).text(), csv_cell(double(0.1f)).text());
  EXPECT_EQ(csv_cell(std::size_t(18000000000000000000u)).text(), "18000000000000000000");
  EXPECT_EQ(csv_cell(std::nan("")).text(), "nan");
}

TEST(csv, text_is_quoted_where_it_must_be) {
  EXPECT_EQ(csv_cell("plain").text(), "plain");
  EXPECT_EQ(csv_cell("a,b").text(), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"a\"").text(), "\"say \"\"a\"\"\"");
}

TEST(csv, an_empty_first_cell_keeps_its_comma) {
  const test::folder f("csv_empty");
  csv_table table(f.path / "t.csv", {"a", "b"});
  table.row({"", ""});
  EXPECT_EQ(test::bytes_of(f.path / "t.csv"), "a,b\n,\n");
}

TEST(csv, refuses_another_number_of_cells) {
  const test::folder f("csv_count");
  csv_table table(f.path / "t.csv", {"a", "b"});
  try {
    table.row({1, 2, 3});
    FAIL() << "no exception";
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("cells in row 1"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("the 2 of its header"), std::string::npos) << e.what();
  }
  EXPECT_EQ(test::bytes_of(f.path / "t.csv"), "a,b\n");
  EXPECT_THROW(csv_table(f.path / "u.csv", {}), bad_parameter);
  EXPECT_THROW(csv_table(f.path, {"a"}), output_error) << "the path is a folder";
}

} // namespace
} // namespace bolide::observe
