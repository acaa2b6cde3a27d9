// SPDX-License-Identifier: MIT
// Words, lines and numbers of a text file, and where a refusal says it happened.
#include "bolide/core/text_input.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {
using namespace bolide;

TEST(TextInput, Numbers) {
  double x = 0;
  const auto read = [&](const char* word) { return text::parse_number(word, x) ? x : -999.0; };
  EXPECT_EQ(read("1.5"), 1.5);
  EXPECT_EQ(read("+1.5e3"), 1500);
  EXPECT_EQ(read("-.5"), -0.5);
  EXPECT_EQ(read("1.5D-03"), 1.5e-3);
  EXPECT_EQ(read("2d0"), 2);
  EXPECT_EQ(read("1e-400"), 0); // too small for a double is 0
  for (const char* bad : {"", "+", "-", "+-1", "nan", "inf", "1e400", "1.5x", "0x10", "1,5", "e5", "1e", "abc"}) EXPECT_EQ(read(bad), -999) << bad;
  EXPECT_EQ(read(std::string(200, '1').c_str()), -999);
}

TEST(TextInput, WordsAndLines) {
  text::cursor at("one  two\r\n\n\tthree four\nfive", "f.txt");
  EXPECT_EQ(at.next_word_of_line(), "one");
  EXPECT_EQ(at.next_word_of_line(), "two");
  EXPECT_EQ(at.next_word_of_line(), "");
  EXPECT_EQ(at.line(), 1u);
  EXPECT_EQ(at.next_word(), "three");
  EXPECT_EQ(at.line(), 3u);
  std::string_view rest;
  EXPECT_TRUE(at.next_line(rest));
  EXPECT_EQ(rest, " four");
  EXPECT_TRUE(at.next_line(rest));
  EXPECT_EQ(rest, "five");
  EXPECT_FALSE(at.next_line(rest));
  EXPECT_EQ(at.next_word(), "");
  try {
    at.refuse("expected more");
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "f.txt line 4: expected more");
  }
}

TEST(TextInput, ShowsOddWordsSafely) {
  EXPECT_EQ(text::shown("\x01" "xy\xff"), "'?xy?'");
  EXPECT_EQ(text::shown(std::string(50, 'a')), "'" + std::string(40, 'a') + "...'");
}

TEST(TextInput, FilesThatCannotBeRead) {
  for (const char* path : {"/no/such/file", "/tmp", ""}) {
    try {
      text::read_file(path);
      ADD_FAILURE() << path;
    } catch (const bad_parameter& e) {
      EXPECT_NE(std::string(e.what()).find("file '" + std::string(path) + "': cannot be "), std::string::npos) << e.what();
    }
  }
}
} // namespace
