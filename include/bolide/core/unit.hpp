// SPDX-License-Identifier: MIT
// Units are factors at the edge: `9.5 * unit::mm` is 9.5e-3 m. Inside the library every number is SI.
#pragma once

namespace bolide::unit {
inline constexpr double m = 1, km = 1e3, cm = 1e-2, mm = 1e-3, um = 1e-6, nm = 1e-9, angstrom = 1e-10;
inline constexpr double s = 1, ms = 1e-3, us = 1e-6, ns = 1e-9, ps = 1e-12;
inline constexpr double kg = 1, g = 1e-3, mg = 1e-6, u = 1.66053906660e-27;         // CODATA 2018
inline constexpr double Pa = 1, kPa = 1e3, MPa = 1e6, GPa = 1e9, TPa = 1e12, bar = 1e5, Mbar = 1e11;
inline constexpr double J = 1, kJ = 1e3, MJ = 1e6, eV = 1.602176634e-19;           // CODATA 2018, exact
inline constexpr double K = 1;
} // namespace bolide::unit
