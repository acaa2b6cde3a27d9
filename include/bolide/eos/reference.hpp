// SPDX-License-Identifier: MIT
// The reference equation of state of aluminium: one Helmholtz free energy F(V, T) for solid, melting, liquid, vapour and everything
// above the critical point, calibrated to measurements (tests/validate/reference_eos_test.cpp prints how well).
//
//   solid, liquid   their own free energies (eos/reference/free_energy.hpp); p = -F_V, e = F - T F_T, exactly
//   mixed           solid and liquid with equal T, p and Gibbs energy (eos/reference/coexistence.hpp): melting at constant pressure keeps
//                   T, takes the latent heat and grows by the volume of melting; at constant volume T and p rise
// No jump anywhere: p and T are continuous across the edges, c drops at the solidus and rises at the liquidus as it must. Liquid and
// vapour are one branch, so that inside the liquid-vapour dome the states are the metastable and (within the spinodal, the only place
// where c^2 < 0) unstable ones. Under tension the solid melts at lower and lower temperature: at -4.3 GPa at 600 K,
// at -9.5 GPa at 0 K.
// e < e_c (no temperature): T = (e - e_c)/(3R) <= 0 is reported as it is, p and c^2 stay those of 0 K.
//
// Region: mixed between solidus and liquidus; gas beyond the critical volume; hot_liquid above the critical temperature within it.
// Melting temperature: T_s(V) of a solid, T of a mixture, T_l(V) of a liquid (0 where a liquid of that volume never freezes).
// Validity: 1e-6 to 5 times rho0, e up to 100 MJ/kg when dense. Free atoms do not ionise here: expanded matter above some 10 000 K
// takes more energy than this, and the electrons, which stay in the energy, push nothing there. One solid phase (fcc).
// Cost: T by Newton's method, 5 steps in one phase, 6 in a mixture. Measured (g++ -O3, AVX-512, a shared machine): 190 ns per call in double
// in the solid, 490 ns over all regions mixed at random; per lane of pack<double, 8> 50 ns in one phase, 93 ns over all; constructor 35 ms.
// eos::tabulated makes it a table for the time loop (poor within some 10 kJ/kg of 0 K: look at its error()).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/reference/coexistence.hpp"
#include "bolide/eos/reference/critical_point.hpp"
#include "bolide/eos/reference/free_energy.hpp"
#include "bolide/eos/validity.hpp"

#include <cmath>
#include <vector>

namespace bolide::eos {

/// A state given by volume and temperature, with its potentials.
struct reference_state {
  double free_energy, entropy, energy; // J/kg, J/(kg K), J/kg
  double pressure;                     // Pa
  region where;
};

class reference {
public:
  using parameters = reference_parameters;

  explicit reference(const reference_parameters& p = {}) : phases_(p), line_(phases_), critical_(detail::find_critical_point(phases_)) {
    R_ = p.R();
    critical_volume_ = p.rho0 / critical_.density;
    const auto pressure = line_.pressure(detail::coexistence::coldest), gibbs = line_.gibbs(detail::coexistence::coldest);
    tie_pressure_ = pressure.value;
    tie_energy_ = gibbs.value;
  }

