// SPDX-License-Identifier: MIT
// Everything that the user may choose, in SI, with the defaults of the scene. options.hpp reads and writes it as text.
#pragma once

#include "bolide/core/unit.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace impact {

/// Material beyond r_max or outside z_min..z_max (m) leaves the computation, counted.
struct box_limits {
  double r_max, z_min, z_max;
};

/// Every so much simulated time (s), or every so many steps.
struct checkpoint_interval {
  double time = 0;
  long steps = 0;
};

struct settings {
  // the scene
  std::string projectile = "aluminium", target = "aluminium"; // names in material/data/library.hpp
  double diameter = 9.5 * bolide::unit::mm;
  double velocity = 6640; // m/s
  double thickness = 2.2 * bolide::unit::mm;
  double plate_radius = 50 * bolide::unit::mm;
  double until = 6.6 * bolide::unit::us;
  // the physics
  std::string eos = "mixed";                               // paper, mixed, helm, mie-gruneisen, tillotson
  std::string initial = "ambient";                         // or cold
  std::optional<double> tension = 1.5 * bolide::unit::GPa; // empty: only melting fails
  double viscosity_quadratic = 1.5, viscosity_linear = 0.06;
  // the discretisation
  double spacing = 0.05 * bolide::unit::mm, cell = 0.1 * bolide::unit::mm;
  std::optional<double> coarse_beyond; // m: plate outside this radius has the widest particles that the cell allows
  double cfl = 0.4;
  std::string shape = "bspline", transfer = "apic", scheme = "usf", precision = "double";
  double jitter = 0; // of the spacing
  std::uint64_t seed = 1;
  std::optional<box_limits> box;
  int threads = 1;            // 0: all there are; threads of a busy machine wait for each other
  long step_cap = 10'000'000; // a run that needs more steps is stopped
  // the output
  std::optional<int> frames; // ParaView frames after the first; empty: one every 0.6 us
  std::string fields = "velocity,density,pressure,temperature,melt_fraction,region,failed,void_fraction,plastic_strain,peak_pressure";
  std::string pictures = "all"; // or none
  std::string out = "aluminium_impact_out";
  bool compare = false;                                // all equations of state, side by side
  int ensemble = 1;                                    // jitter seeds
  std::optional<checkpoint_interval> checkpoint_every; // empty: no checkpoints
  std::string restart;                                 // checkpoint to go on from; empty: from the start
};

/// Particles of the plate's rim: as wide as the solver allows (0.75 cells) and whole layers over the thickness.
inline double coarse_spacing(const settings& s) { return s.thickness / std::ceil(s.thickness / (0.75 * s.cell) * (1 - 1e-9)); }

/// Coarser lattice and grid, one ParaView frame: the same cloud in seconds.
inline void make_quick(settings& s) {
  s.spacing = 0.1 * bolide::unit::mm;
  s.cell = 0.2 * bolide::unit::mm;
  s.frames = 1;
}

#if defined(BOLIDE_HDF5)
inline constexpr bool has_checkpoints = true;
#else
inline constexpr bool has_checkpoints = false; // built without the HDF5 library
#endif

inline constexpr const char* all_eos[] = {"paper", "mixed", "helm", "reference", "mie-gruneisen", "tillotson"};

} // namespace impact
