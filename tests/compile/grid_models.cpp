// SPDX-License-Identifier: MIT
// expect: ok
// The library's grids, boundaries, particle storage and time step meet their concepts; each concept refuses an empty type.
#include "bolide/concepts/boundary.hpp"
#include "bolide/concepts/grid.hpp"
#include "bolide/concepts/particle_storage.hpp"
#include "bolide/concepts/time_step.hpp"
#include "bolide/grid/mirror.hpp"
#include "bolide/grid/node_column.hpp"
#include "bolide/grid/periodic.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/grid/uniform.hpp"
#include "bolide/particles/columns.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/time/courant.hpp"

struct nothing {};
using map = bolide::grid::block_map<2>;
static_assert(bolide::Grid<bolide::grid::block_map<1>> && bolide::Grid<map> && bolide::Grid<bolide::grid::block_map<3>> && !bolide::Grid<nothing>);
static_assert(bolide::Grid<bolide::grid::dense_map<1>> && bolide::Grid<bolide::grid::dense_map<2>> && bolide::Grid<bolide::grid::dense_map<3>>);
using column = bolide::grid::node_column<double, 3>;
static_assert(bolide::Boundary<bolide::grid::mirror_nodes<2>, map, column> && bolide::Boundary<bolide::grid::periodic_nodes<2>, map, column> && !bolide::Boundary<nothing, map, column>);
using columns = bolide::particles::columns<float, bolide::space::axisymmetric, bolide::fields<bolide::field::mass, bolide::field::velocity>>;
static_assert(bolide::ParticleStorage<columns> && bolide::ParticleStorage<columns, bolide::field::mass, bolide::field::velocity>);
static_assert(!bolide::ParticleStorage<columns, bolide::field::deviator> && !bolide::ParticleStorage<nothing>);
static_assert(bolide::TimeStep<bolide::controls<>> && bolide::TimeStep<bolide::controls<float>> && !bolide::TimeStep<nothing>);
