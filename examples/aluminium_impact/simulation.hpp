// SPDX-License-Identifier: MIT
// A run as the rest of the program sees it, whichever composition was chosen: the twelve compositions (shape and transfer, scheme,
// precision) are compiled in units of their own and stand behind this interface. One virtual call per step.
#pragma once

#include "settings.hpp"

#include "bolide/material/report.hpp"
#include "bolide/observe/snapshot.hpp"
#include "bolide/solver/ledger.hpp"

#if defined(BOLIDE_HDF5)
#include "bolide/hdf5/archive.hpp"
#endif

#include <memory>
#include <stdexcept>

namespace impact {

/// The solver cannot go on (bolide::run_stopped): what() says step, time, particle, cause and state.
struct stopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Sums and extremes over the particles of one moment.
struct census {
  double cold = 0, thermal = 0, shear = 0; // J, parts of the internal energy, each from its own formula
  double mass = 0;                         // kg
  double least_pressure = 0, most_pressure = 0, most_speed = 0, most_temperature = 0, least_density = 0, most_density = 0; // SI
};

class simulation {
public:
  virtual ~simulation() = default;
  virtual void start() = 0;           // brings the particles onto the grid: energies() is then the initial one
  virtual void step(double most) = 0; // throws stopped
  virtual double time() const = 0;
  virtual double dt() const = 0;
  virtual bolide::step_cause cause() const = 0;
  virtual long steps() const = 0;
  virtual std::uint64_t particle_steps() const = 0;
  virtual double solver_seconds() const = 0;
  virtual std::size_t particle_count() const = 0;
  virtual double geometric_mass() const = 0;
  virtual int threads() const = 0;
  virtual const bolide::ledger& energies() = 0;
  virtual census count() const = 0;
  virtual bolide::observe::snapshot snapshot() const = 0;
#if defined(BOLIDE_HDF5)
  virtual void archive(bolide::hdf5::writer& a) = 0; // for checkpoints
  virtual void archive(bolide::hdf5::reader& a) = 0;
#endif
};

/// The run that the settings describe. Throws bad_parameter.
std::unique_ptr<simulation> make_simulation(const settings& s);

} // namespace impact
