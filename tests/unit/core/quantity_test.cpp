// SPDX-License-Identifier: MIT
// Command-line quantities: what is read, what is refused and in which words, and that what is written reads back exactly.
#include "bolide/core/quantity.hpp"

#include "bolide/core/unit.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace bolide;
using quantity::dimension;
using quantity::parse;

constexpr dimension all_dimensions[] = {dimension::length,      dimension::velocity, dimension::pressure,     dimension::time,
                                        dimension::temperature, dimension::density,  dimension::dimensionless};

std::string refusal(std::string_view text, dimension d, std::string_view name = {}) {
  try {
    const double value = parse(text, d, name);
    return "accepted as " + to_text(value);
  } catch (const bad_parameter& refused) { return refused.what(); }
}

TEST(Quantity, ReadsTheUnitsOfTheTrade) {
  EXPECT_EQ(parse("9.5mm", dimension::length), 9.5 * unit::mm);
  EXPECT_EQ(parse("6640m/s", dimension::velocity), 6640.0);
  EXPECT_EQ(parse("6.64km/s", dimension::velocity), 6.64 * 1e3);
  EXPECT_EQ(parse("6.64mm/us", dimension::velocity), 6.64 * 1e3);
  EXPECT_EQ(parse("1.5GPa", dimension::pressure), 1.5e9);
  EXPECT_EQ(parse("1.5Mbar", dimension::pressure), 1.5 * unit::Mbar);
  EXPECT_EQ(parse("6.6us", dimension::time), 6.6 * unit::us);
  EXPECT_EQ(parse("293K", dimension::temperature), 293.0);
  EXPECT_EQ(parse("2785kg/m3", dimension::density), 2785.0);
  EXPECT_EQ(parse("2.785g/cm3", dimension::density), 2.785 * 1e3);
  EXPECT_EQ(parse("0.3", dimension::dimensionless), 0.3);
}

TEST(Quantity, SignsExponentsAndBlanks) {
  EXPECT_EQ(parse(" 9.5 mm ", dimension::length), 9.5 * unit::mm);
  EXPECT_EQ(parse("+9.5mm", dimension::length), 9.5 * unit::mm);
  EXPECT_EQ(parse("-1e3m/s", dimension::velocity), -1000.0);
  EXPECT_EQ(parse("5e-5m", dimension::length), 5e-5);
  EXPECT_EQ(parse(".05mm", dimension::length), 0.05 * unit::mm);
  EXPECT_EQ(parse("0mm", dimension::length), 0.0);
}

TEST(Quantity, BareNumberIsRefusedWithTheListOfUnits) {
  EXPECT_EQ(refusal("9.5", dimension::length, "diameter"),
            "diameter = '9.5': has no unit; a length needs one of the units m km cm mm um nm (for example 9.5mm)");
  EXPECT_EQ(refusal("6640", dimension::velocity), "'6640': has no unit; a velocity needs one of the units m/s km/s mm/us cm/us (for example 6640m/s)");
  for (const auto d : all_dimensions) {
    if (d == dimension::dimensionless) continue;
    EXPECT_NE(refusal("0", d).find("has no unit"), std::string::npos);
    EXPECT_NE(refusal("0", d).find(quantity::units_of(d)), std::string::npos);
  }
}

TEST(Quantity, WrongUnitIsNamed) {
  EXPECT_EQ(refusal("9.5furlong", dimension::length),
            "'9.5furlong': unknown unit 'furlong'; a length needs one of the units m km cm mm um nm (for example 9.5mm)");
  EXPECT_NE(refusal("9.5us", dimension::length).find("'us' is a unit of a time"), std::string::npos);
  EXPECT_NE(refusal("1.5gpa", dimension::pressure).find("unknown unit 'gpa'"), std::string::npos); // mm is not MM
  EXPECT_EQ(refusal("0.3mm", dimension::dimensionless), "'0.3mm': 'mm' is a unit of a length; a plain number has no unit (for example 0.3)");
}

TEST(Quantity, WhatIsNoNumberIsRefused) {
  for (const auto* text : {"", " ", "mm", "-", "+", "+-3mm", "nan", "nanmm", "inf m", "-infm", "1e999m", "1e308km", "0x", "1,5mm", "--5mm"})
    EXPECT_EQ(refusal(text, dimension::length).find("accepted"), std::string::npos) << text << ": " << refusal(text, dimension::length);
  EXPECT_NE(refusal("1e999m", dimension::length).find("too large"), std::string::npos);
  EXPECT_NE(refusal("1e308km", dimension::length).find("too large"), std::string::npos);
  EXPECT_NE(refusal("fast", dimension::velocity).find("'fast': not a number"), std::string::npos);
}

TEST(Quantity, WritesWhatPeopleWrite) {
  EXPECT_EQ(quantity::format(9.5 * unit::mm, dimension::length), "9.5mm");
  EXPECT_EQ(quantity::format(0.05 * unit::mm, dimension::length), "0.05mm");
  EXPECT_EQ(quantity::format(1e-4, dimension::length), "0.1mm");
  EXPECT_EQ(quantity::format(2.2 * unit::mm, dimension::length), "2.2mm");
  EXPECT_EQ(quantity::format(6640, dimension::velocity), "6.64km/s");
  EXPECT_EQ(quantity::format(-300, dimension::velocity), "-300m/s");
  EXPECT_EQ(quantity::format(1.5 * unit::GPa, dimension::pressure), "1.5GPa");
  EXPECT_EQ(quantity::format(6.6 * unit::us, dimension::time), "6.6us");
  EXPECT_EQ(quantity::format(293, dimension::temperature), "293K");
  EXPECT_EQ(quantity::format(2785, dimension::density), "2785kg/m3");
  EXPECT_EQ(quantity::format(0, dimension::length), "0m");
  EXPECT_EQ(quantity::format(0.3, dimension::dimensionless), "0.3");
}

TEST(Quantity, WrittenReadsBackAsTheSameNumber) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-30, 30);
  for (int n = 0; n < 20000; ++n) {
    const double value = mantissa(random) * std::pow(10, exponent(random));
    for (const auto d : all_dimensions) ASSERT_EQ(parse(quantity::format(value, d), d), value) << quantity::format(value, d);
  }
}

TEST(Quantity, EveryListedUnitIsRead) {
  for (const auto d : all_dimensions)
    for (const auto& unit : quantity::detail::entry(d).units) EXPECT_EQ(parse("3" + std::string(unit.name), d), 3 * unit.factor) << unit.name;
}

} // namespace