  template <class V> BOLIDE_INLINE thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V x = T(phases_.parameters().rho0) / rho;
    const auto v = phases_.at(x);
    const auto solid = phases_.solid_cold(v);
    const V solid_melting = sqrt(max(line_.solidus_square(v.log_x), V(T(0))));
    const auto is_solid = v.log_x < V(T(line_.solid_end())) && e < line_.solidus_energy(v.log_x);
    if (all(is_solid)) {
      const V t = temperature(v, phases_.solid_lattice(v), e - solid.value);
      return single(v, solid, phases_.solid_lattice(v), rho, t, solid.value, solid_melting, V(T(0)), V(region_value<V>(region::solid)));
    }
    const auto liquid = phases_.liquid_cold(v, solid);
    const auto always_liquid = v.log_x >= V(T(line_.liquid_end()));
    const auto is_liquid = always_liquid || (!is_solid && e > line_.liquidus_energy(v.log_x));
    const V liquid_melting = select(always_liquid, V(T(0)), sqrt(max(line_.liquidus_square(v.log_x), V(T(0)))));
    const detail::volume_function<V> cold{select(is_liquid, liquid.value, solid.value), select(is_liquid, liquid.slope, solid.slope),
                                          select(is_liquid, liquid.curvature, solid.curvature)};
    const auto ls = phases_.solid_lattice(v), ll = phases_.liquid_lattice(v);
    const detail::lattice<V> own{select(is_liquid, ll.einstein, ls.einstein), select(is_liquid, ll.gamma, ls.gamma),
                                 select(is_liquid, ll.gamma_slope, ls.gamma_slope), select(is_liquid, ll.loose, ls.loose)};
    const V at_zero = select(v.log_x < V(T(line_.solid_end())), solid.value,
                             select(always_liquid, liquid.value, T(tie_energy_) - T(tie_pressure_) / rho)); // cold energy at this volume
    const V t = temperature(v, own, e - cold.value);
    const V expanded = select(x >= V(T(critical_volume_)), V(region_value<V>(region::gas)),
                              select(t > V(T(critical_.temperature)), V(region_value<V>(region::hot_liquid)), V(region_value<V>(region::liquid))));
    const thermal_point<V> pure = single(v, cold, own, rho, t, at_zero, select(is_liquid, liquid_melting, solid_melting),
                                         select(is_liquid, V(T(1)), V(T(0))), select(is_liquid, expanded, V(region_value<V>(region::solid))));
    const auto is_mixed = !is_solid && !is_liquid;
    if (!any(is_mixed)) return pure;
    const auto from_solid = v.log_x < V(T(line_.solid_end()));
    const V low = select(from_solid, solid_melting, V(T(0))), low_energy = select(from_solid, line_.solidus_energy(v.log_x), at_zero);
    const V part = clip((e - low_energy) / (line_.liquidus_energy(v.log_x) - low_energy), V(T(0)), V(T(1)));
    const V start = sqrt(low * low + part * (liquid_melting * liquid_melting - low * low)); // above the root: e(T) bends less than T^2
    return choose(is_mixed, mixture(rho, e, at_zero, max(start, V(T(1e-3))), v.log_x), pure);
  }

  /// The state at a density and a temperature > 0 K. Set-up work.
  reference_state at_temperature(double rho, double temperature) const {
    require(rho > 0, "reference density", rho, "> 0", "kg/m3");
    require(temperature > 0, "reference temperature", temperature, "> 0", "K");
    const double log_x = std::log(reference_density() / rho), square = temperature * temperature, volume = 1 / rho;
    const bool is_solid = log_x < line_.solid_end() && square < line_.solidus_square(log_x);
    const bool is_liquid = log_x >= line_.liquid_end() || square > line_.liquidus_square(log_x);
    if (is_solid || is_liquid) {
      const auto s = detail::state_of(phases_, is_liquid, log_x, temperature);
      const region where = is_solid                                    ? region::solid
                           : reference_density() / rho >= critical_volume_ ? region::gas
                           : temperature > critical_.temperature           ? region::hot_liquid
                                                                           : region::liquid;
      return {s.energy - temperature * s.entropy, s.entropy, s.energy, s.pressure, where};
    }
    const auto p = line_.pressure(temperature), g = line_.gibbs(temperature);
    const double free_energy = g.value - p.value * volume, entropy = -g.slope + p.slope * volume;
    return {free_energy, entropy, free_energy + temperature * entropy, p.value, region::mixed};
  }

  /// Solid and liquid in equilibrium at T (K): volumes, energies, entropies and p of both. Set-up work.
  detail::coexistence_point melting_at(double temperature) const {
    require(temperature >= detail::coexistence::coldest && temperature <= detail::coexistence::hottest, "reference melting temperature",
            temperature, "between 0.01 and 3e5", "K");
    return detail::equilibrium(phases_, temperature, line_.solid_volume(temperature), line_.liquid_volume(temperature));
  }

  const critical_point& critical() const { return critical_; }
  double reference_density() const { return phases_.parameters().rho0; }
  const reference_parameters& values() const { return phases_.parameters(); }
  validity_box validity() const { return {1e-6 * reference_density(), 5 * reference_density(), 0.0, 1e8}; }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    using T = scalar_t<V>;
    const validity_box box = validity();
    return rho < V(T(box.density_low)) || rho > V(T(box.density_high)) || e > V(T(box.energy_high));
  }
  /// J/kg: solidus and liquidus at a density, where c jumps; equal where there is neither.
  std::vector<double> energy_borders(double rho) const {
    const double log_x = std::log(reference_density() / rho), tie = tie_energy_ - tie_pressure_ / rho;
    const auto v = phases_.at(reference_density() / rho);
    const double zero = log_x < line_.liquid_end() ? tie : phases_.liquid_cold(v, phases_.solid_cold(v)).value;
    const double solidus = log_x < line_.solid_end() ? line_.solidus_energy(log_x) : zero;
    return {solidus, log_x < line_.liquid_end() ? line_.liquidus_energy(log_x) : zero};
  }

