// SPDX-License-Identifier: MIT
// A root of any callable double -> double in a bracket, by GSL's Brent solver.
#pragma once

#include "bolide/gsl/error.hpp"

#include <gsl/gsl_roots.h>

#include <memory>

namespace bolide::gsl {

/// f(low) and f(high) must differ in sign; relative is the accuracy of the root. Throws gsl::failure.
template <class F> double root(const F& f, double low, double high, double relative = 1e-13) {
  const errors_returned guard;
  gsl_function function;
  function.function = [](double x, void* p) { return (*static_cast<const F*>(p))(x); };
  function.params = const_cast<F*>(&f);
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  check(gsl_root_fsolver_set(solver.get(), &function, low, high), "gsl_root_fsolver_set");
  for (int i = 0; i < 200; ++i) {
    check(gsl_root_fsolver_iterate(solver.get()), "gsl_root_fsolver_iterate");
    const int state = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()), 0, relative);
    if (state == GSL_SUCCESS) return gsl_root_fsolver_root(solver.get());
    if (state != GSL_CONTINUE) check(state, "gsl_root_test_interval");
  }
  throw failure("gsl::root: no convergence in 200 steps");
}

} // namespace bolide::gsl
