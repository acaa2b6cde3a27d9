// SPDX-License-Identifier: MIT
// Lanes: what a pack does to W numbers is what the scalar does to each of them. The same body runs over every number type.
#include "bolide/core/lane.hpp"

#include "unit/core/lane_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using namespace bolide;

template <class V> class LaneOf : public testing::Test {
protected:
  using number = scalar_t<V>;
  static constexpr int width = lane_width<V>;
  /// 1.5, 2.5, ... and a second operand that is below, equal and above it in turn.
  static V first() { return filled([](int i) { return number(i) + number(1.5); }); }
  static V second() { return filled([](int i) { return number(i) + number(0.5) * number(i % 3 + 2); }); }
  template <class F> static V filled(F f) {
    std::array<number, static_cast<std::size_t>(width)> values{};
    for (int i = 0; i < width; ++i) values[static_cast<std::size_t>(i)] = f(i);
    return load<V>(values.data());
  }
  static bool answer(mask_t<V> m, int i) {
    if constexpr (lane_width<V> == 1) return i == 0 && m;
    else return m[i];
  }
};
TYPED_TEST_SUITE(LaneOf, lane_types);

TYPED_TEST(LaneOf, IsALane) {
  using V = TypeParam;
  static_assert(Lane<V>);
  static_assert(sizeof(V) == sizeof(scalar_t<V>) * static_cast<std::size_t>(lane_width<V>));
}

TYPED_TEST(LaneOf, LoadStoreAndLane) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const V x = this->first();
  std::array<T, static_cast<std::size_t>(lane_width<V>) + 1> out{};
  store(x, out.data() + 1); // not aligned
  for (int i = 0; i < lane_width<V>; ++i) {
    EXPECT_EQ(lane(x, i), T(i) + T(1.5));
    EXPECT_EQ(out[static_cast<std::size_t>(i) + 1], T(i) + T(1.5));
  }
}

TYPED_TEST(LaneOf, ArithmeticIsTheScalarsInEachLane) {
  using V = TypeParam;
  const V a = this->first(), b = this->second();
  V sum = a, difference = a, product = a, quotient = a;
  sum += b, difference -= b, product *= b, quotient /= b;
  for (int i = 0; i < lane_width<V>; ++i) {
    const auto x = lane(a, i), y = lane(b, i);
    EXPECT_EQ(lane(V(a + b), i), x + y);
    EXPECT_EQ(lane(V(a - b), i), x - y);
    EXPECT_EQ(lane(V(a * b), i), x * y);
    EXPECT_EQ(lane(V(a / b), i), x / y);
    EXPECT_EQ(lane(V(-a), i), -x);
    EXPECT_EQ(lane(V(2 * a), i), 2 * x);
    EXPECT_EQ(lane(sum, i), x + y);
    EXPECT_EQ(lane(difference, i), x - y);
    EXPECT_EQ(lane(product, i), x * y);
    EXPECT_EQ(lane(quotient, i), x / y);
  }
}

TYPED_TEST(LaneOf, ComparisonsSelectInEachLane) {
  using V = TypeParam;
  const V a = this->first(), b = this->second();
  for (int i = 0; i < lane_width<V>; ++i) {
    const auto x = lane(a, i), y = lane(b, i);
    EXPECT_EQ(this->answer(a < b, i), x < y);
    EXPECT_EQ(this->answer(a > b, i), x > y);
    EXPECT_EQ(this->answer(a <= b, i), x <= y);
    EXPECT_EQ(this->answer(a >= b, i), x >= y);
    EXPECT_EQ(this->answer(a == b, i), x == y);
    EXPECT_EQ(this->answer(a != b, i), x != y);
    EXPECT_EQ(this->answer((a < b) || (a > b), i), x != y);
    EXPECT_EQ(this->answer((a <= b) && (a >= b), i), x == y);
    EXPECT_EQ(this->answer(!(a < b), i), !(x < y));
    EXPECT_EQ(lane(V(select(a < b, a, b)), i), x < y ? x : y);
    EXPECT_EQ(lane(V(select(a < b, a, 0)), i), x < y ? x : 0);
  }
}

