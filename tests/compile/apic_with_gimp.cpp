// SPDX-License-Identifier: MIT
// expect: bolide: solver: APIC divides by the inertia of the shape function, sum N (x_I - x)^2, and that of this shape is not constant (it gives no `inertia`); take a B-spline, or transfer::flip
#include "scene.hpp"

#include "bolide/shape/gimp.hpp"

void f() { scene::run(bolide::space::planar_1d{}, bolide::shape::gimp{}, bolide::transfer::apic{}); }