private:
  static constexpr int steps = 5, mixture_steps = 6; // of Newton's method; the tests count what they leave

  detail::reference_phases phases_;
  detail::coexistence line_;
  critical_point critical_;
  double R_ = 0, critical_volume_ = 0, tie_pressure_ = 0, tie_energy_ = 0;

  /// T of a phase at the energy above its cold curve. The start lies above the root for the solid, where e(T) is convex.
  template <class V> BOLIDE_INLINE V temperature(const detail::reference_volume<V>& v, const detail::lattice<V>& phase, V excess) const {
    using T = scalar_t<V>;
    const V tiny(T(1e-9)), e = max(excess, tiny), q = e * T(1 / (3 * R_));
    const auto is_liquid = phase.loose > V(T(0));
    const V vibrating = select(is_liquid, sqrt(q * (q + T(4 * 1.41421356237) * phase.einstein)) * T(0.5) + T(0.5) * q,
                               phase.einstein / log(V(T(1)) + phase.einstein / q));
    const V twice = T(2) * q, free = T(0.5) * (twice + twice * twice / (sqrt(twice * twice + T(4) * v.free * v.free) + T(2) * v.free));
    const V lattice = select(is_liquid, vibrating + free - q, vibrating), z = e * T(1 / (9 * R_));
    V t = min(lattice, z + sqrt(z * (z + T(2) * v.fermi)));
    for (int i = 0; i < steps; ++i) {
      const auto h = phases_.heat(v, phase, t);
      t = max(t - (h.energy - e) / h.heat, T(0.1) * t);
    }
    return select(excess > tiny, t, excess * T(1 / (3 * R_)));
  }

  /// The answer of one phase. At T <= 0 that of 0 K.
  template <class V>
  BOLIDE_INLINE thermal_point<V> single(const detail::reference_volume<V>& v, const detail::volume_function<V>& cold, const detail::lattice<V>& phase,
                                        V rho, V temperature, V at_zero, V melting, V fraction, V where) const {
    using T = scalar_t<V>;
    const auto warm = temperature > V(T(0));
    const V t = select(warm, temperature, V(T(1)));
    const auto f = phases_.evaluate(v, cold, phase, t);
    const V slope = select(warm, f.slope, cold.slope), curvature = select(warm, f.curvature, cold.curvature), zero(T(0));
    const V inverse = V(T(1)) / f.heat, push = select(warm, -f.cross * inverse, zero);
    return {-rho * slope, curvature - slope - t * f.cross * push, temperature, melting, fraction, at_zero, where,
            rho * push, select(warm, inverse, V(T(1 / (3 * R_))))};
  }

  /// Solid and liquid side by side; t is where the search for T starts.
  template <class V> BOLIDE_INLINE thermal_point<V> mixture(V rho, V e, V at_zero, V t, V log_x) const {
    using T = scalar_t<V>;
    const V volume = V(T(1)) / rho;
    for (int i = 0; i < mixture_steps; ++i) {
      const auto p = line_.pressure(t), g = line_.gibbs(t);
      const V energy = g.value - t * g.slope + volume * (t * p.slope - p.value), heat = t * (volume * p.curvature - g.curvature);
      t = max(t - (energy - e) / heat, T(0.1) * t);
    }
    const auto warm = e > at_zero;
    const auto p = line_.pressure(t), g = line_.gibbs(t);
    const V heat = t * (volume * p.curvature - g.curvature);
    const V inverse = V(T(1)) / heat, zero(T(0)), push = select(warm, p.slope * inverse, zero);
    const V solid = exp(line_.solid_volume(t)), liquid = exp(line_.liquid_volume(t));
    const V fraction = clip((exp(log_x) - solid) / (liquid - solid), zero, V(T(1))); // beyond by round-off only
    return {select(warm, p.value, V(T(tie_pressure_))), t * volume * volume * p.slope * push, select(warm, t, (e - at_zero) * T(1 / (3 * R_))),
            select(warm, t, zero), fraction, at_zero, V(region_value<V>(region::mixed)), push, select(warm, inverse, V(T(1 / (3 * R_))))};
  }

  template <class V> static BOLIDE_INLINE thermal_point<V> choose(mask_t<V> m, const thermal_point<V>& a, const thermal_point<V>& b) {
    return {select(m, a.pressure, b.pressure),
            select(m, a.sound_speed_squared, b.sound_speed_squared),
            select(m, a.temperature, b.temperature),
            select(m, a.melting_temperature, b.melting_temperature),
            select(m, a.melt_fraction, b.melt_fraction),
            select(m, a.cold_energy, b.cold_energy),
            select(m, a.region, b.region),
            select(m, a.pressure_energy, b.pressure_energy),
            select(m, a.temperature_energy, b.temperature_energy)};
  }
};

static_assert(ThermalEquationOfState<reference>);

} // namespace bolide::eos
