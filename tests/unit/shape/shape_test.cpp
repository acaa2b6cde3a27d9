// SPDX-License-Identifier: MIT
// Every shape function, on every lane type: a new model goes into `models` and inherits the whole suite.
#include "bolide/concepts/shape_function.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>

namespace bolide {
namespace {

template <class Shape, class V> struct on {
  using shape = Shape;
  using lane_type = V;
};
template <class V> using linear_on = on<shape::linear, V>;
template <class V> using bspline_on = on<shape::quadratic_bspline, V>;
template <class V> using cubic_on = on<shape::cubic_bspline, V>;

template <class Case> class ShapeFunctions : public testing::Test {};
using cases = testing::Types<linear_on<double>, linear_on<float>, linear_on<pack<double, 2>>, linear_on<pack<double, 4>>, linear_on<pack<double, 8>>, linear_on<pack<float, 4>>,
                             linear_on<pack<float, 8>>, linear_on<pack<float, 16>>, bspline_on<double>, bspline_on<float>, bspline_on<pack<double, 2>>,
                             bspline_on<pack<double, 4>>, bspline_on<pack<double, 8>>, bspline_on<pack<float, 4>>, bspline_on<pack<float, 8>>, bspline_on<pack<float, 16>>,
                             cubic_on<double>, cubic_on<float>, cubic_on<pack<double, 2>>, cubic_on<pack<double, 4>>, cubic_on<pack<double, 8>>, cubic_on<pack<float, 4>>,
                             cubic_on<pack<float, 8>>, cubic_on<pack<float, 16>>>;
TYPED_TEST_SUITE(ShapeFunctions, cases);

/// The model at every lane of f = first + k step, `first` in [offset, offset + 1): visit(f, N, dN/df, d2N/df2).
template <class Shape, class V, class Visit> void scan(Visit&& visit) {
  constexpr int n = Shape::support;
  const double step = 1.0 / 512;
  for (double first = Shape::offset; first + step * lane_width<V> <= Shape::offset + 1; first += step * lane_width<V>) {
    const V f = test::ramp<V>(first, step);
    V value[n], slope[n], curvature[n];
    Shape::value(f, value);
    Shape::slope(f, slope);
    Shape::curvature(f, curvature);
    for (int l = 0; l < lane_width<V>; ++l) {
      double a[n], b[n], c[n];
      for (int i = 0; i < n; ++i) {
        a[i] = static_cast<double>(lane(value[i], l));
        b[i] = static_cast<double>(lane(slope[i], l));
        c[i] = static_cast<double>(lane(curvature[i], l));
      }
      visit(static_cast<double>(lane(f, l)), a, b, c);
    }
  }
}

/// GIMP of particles whose half size is 1/Count cells, as a shape without a size.
template <int Count> struct gimp_of {
  static constexpr int support = 3;
  template <class V> static void value(V f, V* n) { shape::gimp::value(f, n, scalar_t<V>(1.0 / Count)); }
  template <class V> static void slope(V f, V* n) { shape::gimp::slope(f, n, scalar_t<V>(1.0 / Count)); }
};
template <class Case> class GimpShape : public testing::Test {};
using gimp_cases = testing::Types<on<gimp_of<2>, double>, on<gimp_of<3>, double>, on<gimp_of<4>, double>, on<gimp_of<8>, double>, on<gimp_of<4>, float>, on<gimp_of<4>, pack<double, 8>>,
                                  on<gimp_of<4>, pack<float, 16>>>;
TYPED_TEST_SUITE(GimpShape, gimp_cases);

TYPED_TEST(GimpShape, IsTheTentAveragedOverTheParticle) {
  using S = typename TypeParam::shape;
  using V = typename TypeParam::lane_type;
  double l = 0;
  if constexpr (std::is_same_v<S, gimp_of<2>>) l = 0.5;
  else if constexpr (std::is_same_v<S, gimp_of<3>>) l = 1.0 / 3;
  else if constexpr (std::is_same_v<S, gimp_of<4>>) l = 0.25;
  else l = 0.125;
  const auto integral = [](double x) { // of the tent, from far left to x
    if (x <= -1) return 0.0;
    if (x <= 0) return (1 + x) * (1 + x) / 2;
    return x < 1 ? 1 - (1 - x) * (1 - x) / 2 : 1.0;
  };
  const auto tent = [](double x) { return std::max(0.0, 1 - std::abs(x)); };
  for (double x = 0.5; x <= 1.5; x += 1.0 / 512) {
    V n[3], d[3];
    S::value(test::ramp<V>(x, 0), n);
    S::slope(test::ramp<V>(x, 0), d);
    double sum = 0, at = 0, slopes = 0, slope_at = 0;
    for (int i = 0; i < 3; ++i) {
      const double value = static_cast<double>(lane(n[i], 0)), slope = static_cast<double>(lane(d[i], 0));
      EXPECT_NEAR(value, (integral(x - i + l) - integral(x - i - l)) / (2 * l), test::epsilon<V>(8)) << x << " node " << i;
      EXPECT_NEAR(slope, (tent(x - i + l) - tent(x - i - l)) / (2 * l), test::epsilon<V>(16)) << x << " node " << i;
      EXPECT_GE(value, 0);
      sum += value, at += i * value, slopes += slope, slope_at += i * slope;
    }
    EXPECT_NEAR(sum, 1, test::epsilon<V>(8));
    EXPECT_NEAR(at, x, test::epsilon<V>(8));
    EXPECT_NEAR(slopes, 0, test::epsilon<V>(16));
    EXPECT_NEAR(slope_at, 1, test::epsilon<V>(16));
  }
}
TEST(Gimp, OfOneParticlePerCellIsTheQuadraticBSpline) {
  for (double x = 0.5; x <= 1.5; x += 1.0 / 128) {
    double a[3], b[3];
    gimp_of<2>::value(x, a);
    shape::quadratic_bspline::value(x, b);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-15);
  }
}
/// The hoop weight N + (l^2/2) N'' is the mean over the particle's two ends.
TEST(Gimp, HoopWeightIsTheMeanOverTheEnds) {
  const double l = 0.25;
  for (double x = 0.5; x <= 1.5; x += 1.0 / 128) {
    double n[3], c[3];
    shape::gimp::value(x, n, l);
    shape::gimp::curvature(x, c, l);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(n[i] + l * l / 2 * c[i], (std::max(0.0, 1 - std::abs(x - i - l)) + std::max(0.0, 1 - std::abs(x - i + l))) / 2, 1e-15);
  }
}

TYPED_TEST(ShapeFunctions, MeetTheConcept) {
  EXPECT_TRUE((ShapeFunction<typename TypeParam::shape, typename TypeParam::lane_type>));
}

TYPED_TEST(ShapeFunctions, AreAPartitionOfUnityAndNotNegative) {
  using S = typename TypeParam::shape;
  using V = typename TypeParam::lane_type;
  scan<S, V>([](double f, const double* n, const double* d, const double* c) {
    double sum = 0, slopes = 0, curvatures = 0;
    for (int i = 0; i < S::support; ++i) {
      EXPECT_GE(n[i], 0) << "node " << i << " at f = " << f;
      sum += n[i], slopes += d[i], curvatures += c[i];
    }
    EXPECT_NEAR(sum, 1, test::epsilon<V>(4)) << f;
    EXPECT_NEAR(slopes, 0, test::epsilon<V>(8)) << f;
    EXPECT_NEAR(curvatures, 0, test::epsilon<V>(8)) << f;
  });
}

TYPED_TEST(ShapeFunctions, ReproduceALinearField) {
  using S = typename TypeParam::shape;
  using V = typename TypeParam::lane_type;
  scan<S, V>([](double f, const double* n, const double* d, const double*) {
    double at = 0, slope = 0;
    for (int i = 0; i < S::support; ++i) at += n[i] * i, slope += d[i] * i;
    EXPECT_NEAR(at, f, test::epsilon<V>(8)) << f;
    EXPECT_NEAR(slope, 1, test::epsilon<V>(8)) << f;
  });
}

TYPED_TEST(ShapeFunctions, HaveTheDerivativesThatTheySay) {
  using S = typename TypeParam::shape;
  using V = typename TypeParam::lane_type;
  const double h = 1e-3; // exact for polynomials up to third degree: only round-off is left
  for (double x = S::offset + 0.01; x < S::offset + 0.99; x += 0.0137) {
    double lower[S::support], low[S::support], mid[S::support], high[S::support], higher[S::support];
    S::value(x - 2 * h, lower);
    S::value(x + 2 * h, higher);
    S::value(x - h, low);
    S::value(x, mid);
    S::value(x + h, high);
    V d[S::support], c[S::support];
    S::slope(test::ramp<V>(x, 0), d);
    S::curvature(test::ramp<V>(x, 0), c);
    for (int i = 0; i < S::support; ++i) {
      EXPECT_NEAR(static_cast<double>(lane(d[i], 0)), (8 * (high[i] - low[i]) - (higher[i] - lower[i])) / (12 * h), 1e-12 + test::epsilon<V>(8)) << "node " << i << " at " << x;
      EXPECT_NEAR(static_cast<double>(lane(c[i], 0)), (high[i] - 2 * mid[i] + low[i]) / (h * h), 1e-9 + test::epsilon<V>(8)) << "node " << i << " at " << x;
    }
  }
}

/// Values join at a cell face; a smooth model's slopes join too, and a model that does not say so must have a jump.
TYPED_TEST(ShapeFunctions, JoinAtCellFaces) {
  using S = typename TypeParam::shape;
  double end[S::support], begin[S::support];
  S::value(S::offset + 1, end); // seen from the left cell: its nodes are one further left
  S::value(double(S::offset), begin);
  EXPECT_NEAR(end[0], 0, 1e-15);
  for (int i = 1; i < S::support; ++i) EXPECT_NEAR(end[i], begin[i - 1], 1e-15);
  double d_end[S::support], d_begin[S::support], jump = 0;
  S::slope(S::offset + 1, d_end);
  S::slope(double(S::offset), d_begin);
  for (int i = 1; i < S::support; ++i) jump = std::max(jump, std::abs(d_end[i] - d_begin[i - 1]));
  EXPECT_EQ(jump < 1e-14, S::smooth) << jump;
}

/// What makes APIC's inertia a constant.
TYPED_TEST(ShapeFunctions, HaveTheInertiaThatTheySay) {
  using S = typename TypeParam::shape;
  using V = typename TypeParam::lane_type;
  if constexpr (requires { S::inertia; })
    scan<S, V>([](double f, const double* n, const double*, const double*) {
      double moment = 0;
      for (int i = 0; i < S::support; ++i) moment += n[i] * (i - f) * (i - f);
      EXPECT_NEAR(moment, S::inertia, test::epsilon<V>(8)) << f;
    });
  EXPECT_EQ(S::smooth, (requires { S::inertia; })) << "APIC takes smooth shapes and needs their inertia";
}

template <class V> class LinearShape : public testing::Test {};
TYPED_TEST_SUITE(LinearShape, lane_types);

/// A force on a node without mass would be lost (a bug once, and once more for x = -1e-18): see FaceParticle in solver/ledger_test.cpp.
TYPED_TEST(LinearShape, KeepsAShareForBothNodesOnACellFace) {
  using V = TypeParam;
  for (double f : {0.0, 1.0}) { // 1.0 is what x - floor(x) rounds to for x = -1e-18
    V n[2];
    shape::linear::value(V(static_cast<scalar_t<V>>(f)), n);
    for (int i = 0; i < 2; ++i) {
      EXPECT_GT(lane(n[i], 0), 0) << "f = " << f << ", node " << i;
      EXPECT_NEAR(static_cast<double>(lane(n[i], 0)), std::abs(1 - i - f), test::epsilon<V>(8));
    }
    EXPECT_EQ(lane(n[0], 0) + lane(n[1], 0), 1);
  }
}

} // namespace
} // namespace bolide
