// SPDX-License-Identifier: MIT
// Parameters of the phase-region model of Grover (as used in GRAY and in the paper), and its one-number consequences.
// Defaults: aluminium, from the paper. R there is the specific gas constant rounded to 308 J/(kg K).
#pragma once

#include "bolide/core/contract.hpp"

namespace bolide::phase {

struct grover_parameters {
  double R = 308;            // J/(kg K), specific gas constant
  double G = 0.032;          // J/(kg K2), electronic heat coefficient at x = 1 (the paper's 32 Pa cm3/(g K2))
  double dS = 1.16 * 308;    // J/(kg K), entropy of melting
  double al = 0.15 * 308;    // J/(kg K), alpha': fall of the liquid's heat capacity with T/T_m
  double g0 = 2.18;          // Grueneisen coefficient at x = 1
  double a = 1.7;            // its slope: gamma = g0 - a (1 - x)
  double ge = 2.0 / 3.0;     // Grueneisen coefficient of the electrons
  double Tm0 = 1220;         // K, melting temperature at x = 1 (not the 933 K of zero pressure, where x is 1.06)
  double xj = 1.3471;        // V_j/V0: gas beyond (variants paper and mixed)

  /// Hot liquid above tau = T/T_m of this value: 3R/(2 alpha'), 10 for aluminium. There the liquid's heat capacity has fallen to 3/2 R.
  constexpr double hot() const { return 3 * R / (2 * al); }
  /// K: what remains of melting and anharmonic energy in the hot liquid, in units of T_m. J/(kg K)
  constexpr double K() const { return dS + 0.5 * al * (hot() * hot() - 1); }

  /// Throws bad_parameter with a sentence unless every number makes sense.
  void validate() const {
    require(R > 0, "phase R", R, "> 0", "J/(kg K)");
    require(G >= 0, "phase G", G, ">= 0", "J/(kg K2)");
    require(dS > 0, "phase dS", dS, "> 0", "J/(kg K)");
    require(al > 0 && al < dS && hot() > 1, "phase al", al, "> 0, below dS (positive latent heat) and below 3R/2", "J/(kg K)");
    require(g0 > 1.0 / 3.0, "phase g0", g0, "> 1/3 (melting temperature rises with compression)");
    require(a >= 0 && a < g0, "phase a", a, "between 0 and g0 (gamma stays positive under any compression)");
    require(ge > 0 && ge < 3, "phase ge", ge, "between 0 and 3");
    require(Tm0 > 0, "phase Tm0", Tm0, "> 0", "K");
    require(xj > 1, "phase xj", xj, "> 1", "V/V0");
  }
};

} // namespace bolide::phase
