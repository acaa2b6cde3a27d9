// SPDX-License-Identifier: MIT
// See everything_first.cpp.
#include "everything.hpp"

double second_unit();
double second_unit() { return bolide::quantity::parse("9.5mm", bolide::quantity::dimension::length); }
