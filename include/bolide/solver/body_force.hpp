// SPDX-License-Identifier: MIT
// A force on every particle: gravity, or the manufactured force of a problem with a known answer.
//
//   sim.add(body_force{[](const vec<double, 2>& x, double t) { return vec<double, 2>{0, -9.81}; }});    // acceleration, m/s2
//
//   f_I += sum N m b(x_p, t), t at the beginning of the step.   Its work is booked in the ledger's channel `body_work`.
// Cost: one call per particle and step and one more sweep; a scene without one pays nothing.
#pragma once

#include "bolide/core/algebra.hpp"

#include <memory>
#include <utility>

namespace bolide {

template <class F> struct body_force {
  F acceleration;
  explicit body_force(F f) : acceleration(std::move(f)) {}
};

namespace detail {
/// A body force whose type is forgotten, so that a solver holds any number of them.
template <int Dim> class any_body_force {
public:
  template <class F> explicit any_body_force(body_force<F> f) : model_(std::make_shared<model<F>>(std::move(f.acceleration))) {}
  vec<double, Dim> acceleration(const vec<double, Dim>& x, double t) const { return model_->acceleration(x, t); }

private:
  struct base {
    virtual ~base() = default;
    virtual vec<double, Dim> acceleration(const vec<double, Dim>& x, double t) const = 0;
  };
  template <class F> struct model final : base {
    F f;
    explicit model(F g) : f(std::move(g)) {}
    vec<double, Dim> acceleration(const vec<double, Dim>& x, double t) const override { return f(x, t); }
  };
  std::shared_ptr<const base> model_;
};
} // namespace detail

} // namespace bolide
