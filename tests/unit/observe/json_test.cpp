// SPDX-License-Identifier: MIT
#include "bolide/observe/json.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace bolide::observe {
namespace {

TEST(json, plain_values) {
  EXPECT_EQ(json_value().text(), "null");
  EXPECT_EQ(json_value(true).text(), "true");
  EXPECT_EQ(json_value(false).text(), "false");
  EXPECT_EQ(json_value(-3).text(), "-3");
  EXPECT_EQ(json_value(std::uint64_t(18446744073709551615u)).text(), "18446744073709551615");
  EXPECT_EQ(json_value(0.1).text(), "0.1");
  EXPECT_EQ(json_value(1.0f).text(), "1");
  EXPECT_EQ(json_value(std::numeric_limits<double>::quiet_NaN()).text(), "null");
  EXPECT_EQ(json_value(-std::numeric_limits<double>::infinity()).text(), "null");
  EXPECT_EQ(std::strtod(json_value(1.0 / 3).text().c_str(), nullptr), 1.0 / 3);
}

TEST(json, text_is_escaped) {
  EXPECT_EQ(json_value("a \"b\" \\ c\n\x01").text(), "\"a \\\"b\\\" \\\\ c\\u000a\\u0001\"");
  EXPECT_EQ(json_value(std::string("\u00b5s")).text(), "\"\u00b5s\"");
}

TEST(json, objects_keep_their_order_and_lists_their_shape) {
  json_value j;
  j["b"] = 1;
  j["a"]["inner"] = "x";
  j["b"] = 2.5;
  j["list"] = std::vector{1, 2, 3};
  j["none"] = std::vector<double>{};
  json_value row;
  row["n"] = 1;
  j["rows"].push_back(row);
  EXPECT_EQ(j.text(), "{\n  \"b\": 2.5,\n  \"a\": {\n    \"inner\": \"x\"\n  },\n  \"list\": [1, 2, 3],\n  \"none\": [],\n  \"rows\": [\n    {\n      \"n\": 1\n    }\n  ]\n}");
}

TEST(json, merge_adds_and_replaces) {
  json_value j, more;
  j["a"] = 1, j["b"] = 2, more["b"] = 3, more["c"] = true;
  j.merge(more);
  j.merge(json_value());
  EXPECT_EQ(j.text(), "{\n  \"a\": 1,\n  \"b\": 3,\n  \"c\": true\n}");
}

} // namespace
} // namespace bolide::observe
