// SPDX-License-Identifier: MIT
// Parameters of eos::reference. The defaults are aluminium: fitted to the data of tests/validate/reference_calibration_test.cpp (which
// repeats the fit and lands on them), but for the lines that say otherwise.
#pragma once

#include "bolide/core/contract.hpp"

#include <cmath>
#include <numbers>

namespace bolide::eos {

struct reference_parameters {
  double atomic_mass = 26.9815385;  // u, not fitted
  double statistical_weight = 6;    // of the free atom's ground term (2P: 2 + 4), not fitted: fixes the absolute entropy of the gas
  double G = 0.034;                 // J/(kg K2), electronic heat coefficient at x = 1, band value, not fitted
  double electron_saturation = 1;   // G(x) = G (1 + s) x^(2/3)/(1 + s x^(2/3)): grows no more in expansion; not fitted
  double E_coh = 12.05e6;           // J/kg, energy of the free atoms at 0 K: the datum itself (3.37 eV)

  double rho0 = 2731.8654;          // kg/m3, solid at 0 K and p = 0 (without zero-point motion)
  double K0 = 78.466912e9;          // Pa, its bulk modulus
  double eta = 4.2258836;           // Rose's length of the solid's cold curve
  double delta = 0.062919522;       // its cubic term
  double theta = 333.00436;         // K, Einstein temperature of the solid at x = 1
  double b = 1.8659386;             // height of gamma over 2/3, solid
  double b_liquid = 1.7036997;      // the same of the liquid
  double x_gamma = 1.4409704;       // V/V0 where gamma is highest
  double n = 2.4947807;             // how fast it falls to either side
  double dS = 353.46025;            // J/(kg K), entropy of disorder of the liquid under strong compression
  double c = 0.0065361331;          // lift of the liquid's cold curve in units of R T_b
  double x_join = 0.75;             // V/V0 from where on the liquid's cold curve is its own series (chosen)
  double b0 = -16.755936e6;         // J/kg, first four coefficients of that series (b0: mean-field attraction of the gas)
  double b1 = -1110.6756e6;
  double b2 = 5946.5556e6;
  double b3 = -13246.922e6;

  /// J/(kg K)
  double R() const { return 8.31446261815324 / (atomic_mass * 1e-3); }
  /// K: Sackur and Tetrode. F = 3/2 RT ln(kappa x^(-2/3)/T) is the ideal gas of these atoms.
  double kappa() const {
    constexpr double k = 1.380649e-23, h = 6.62607015e-34;
    const double m = atomic_mass * 1.66053906660e-27;
    return h * h / (2 * std::numbers::pi * m * k) * std::pow(m / rho0 * statistical_weight * std::numbers::e, -2.0 / 3);
  }

  /// Throws bad_parameter with a sentence unless every number makes sense.
  void validate() const {
    require(atomic_mass > 0, "reference atomic_mass", atomic_mass, "> 0", "u");
    require(statistical_weight >= 1, "reference statistical_weight", statistical_weight, ">= 1");
    require(G > 0, "reference G", G, "> 0", "J/(kg K2)");
    require(electron_saturation > 0, "reference electron_saturation", electron_saturation, "> 0");
    require(E_coh > 0, "reference E_coh", E_coh, "> 0", "J/kg");
    require(rho0 > 0, "reference rho0", rho0, "> 0", "kg/m3");
    require(K0 > 0, "reference K0", K0, "> 0", "Pa");
    require(eta > 0, "reference eta", eta, "> 0");
    require(delta >= 0 && delta < 0.3, "reference delta", delta, "between 0 and 0.3 (the cold curve stays convex under compression)");
    require(theta > 0, "reference theta", theta, "> 0", "K");
    require(b > 0, "reference b", b, "> 0");
    require(b_liquid > 0, "reference b_liquid", b_liquid, "> 0");
    require(x_gamma > 0, "reference x_gamma", x_gamma, "> 0", "V/V0");
    require(n > 0, "reference n", n, "> 0");
    require(dS > 0, "reference dS", dS, "> 0 (the liquid is the disordered phase)", "J/(kg K)");
    require(c > 0, "reference c", c, "> 0 (the liquid lies above the solid at 0 K under compression)");
    require(x_join > 0 && x_join <= 1, "reference x_join", x_join, "above 0 and not above 1", "V/V0");
  }
};

} // namespace bolide::eos
