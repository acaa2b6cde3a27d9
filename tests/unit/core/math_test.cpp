// SPDX-License-Identifier: MIT
// Elementary functions: the packs' polynomials against long double, over the whole range of normal arguments and results.
// Bounds are those promised in core/math.hpp: relative error 2e-15 in double, 3e-7 in float. log near 1, where it passes through
// zero, has to keep the relative error too.
#include "bolide/core/math.hpp"

#include "unit/core/lane_types.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using namespace bolide;

template <class V> class Math : public testing::Test {
protected:
  using number = scalar_t<V>;
  static constexpr bool is_double = sizeof(number) == 8;
  static constexpr double bound = is_double ? 2e-15 : 3e-7;
  static constexpr double eps = std::numeric_limits<number>::epsilon();

  /// Calls `check(value of f in that lane, x)` for `n` random arguments in [low, high], evenly spread or evenly spread in the logarithm.
  template <class F, class Check> static void sweep(double low, double high, bool logarithmic, F f, Check check, int n = 200000) {
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> spread(logarithmic ? std::log(low) : low, logarithmic ? std::log(high) : high);
    for (int k = 0; k < n; k += lane_width<V>) {
      V x(0);
      for (int i = 0; i < lane_width<V>; ++i) {
        const double draw = spread(random);
        x = set(x, i, number(logarithmic ? std::exp(draw) : draw));
      }
      const V y = f(x);
      for (int i = 0; i < lane_width<V>; ++i) check(lane(y, i), lane(x, i));
    }
  }
  static V set(V x, int i, number value) {
    if constexpr (lane_width<V> == 1) return i == 0 ? value : x;
    else {
      x.set(i, value);
      return x;
    }
  }
  /// The largest relative error of `value` against `exact`.
  struct worst {
    double error = 0, at = 0;
    void add(number value, long double exact, double x) {
      const double e = exact == 0 ? (value == 0 ? 0 : 1) : static_cast<double>(std::fabs((static_cast<long double>(value) - exact) / exact));
      if (!(e <= error)) error = e, at = x; // NaN counts as worst
    }
    std::string text() const { return "relative error " + std::to_string(error * 1e16) + "e-16 at x = " + std::to_string(at); }
  };
};
TYPED_TEST_SUITE(Math, lane_types);

TYPED_TEST(Math, Log) {
  using V = TypeParam;
  const double tiny = this->is_double ? 1e-300 : 1.2e-38, huge = this->is_double ? 1e300 : 3e38;
  typename TestFixture::worst wide, near_one;
  const auto f = [](V x) { return V(log(x)); };
  this->sweep(tiny, huge, true, f, [&](auto y, auto x) { wide.add(y, std::log(static_cast<long double>(x)), x); });
  this->sweep(0.5, 2, false, f, [&](auto y, auto x) { near_one.add(y, std::log(static_cast<long double>(x)), x); });
  EXPECT_LE(wide.error, this->bound) << wide.text();
  EXPECT_LE(near_one.error, this->bound) << near_one.text();
  EXPECT_EQ(lane(V(log(V(1))), 0), 0);
}

TYPED_TEST(Math, Exp) {
  using V = TypeParam;
  const double low = this->is_double ? -708 : -87, high = this->is_double ? 709 : 88;
  typename TestFixture::worst wide, small;
  const auto f = [](V x) { return V(exp(x)); };
  this->sweep(low, high, false, f, [&](auto y, auto x) { wide.add(y, std::exp(static_cast<long double>(x)), x); });
  this->sweep(-1, 1, false, f, [&](auto y, auto x) { small.add(y, std::exp(static_cast<long double>(x)), x); });
  EXPECT_LE(wide.error, this->bound) << wide.text();
  EXPECT_LE(small.error, this->bound) << small.text();
  EXPECT_EQ(lane(V(exp(V(0))), 0), 1);
}

// In float the error of exp(y log x) grows with |y log x|, which is why the bound does; in double it does not up to 10, and hardly beyond.
TYPED_TEST(Math, Pow) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const auto allowed = [&](double exponent) {
    if (this->is_double) return std::fabs(exponent) <= 10 ? this->bound : 5e-15;
    return this->bound * (1 + std::fabs(exponent)); // log's relative error times its size
  };
  const auto check = [&](auto value, auto x, double y) {
    const long double exponent = static_cast<long double>(T(y)) * std::log(static_cast<long double>(x)), exact = std::exp(exponent);
    const double error = static_cast<double>(std::fabs((static_cast<long double>(value) - exact) / exact));
    ASSERT_LE(error, allowed(static_cast<double>(exponent))) << x << " ^ " << y;
  };
  for (const double y : {-7.0, -1.0, -1.0 / 3.0, 0.0, 0.26, 0.5, 1.0, 1.03, 2.0 / 3.0, 2.0, 5.5})
    this->sweep(1e-5, 1e5, true, [&](V x) { return V(pow(x, V(T(y)))); }, [&](auto value, auto x) { check(value, x, y); }, 20000);
  // Near 1, where log x is small and y large: |y log x| up to 10, then up to 700 (float: 85).
  for (const double power : {10.0, -10.0, 3.7, this->is_double ? 700.0 : 85.0}) {
    const double y = power / 0.01;
    this->sweep(std::exp(-0.01), std::exp(0.01), true, [&](V x) { return V(pow(x, V(T(y)))); },
                [&](auto value, auto x) { check(value, x, y); }, 20000);
  }
}

