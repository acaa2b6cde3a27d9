// SPDX-License-Identifier: MIT
// Every space against full 3 x 3 tensors that are built and combined here, independently of it.
#include "bolide/concepts/space.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/space/plane_strain.hpp"

#include "unit/eos/lanes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace bolide {
namespace {

using tensor = std::array<std::array<double, 3>, 3>;

tensor times(const tensor& a, const tensor& b) {
  tensor c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
double determinant(const tensor& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}
double trace(const tensor& a) { return a[0][0] + a[1][1] + a[2][2]; }
double double_dot(const tensor& a, const tensor& b) {
  double s = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) s += a[i][j] * b[i][j];
  return s;
}

/// Full tensors of a space's components. Order of axes: r, z, theta / x, y, z.
template <class Space> struct full;
template <> struct full<space::axisymmetric> {
  static tensor gradient(const std::array<double, 5>& l) { return {{{l[0], l[1], 0}, {l[2], l[3], 0}, {0, 0, l[4]}}}; }
  static tensor deviator(const std::array<double, 3>& s) { return {{{s[0], s[2], 0}, {s[2], s[1], 0}, {0, 0, -s[0] - s[1]}}}; }
  static std::array<double, 3> components(const tensor& t) { return {t[0][0], t[1][1], t[0][1]}; }
};
template <> struct full<space::planar_1d> {
  static tensor gradient(const std::array<double, 1>& l) { return {{{l[0], 0, 0}, {0, 0, 0}, {0, 0, 0}}}; }
  static tensor deviator(const std::array<double, 1>& s) { return {{{s[0], 0, 0}, {0, -s[0] / 2, 0}, {0, 0, -s[0] / 2}}}; }
  static std::array<double, 1> components(const tensor& t) { return {t[0][0]}; }
};
template <> struct full<space::plane_strain> {
  static tensor gradient(const std::array<double, 4>& l) { return {{{l[0], l[1], 0}, {l[2], l[3], 0}, {0, 0, 0}}}; }
  static tensor deviator(const std::array<double, 3>& s) { return {{{s[0], s[2], 0}, {s[2], s[1], 0}, {0, 0, -s[0] - s[1]}}}; }
  static std::array<double, 3> components(const tensor& t) { return {t[0][0], t[1][1], t[0][1]}; }
};
template <> struct full<space::cartesian_3d> {
  static tensor gradient(const std::array<double, 9>& l) { return {{{l[0], l[1], l[2]}, {l[3], l[4], l[5]}, {l[6], l[7], l[8]}}}; }
  static tensor deviator(const std::array<double, 5>& s) { return {{{s[0], s[2], s[3]}, {s[2], s[1], s[4]}, {s[3], s[4], -s[0] - s[1]}}}; }
  static std::array<double, 5> components(const tensor& t) { return {t[0][0], t[1][1], t[0][1], t[0][2], t[1][2]}; }
};

template <class Space> class Spaces : public testing::Test {
protected:
  std::mt19937 random{7};
  double next() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  typename Space::template gradient<double> some_gradient() {
    typename Space::template gradient<double> l;
    for (auto& x : l) x = next();
    return l;
  }
  typename Space::template deviator<double> some_deviator() {
    typename Space::template deviator<double> s;
    for (auto& x : s) x = next();
    return s;
  }
};
using spaces = testing::Types<space::axisymmetric, space::planar_1d, space::plane_strain, space::cartesian_3d>;
TYPED_TEST_SUITE(Spaces, spaces);

TYPED_TEST(Spaces, MeetTheConceptOnEveryLane) {
  EXPECT_TRUE((Space<TypeParam, double> && Space<TypeParam, float> && Space<TypeParam, pack<double, 8>> && Space<TypeParam, pack<float, 16>>));
}

TYPED_TEST(Spaces, GradientInvariantsAreThoseOfTheFullTensor) {
  for (int i = 0; i < 100; ++i) {
    const auto l = this->some_gradient();
    const tensor t = full<TypeParam>::gradient(l);
    EXPECT_NEAR(TypeParam::divergence(l), trace(t), 1e-15);
    const double dt = 0.3 * this->next();
    tensor one_plus{};
    double largest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        one_plus[a][b] = (a == b) + dt * t[a][b];
        largest = std::max(largest, std::abs(t[a][b]));
      }
    EXPECT_NEAR(TypeParam::jacobian(l, dt), determinant(one_plus), 1e-15);
    EXPECT_EQ(TypeParam::magnitude(l), largest);
  }
}

