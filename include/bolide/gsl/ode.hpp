// SPDX-License-Identifier: MIT
// An initial-value problem dy/dt = f(t, y) for N doubles, by GSL's Runge-Kutta-Prince-Dormand 8(9) driver.
#pragma once

#include "bolide/gsl/error.hpp"

#include <gsl/gsl_odeiv2.h>

#include <array>
#include <cstddef>
#include <memory>

namespace bolide::gsl {

/// Takes y from t to `end`; f(t, y) returns the slopes as std::array<double, N>. Errors are kept below relative * |y| + absolute.
template <std::size_t N, class F>
std::array<double, N> integrate(const F& f, std::array<double, N> y, double t, double end, double relative = 1e-11, double absolute = 0) {
  const errors_returned guard;
  gsl_odeiv2_system system;
  system.function = [](double at, const double* in, double* out, void* p) {
    std::array<double, N> now;
    for (std::size_t i = 0; i < N; ++i) now[i] = in[i];
    const std::array<double, N> slope = (*static_cast<const F*>(p))(at, now);
    for (std::size_t i = 0; i < N; ++i) out[i] = slope[i];
    return static_cast<int>(GSL_SUCCESS);
  };
  system.jacobian = nullptr;
  system.dimension = N;
  system.params = const_cast<F*>(&f);
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4 * (end - t), absolute, relative), gsl_odeiv2_driver_free);
  check(gsl_odeiv2_driver_apply(driver.get(), &t, end, y.data()), "gsl_odeiv2_driver_apply");
  return y;
}

} // namespace bolide::gsl