// The claim of the table of docs/eos.md: |y log x| <= 10 over all arguments, y drawn with x.
TYPED_TEST(Math, PowOfRandomPairsWithinTen) {
  using V = TypeParam;
  using T = scalar_t<V>;
  if (!this->is_double) return; // float's bound grows: above
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> log_x(-600, 600), z(-10, 10);
  typename TestFixture::worst largest;
  for (int k = 0; k < 200000; k += lane_width<V>) {
    V x(0), y(0);
    for (int i = 0; i < lane_width<V>; ++i) {
      const double l = k % 2 == 0 ? log_x(random) : log_x(random) / 1000;
      x = TestFixture::set(x, i, T(std::exp(l)));
      y = TestFixture::set(y, i, T(0.999 * z(random) / l));
    }
    const V value = pow(x, y);
    for (int i = 0; i < lane_width<V>; ++i)
      largest.add(lane(value, i), std::exp(static_cast<long double>(lane(y, i)) * std::log(static_cast<long double>(lane(x, i)))),
                  static_cast<double>(lane(x, i)));
  }
  EXPECT_LE(largest.error, this->bound) << largest.text();
}

TYPED_TEST(Math, SqrtAndAbsAreExactlyTheScalars) {
  using V = TypeParam;
  const double tiny = this->is_double ? 1e-300 : 1.2e-38, huge = this->is_double ? 1e300 : 3e38;
  this->sweep(tiny, huge, true, [](V x) { return V(sqrt(x)); }, [](auto y, auto x) { ASSERT_EQ(y, std::sqrt(x)); }, 20000);
  this->sweep(-1e9, 1e9, false, [](V x) { return V(abs(x)); }, [](auto y, auto x) { ASSERT_EQ(y, std::fabs(x)); }, 20000);
  EXPECT_EQ(lane(V(sqrt(V(0))), 0), 0);
}

TYPED_TEST(Math, CbrtOfPositive) {
  using V = TypeParam;
  this->sweep(1e-6, 1e6, true, [](V x) { return V(cbrt(x)); },
              [&](auto y, auto x) { ASSERT_NEAR(y / std::cbrt(static_cast<double>(x)), 1, this->bound + 5 * this->eps) << x; }, 20000);
}

TYPED_TEST(Math, FloorOnBothSidesOfZero) {
  using V = TypeParam;
  this->sweep(-1000, 1000, false, [](V x) { return V(floor(x)); }, [](auto y, auto x) { ASSERT_EQ(y, std::floor(x)); }, 20000);
  for (const double whole : {-2.0, -1.0, 0.0, 1.0, 2.0}) EXPECT_EQ(lane(V(floor(V(scalar_t<V>(whole)))), 0), scalar_t<V>(whole));
}

TYPED_TEST(Math, MinMaxClipSquare) {
  using V = TypeParam;
  using T = scalar_t<V>;
  this->sweep(-4, 4, false, [](V x) { return V(clip(x, V(T(-1)), V(T(2)))); }, [](auto y, auto x) { ASSERT_EQ(y, x < T(-1) ? T(-1) : x > T(2) ? T(2) : x); }, 2000);
  this->sweep(-4, 4, false, [](V x) { return V(min(x, V(T(1)))); }, [](auto y, auto x) { ASSERT_EQ(y, x < T(1) ? x : T(1)); }, 2000);
  this->sweep(-4, 4, false, [](V x) { return V(max(x, V(T(1)))); }, [](auto y, auto x) { ASSERT_EQ(y, x > T(1) ? x : T(1)); }, 2000);
  this->sweep(-4, 4, false, [](V x) { return V(square(x)); }, [](auto y, auto x) { ASSERT_EQ(y, x * x); }, 2000);
}

// A pack never gives infinity where the scalar would overflow: it saturates.
template <class V> class PackMath : public testing::Test {};
TYPED_TEST_SUITE(PackMath, pack_types);
TYPED_TEST(PackMath, ExpSaturates) {
  using V = TypeParam;
  using T = scalar_t<V>;
  for (const double x : {1e3, 1e6, 1e30}) {
    const T large = exp(V(T(x)))[0], small = exp(V(T(-x)))[0];
    EXPECT_TRUE(std::isfinite(large));
    EXPECT_GT(large, T(sizeof(T) == 8 ? 1e307 : 1e38));
    EXPECT_GE(small, T(0));
    EXPECT_LT(small, T(sizeof(T) == 8 ? 1e-300 : 1e-37));
  }
}

} // namespace
