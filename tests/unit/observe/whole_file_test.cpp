// SPDX-License-Identifier: MIT
#include "bolide/observe/whole_file.hpp"

#include "test_folder.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

TEST(whole_file, makes_folders_and_replaces) {
  const test::folder f("whole_file");
  const auto path = f.path / "a" / "b" / "file.txt";
  write_whole_file(path, "one");
  write_whole_file(path, "two");
  EXPECT_EQ(test::bytes_of(path), "two");
  EXPECT_FALSE(std::filesystem::exists(aside(path)));
}

TEST(whole_file, failure_is_a_sentence_and_keeps_the_old_file) {
  const test::folder f("whole_file_failure");
  const auto path = f.path / "file.txt";
  write_whole_file(path, "old");
  std::filesystem::create_directory(aside(path)); // no file can be opened under that name
  try {
    write_whole_file(path, "new");
    FAIL() << "no exception";
  } catch (const output_error& e) {
    EXPECT_EQ(std::string(e.what()).find("cannot write " + path.string() + ": "), 0u) << e.what();
  }
  EXPECT_EQ(test::bytes_of(path), "old");
  EXPECT_THROW(write_whole_file(path / "below_a_file" / "x", ""), output_error);
}

} // namespace
} // namespace bolide::observe