TYPED_TEST(LaneOf, AnyAllCount) {
  using V = TypeParam;
  using T = scalar_t<V>;
  for (int n = 0; n <= lane_width<V>; ++n) {
    const mask_t<V> m = first_lanes<V>(n);
    EXPECT_EQ(count(m), n);
    EXPECT_EQ(any(m), n > 0);
    EXPECT_EQ(all(m), n == lane_width<V>);
  }
  for (int k = 0; k < lane_width<V>; ++k) { // a single lane, wherever it is, is seen
    const V x = this->filled([&](int i) { return i == k ? T(1) : T(0); });
    EXPECT_TRUE(any(x > V(0)));
    EXPECT_EQ(all(x > V(0)), lane_width<V> == 1);
    EXPECT_EQ(count(x > V(0)), 1);
  }
}

TYPED_TEST(LaneOf, ComparisonWithNotANumberIsNo) {
  using V = TypeParam;
  const V nan(std::numeric_limits<scalar_t<V>>::quiet_NaN());
  EXPECT_FALSE(any(nan < V(1)));
  EXPECT_FALSE(any(nan >= V(1)));
  EXPECT_FALSE(any(nan == nan));
  EXPECT_TRUE(all(nan != nan));
}

TYPED_TEST(LaneOf, Gather) {
  using V = TypeParam;
  using T = scalar_t<V>;
  std::vector<T> table(64);
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = T(i * i);
  std::array<int, 16> index{};
  for (int i = 0; i < 16; ++i) index[static_cast<std::size_t>(i)] = (37 * i + 5) % 64;
  const V x = gather<V>(table.data(), index.data());
  for (int i = 0; i < lane_width<V>; ++i) EXPECT_EQ(lane(x, i), table[static_cast<std::size_t>(index[static_cast<std::size_t>(i)])]);
}

TYPED_TEST(LaneOf, WholeNumbersAreStoredAsIntegers) {
  using V = TypeParam;
  using T = scalar_t<V>;
  for (const double start : {-3.0, 0.0, 2.0, 1e6, -1e6}) {
    const V x = this->filled([&](int i) { return T(start) + T(i); });
    std::array<std::int32_t, 16> whole{};
    store_whole(x, whole.data());
    for (int i = 0; i < lane_width<V>; ++i) EXPECT_EQ(whole[static_cast<std::size_t>(i)], static_cast<std::int32_t>(start) + i);
  }
}

TEST(NativePack, FillsTheRegister) {
  EXPECT_EQ(sizeof(native_pack<double>), static_cast<std::size_t>(native_bytes));
  EXPECT_EQ(sizeof(native_pack<float>), static_cast<std::size_t>(native_bytes));
  static_assert(!Lane<int>);
}

TYPED_TEST(LaneOf, SpreadsAndSqueezesByEveryMask) {
  using V = TypeParam;
  using n = typename TestFixture::number;
  constexpr int w = TestFixture::width;
  std::array<n, 2 * static_cast<std::size_t>(w)> dense{}, back{};
  for (std::size_t i = 0; i < dense.size(); ++i) dense[i] = n(i) + n(0.5);
  for (unsigned trial = 0; trial < 256; ++trial) {
    const unsigned bits = (trial * 2654435761u ^ trial) & all_lanes<V>;
    const V lanes = spread<V>(dense.data(), bits);
    std::size_t next = 0;
    for (int i = 0; i < w; ++i) {
      const bool there = (bits >> i) & 1;
      EXPECT_EQ(lane(lanes, i), there ? dense[next] : n(0)) << bits;
      EXPECT_EQ(this->answer(lanes_of<V>(bits), i), there);
      next += there;
    }
    back.fill(n(-1));
    squeeze(lanes, bits, back.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(w); ++i) EXPECT_EQ(back[i], i < next ? dense[i] : n(0)) << bits;
    EXPECT_EQ(back[static_cast<std::size_t>(w)], n(-1)) << "more than a register was written";
  }
  for (int i = 0; i < w; ++i) EXPECT_EQ(lane(lane_numbers<V>(), i), n(i));
}

} // namespace
