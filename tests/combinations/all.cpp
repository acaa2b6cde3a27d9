// SPDX-License-Identifier: MIT
// All transfers, schemes, grids and precisions on one space and one shape: compiled once per pair by all.sh, which defines SPACE and SHAPE.
#include "combinations/run_once.hpp"

using namespace bolide;
using space_type = space::SPACE;
using shape_type = shape::SHAPE;

template <class T, class Grid, class Transfer> void every_scheme(combinations::tally& t) {
  combinations::try_one<T, space_type, Grid, shape_type, Transfer, scheme::usf>(t);
  combinations::try_one<T, space_type, Grid, shape_type, Transfer, scheme::musl>(t);
  combinations::try_one<T, space_type, Grid, shape_type, Transfer, scheme::usl>(t);
}
template <class T, class Grid> void every_transfer(combinations::tally& t) {
  every_scheme<T, Grid, transfer::flip>(t);
  every_scheme<T, Grid, transfer::pic>(t);
  every_scheme<T, Grid, transfer::apic>(t);
  every_scheme<T, Grid, transfer::xpic<2>>(t);
}

int main() {
  combinations::tally t;
  every_transfer<double, grid::sparse>(t);
  every_transfer<double, grid::uniform>(t);
  every_transfer<float, grid::sparse>(t);
  every_transfer<float, grid::uniform>(t);
  std::printf("%s, %s: %d combinations run, %d refused at compile time, %d wrong\n", space_type::name, shape_type::name, t.run, t.refused, t.wrong);
  return t.wrong;
}
