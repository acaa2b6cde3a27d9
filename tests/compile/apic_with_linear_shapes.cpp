// SPDX-License-Identifier: MIT
// expect: bolide: solver: APIC with linear shape functions is unsound (its affine field is amplified at nodes of tiny mass); take shape::quadratic_bspline, or transfer::flip
#include "scene.hpp"

void f() { scene::run(bolide::space::planar_1d{}, bolide::shape::linear{}, bolide::transfer::apic{}); }
