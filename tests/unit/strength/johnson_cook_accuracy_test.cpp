// SPDX-License-Identifier: MIT
// Accuracy of the packed Johnson-Cook yield stress: relative error at most 2e-15 against long double, over plastic strains of 1e-9 to 10, rates of 1
// to 1e8 /s and temperatures up to half way from room temperature to melting. (Nearer to melting 1 - T* cancels: the error of the formula itself,
// in any number type, grows as 1/(1 - T*).)
#include "bolide/strength/johnson_cook.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace bolide {
namespace {
using real = long double;

template <class V> double largest_error(double exponent, double temperature_exponent) {
  strength::johnson_cook m;
  m.n = exponent;
  m.q = temperature_exponent;
  constexpr double melting = 933;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> log_strain(std::log(1e-9), std::log(10.0)), log_rate(0, std::log(1e8));
  std::uniform_real_distribution<double> t(m.room_temperature, (m.room_temperature + melting) / 2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double strain = std::exp(log_strain(random)), rate = std::exp(log_rate(random)), temperature = t(random);
    const auto y = static_cast<double>(lane(m.yield_stress(V(strain), V(rate), V(temperature), V(melting)), 0));
    const real star = (real(temperature) - real(m.room_temperature)) / (real(melting) - real(m.room_temperature));
    const real hardened = real(m.a) + real(m.b) * std::pow(real(strain), real(m.n));
    const real expected = hardened * (1 + real(m.c) * std::log(real(rate))) * (1 - std::pow(star, real(m.q)));
    worst = std::max(worst, static_cast<double>(std::abs(real(y) / expected - 1)));
  }
  return worst;
}

template <class V> class JohnsonCookAccuracy : public testing::Test {};
using doubles = testing::Types<double, pack<double, 2>, pack<double, 4>, pack<double, 8>>;
TYPED_TEST_SUITE(JohnsonCookAccuracy, doubles);

TYPED_TEST(JohnsonCookAccuracy, Is2e15Relative) {
  for (const double n : {0.1, 0.34, 1.0})
    for (const double q : {1.0, 1.7}) {
      const double error = largest_error<TypeParam>(n, q);
      std::printf("[ figures  ] n = %g, q = %g: largest relative error %.1e\n", n, q, error);
      EXPECT_LT(error, 2e-15) << n << " " << q;
    }
}

} // namespace
} // namespace bolide