TYPED_TEST(Spaces, DeviatoricRateIsTheDeviatorOfTheSymmetricGradient) {
  for (int i = 0; i < 100; ++i) {
    const auto l = this->some_gradient();
    const tensor t = full<TypeParam>::gradient(l);
    tensor d{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) d[a][b] = (t[a][b] + t[b][a]) / 2 - (a == b ? trace(t) / 3 : 0);
    const auto ours = full<TypeParam>::deviator(TypeParam::deviatoric_rate(l));
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(ours[a][b], d[a][b], 1e-15);
  }
}

TYPED_TEST(Spaces, ContractionIsTheFullDoubleDot) {
  for (int i = 0; i < 100; ++i) {
    const auto a = this->some_deviator(), b = this->some_deviator();
    EXPECT_NEAR(TypeParam::contract(a, b), double_dot(full<TypeParam>::deviator(a), full<TypeParam>::deviator(b)), 1e-15);
    // s : D counts what the deviator of D counts
    const auto l = this->some_gradient();
    EXPECT_NEAR(TypeParam::contract(a, TypeParam::deviatoric_rate(l)), double_dot(full<TypeParam>::deviator(a), full<TypeParam>::gradient(l)), 2e-15);
  }
}

TYPED_TEST(Spaces, JaumannRateIsWsMinusSW) {
  for (int i = 0; i < 100; ++i) {
    const auto l = this->some_gradient();
    const auto s = this->some_deviator();
    const tensor t = full<TypeParam>::gradient(l), full_s = full<TypeParam>::deviator(s);
    tensor w{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) w[a][b] = (t[a][b] - t[b][a]) / 2;
    const tensor ws = times(w, full_s), sw = times(full_s, w);
    tensor rate{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) rate[a][b] = ws[a][b] - sw[a][b];
    const auto ours = TypeParam::jaumann_rate(s, l);
    const auto theirs = full<TypeParam>::components(rate);
    for (std::size_t c = 0; c < theirs.size(); ++c) EXPECT_NEAR(ours[c], theirs[c], 1e-15);
    EXPECT_NEAR(TypeParam::contract(s, ours), 0, 1e-15) << "rotation must not change the length of s";
  }
}

TYPED_TEST(Spaces, StressComponentsAreThoseOfMinusPPlusS) {
  const auto s = this->some_deviator();
  const double p = 3.5;
  const auto t = full<TypeParam>::deviator(s);
  const auto plane = TypeParam::in_plane(p, s);
  constexpr auto n = static_cast<std::size_t>(TypeParam::dim);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) EXPECT_NEAR(plane[a * n + b], t[a][b] - (a == b ? p : 0), 1e-15);
  if constexpr (TypeParam::hoop) {
    EXPECT_NEAR(TypeParam::hoop_stress(p, s), t[2][2] - p, 1e-15);
  }
}

TYPED_TEST(Spaces, LanesAgreeWithTheScalar) {
  using V = pack<double, 8>;
  const auto l = this->some_gradient();
  const auto s = this->some_deviator();
  typename TypeParam::template gradient<V> lv;
  typename TypeParam::template deviator<V> sv;
  for (std::size_t c = 0; c < l.size(); ++c) lv[c] = V(l[c]);
  for (std::size_t c = 0; c < s.size(); ++c) sv[c] = V(s[c]);
  EXPECT_NEAR(TypeParam::jacobian(lv, V(0.1))[5], TypeParam::jacobian(l, 0.1), 1e-15);
  EXPECT_NEAR(TypeParam::contract(sv, sv)[3], TypeParam::contract(s, s), 1e-15);
  EXPECT_NEAR(TypeParam::jaumann_rate(sv, lv)[0][7], TypeParam::jaumann_rate(s, l)[0], 1e-15);
}

TEST(AxisymmetricSpace, VolumeIsThatOfTheRing) {
  const double at[] = {0.02, 5.0};
  EXPECT_NEAR(space::axisymmetric::volume(at, 1e-6), 2 * 3.14159265358979324 * 0.02 * 1e-6, 1e-20);
  EXPECT_EQ(space::axisymmetric::components(rank::gradient), 4);
  EXPECT_EQ(space::axisymmetric::components(rank::deviator), 3);
  EXPECT_EQ(space::planar_1d::volume(at, 0.003), 0.003);
  EXPECT_EQ(space::plane_strain::volume(at, 0.003), 0.003);
  EXPECT_EQ(space::cartesian_3d::volume(at, 0.003), 0.003);
}

} // namespace
} // namespace bolide
