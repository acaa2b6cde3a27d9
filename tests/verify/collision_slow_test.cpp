// SPDX-License-Identifier: MIT
// Colliding rings and discs: energy drift of every scheme and transfer, with the loss dropped and returned as heat, and what each transfer loses.
#include "verify/collision.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(Transfers, QuadraticUsf) { check_transfers<shape::quadratic_bspline, scheme::usf>(); }
TEST(Transfers, QuadraticMusl) { check_transfers<shape::quadratic_bspline, scheme::musl>(); }
TEST(Transfers, QuadraticUsl) { check_transfers<shape::quadratic_bspline, scheme::usl>(); }

} // namespace
} // namespace bolide
