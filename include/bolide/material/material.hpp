// SPDX-License-Identifier: MIT
// A material ties an equation of state, a strength, a failure law and an artificial viscosity together: the constitutive update.
//
//   D = tr L,  V <- V J,  J = det(I + dt L) with L at the beginning of the motion (MUSL), 1/det(I - dt L) with L at its end (USF)
//   s <- s + dt (Jaumann rate + 2 G dev D), then radial return to the yield stress (paper eq. 10, 11)
//   q = viscosity(rho, c, D);   p, c, T = eos(rho, e*);   failure
// Energy is not advanced here: the work of the nodal forces does that at the end of the step (solver/sweeps.hpp, `work`), so that
// total energy holds. It therefore lives at the middle of steps, and the equation of state is given the prediction
//   e* = e + dt/2 (sigma : D) / rho - e_shear,    e_shear = s:s / (4 G rho)   (elastic shear energy is no heat),
// second order in dt.
//
// Failed points. A failed point carries no shear and no tension. It fills its volume as long as its pressure there is positive. When it
// expands further, its material stays at the volume V_m of zero pressure (p(V_m, e) = 0, one Newton step per time step:
// dV = V p / (rho c^2)) and a void opens: V = V_m + void. It carries pressure again when the void has closed. Density, temperature and phase are those of V_m, so that they mean something.
// Once Newton's step is round-off the point is settled: only its void changes, and the equation of state is not asked again.
//
// Failed points that soften (failure/softening.hpp). A part d of the capacity is gone. The pressure of V_m is then held at -(1 - d) sigma_f instead
// of 0 while the void opens, and at 0 while it closes; between the two the void stays as it is and V_m takes the strain. Shear: G and Y times
// 1 - d. What the void takes up, the mean tension times its growth, and the elastic shear energy that goes are the released energy.
//
// A shear modulus that changes (with the state, or by softening) keeps the elastic strain: s <- s G_new/G_old. The elastic shear energy
// s:s/(4 G rho) changes with G and e does not, so the difference is heat: softening and melting warm, hardening cools. Total energy holds.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/concepts/failure.hpp"
#include "bolide/concepts/strength.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/material/report.hpp"
#include "bolide/viscosity/bulk.hpp"

#include <cstddef>
#include <limits>

namespace bolide {

namespace record {
/// Record nothing.
struct none { using particle_fields = fields<>; };
/// Keep the largest pressure that each particle ever had.
struct peak_pressure { using particle_fields = fields<field::peak_pressure>; };
} // namespace record

namespace detail {
/// Whatever an equation of state gives, as a thermal point (temperatures zero where it has none).
template <class Eos, class V> BOLIDE_INLINE thermal_point<V> evaluate_all(const Eos& eos, V rho, V e) {
  if constexpr (ThermalEquationOfState<Eos>) return eos.evaluate(rho, e);
  else {
    const auto p = eos.evaluate(rho, e);
    return {p.pressure, p.sound_speed_squared, V(0), V(0), V(0), V(0), V(0), V(0), V(0)};
  }
}
/// Sum of the first n lanes: pairs, then pairs of pairs, whatever n is.
template <class V> BOLIDE_INLINE double sum(V x, int n) {
  if constexpr (lane_width<V> == 1) return static_cast<double>(x);
  else {
    alignas(64) scalar_t<V> part[lane_width<V>];
    store(n >= lane_width<V> ? x : select(first_lanes<V>(n), x, V(scalar_t<V>(0))), part);
    double s[lane_width<V>];
    for (int i = 0; i < lane_width<V>; ++i) s[i] = static_cast<double>(part[i]);
    for (int half = lane_width<V> / 2; half > 0; half /= 2)
      for (int i = 0; i < half; ++i) s[i] += s[i + half];
    return s[0];
  }
}
/// A sum over particles that come in registers, the first n lanes of each.
template <class V> class lane_sum {
public:
  BOLIDE_INLINE void add(V x, int n) {
    if constexpr (std::is_same_v<scalar_t<V>, double> && (lane_width<V> > 1)) lanes_ += n >= lane_width<V> ? x : select(first_lanes<V>(n), x, V(0.0));
    else total_ += sum(x, n);
  }
  double total() const {
    if constexpr (std::is_same_v<scalar_t<V>, double> && (lane_width<V> > 1)) return sum(lanes_, lane_width<V>);
    else return total_;
  }

private:
  V lanes_{scalar_t<V>(0)};
  double total_ = 0;
};
/// |curl v|^2 of a velocity gradient whose component c dim + d is dv_c/dx_d.
template <class Space, class V> BOLIDE_INLINE V vorticity_squared(const typename Space::template gradient<V>& l) {
  constexpr std::size_t dim = Space::dim;
  V sum(scalar_t<V>(0));
  for (std::size_t c = 0; c < dim; ++c)
    for (std::size_t d = c + 1; d < dim; ++d) sum = sum + square(l[c * dim + d] - l[d * dim + c]);
  return sum;
}
/// A shear modulus in the forms that the update uses: G, 2 G, 1/(4 G), 1/(3 G). Where G = 0 the last two are 0.
template <class V> struct modulus {
  V g, twice, quarter_inverse, third_inverse;
};
/// What is the same for all particles of an update: divisions that are done once.
template <class T> struct update_constants {
  T greatest_specific_volume, reach, inverse_reach; // m3/kg, m, 1/m; reach: Courant number times cell
  modulus<T> shear;
};
template <class V> BOLIDE_INLINE modulus<V> modulus_of(V g) {
  using T = scalar_t<V>;
  const V inverse = select(g > V(T(0)), T(1) / g, V(T(0)));
  return {g, T(2) * g, T(0.25) * inverse, T(1.0 / 3) * inverse};
}
} // namespace detail

template <class Eos, class Strength, class Failure, class Viscosity = viscosity::bulk, class Record = record::none> class material {
  static_assert(bolide::EquationOfState<Eos>, "bolide: material: the first argument is no equation of state: it must have evaluate(rho, e) that "
                                              "gives pressure and sound_speed_squared, and reference_density()");
  static_assert(bolide::Strength<Strength>, "bolide: material: the second argument is no strength: it must have particle_fields, carries_shear, "
                                            "wants_temperature and, if it carries shear, shear_modulus, yield_stress and yield_floor");
  static_assert(!Strength::carries_shear || Strength::particle_fields::template contains<field::deviator>,
                "bolide: material: this strength carries shear and does not list field::deviator among its particle_fields");
  static_assert(!strength_yields<Strength> || Strength::particle_fields::template contains<field::plastic_strain>,
                "bolide: material: this strength yields and does not list field::plastic_strain among its particle_fields");
  static_assert(!VariableShearModulus<Strength> || Strength::particle_fields::template contains<field::shear_modulus>,
                "bolide: material: the shear modulus of this strength varies and it does not list field::shear_modulus among its particle_fields");
  static_assert(bolide::Failure<Failure>, "bolide: material: the third argument is no failure law: it must have particle_fields, may_fail, "
                                          "wants_temperature and, if it may fail, fails(p, T, T_m, melt_fraction)");
  static_assert(!Failure::may_fail || (Failure::particle_fields::template contains<field::failed> && Failure::particle_fields::template contains<field::material_volume>),
                "bolide: material: this failure law may fail and does not list field::failed and field::material_volume among its particle_fields");
  static_assert(!AccumulatingFailure<Failure> || Failure::particle_fields::template contains<field::damage>,
                "bolide: material: this failure law accumulates damage and does not list field::damage among its particle_fields");
  static_assert(!SofteningFailure<Failure> || (Failure::particle_fields::template contains<field::lost_capacity> &&
                                               Failure::particle_fields::template contains<field::held_tension>),
                "bolide: material: this failure law softens and does not list field::lost_capacity and field::held_tension among its particle_fields");
  static_assert(!AccumulatingFailure<Failure> || strength_yields<Strength>,
                "bolide: material: this failure law accumulates damage with plastic strain and the strength never yields; take one that does, "
                "strength::johnson_cook or strength::elastic_perfectly_plastic");
  static_assert(!Strength::wants_temperature || ThermalEquationOfState<Eos>,
                "bolide: material: this strength wants a temperature and the equation of state gives none; wrap it in eos::isentrope_temperature");
  static_assert(!Failure::wants_temperature || ThermalEquationOfState<Eos>,
                "bolide: material: this failure law wants a temperature and the equation of state gives none; wrap it in eos::isentrope_temperature");

public:
  using particle_fields = field_union_t<fields<field::mass, field::velocity, field::volume, field::energy, field::pressure>, typename Strength::particle_fields,
                                        typename Failure::particle_fields, typename Viscosity::particle_fields, typename Record::particle_fields>;
  static constexpr bool thermal = ThermalEquationOfState<Eos>;

  Eos eos;
  Strength strength;
  Failure failure;
  Viscosity viscosity;
  double sound_speed_floor = 0.05;   // least sound speed over that of the reference state
  double expansion_limit = 1e6;      // most volume over the reference volume

  material(Eos e, Strength s, Failure f, Viscosity v = Viscosity(), Record = Record())
      : eos(std::move(e)), strength(s), failure(f), viscosity(v), c2_reference_(eos.evaluate(eos.reference_density(), 0.0).sound_speed_squared) {
    require(c2_reference_ >= 0, "sound speed squared at the reference density", c2_reference_, "non-negative", "m2/s2");
    if constexpr (requires { strength.validate(); }) strength.validate();
    if constexpr (requires { failure.validate(); }) failure.validate();
  }

  /// Gives n particles from `begin` their state: density (kg/m3) and specific energy (J/kg); mass must be set.
  template <class Columns> void initialise(Columns& p, std::size_t begin, std::size_t n, double density, double energy) const {
    using T = typename Columns::scalar;
    require(density > 0, "initial density", density, "positive", "kg/m3");
    auto at = eos.evaluate(density, energy);
    require(at.sound_speed_squared >= 0, "sound speed squared of the initial state", at.sound_speed_squared, "non-negative", "m2/s2");
    constexpr double round_off = 16 * std::numeric_limits<double>::epsilon(); // what a root finder leaves of p = 0 is no pressure
    if (std::abs(at.pressure) <= round_off * density * at.sound_speed_squared) at.pressure = 0;
    for (std::size_t i = begin; i < begin + n; ++i) {
      const double mass = static_cast<double>(p.template get<field::mass>()[i]);
      p.template get<field::volume>()[i] = static_cast<T>(mass / density);
      p.template get<field::energy>()[i] = static_cast<T>(energy);
      p.template get<field::pressure>()[i] = static_cast<T>(at.pressure);
      if constexpr (Viscosity::present) p.template get<field::sound_speed>()[i] = static_cast<T>(std::sqrt(at.sound_speed_squared));
      if constexpr (Failure::may_fail) p.template get<field::material_volume>()[i] = static_cast<T>(mass / density);
      if constexpr (varies) {
        const auto thermal_state = detail::evaluate_all(eos, density, energy);
        p.template get<field::shear_modulus>()[i] =
            static_cast<T>(strength.shear_modulus_at(at.pressure, density, thermal_state.temperature, thermal_state.melting_temperature));
      }
    }
  }

  /// The constitutive update of n <= chunk_size particles from `begin`; l[c][k] is component c of the velocity gradient of particle k.
  template <class Space, class Columns>
  __attribute__((noinline)) void update(Columns& p, std::size_t begin, int n, const typename Columns::scalar (*l)[chunk_size], const step_context<typename Columns::scalar>& step,
              update_report& report) const {
    using V = native_pack<typename Columns::scalar>;
    const auto run = [&](const material& m, const auto s, const auto fixed) {
      detail::lane_sum<V> plastic_work;
      for (int k = 0; k < n; k += lane_width<V>)
        m.template update_lane<Space, V>(p, begin + static_cast<std::size_t>(k), std::min(n - k, lane_width<V>), l, k, s, fixed, plastic_work, report);
      report.plastic_work += plastic_work.total();
    };
    if constexpr (std::is_trivially_copyable_v<material>) {
      const material copy(*this); // no store to a column can change it: the compiler keeps its numbers in registers
      run(copy, step, constants(step));
    } else run(*this, step, constants(step));
  }

  /// The work of the nodal forces: e += dt sigma : D V/m with the stress that made the forces and the time-centred gradient l.
  template <class Space, class Columns>
  void work(Columns& p, std::size_t begin, int n, const typename Columns::scalar (*l)[chunk_size], typename Columns::scalar dt, update_report& report) const {
    using V = native_pack<typename Columns::scalar>;
    detail::lane_sum<V> all, viscous;
    for (int k = 0; k < n; k += lane_width<V>)
      work_lane<Space, V>(p, begin + static_cast<std::size_t>(k), std::min(n - k, lane_width<V>), l, k, dt, all, viscous);
    report.work_energy += all.total();
    report.viscous_heating += viscous.total();
  }

  /// Everything that the equation of state knows of particle i (at the material's own volume).
  template <class Columns> thermal_point<double> thermodynamics(const Columns& p, std::size_t i) const {
    const double mass = static_cast<double>(p.template get<field::mass>()[i]);
    return detail::evaluate_all(eos, mass / material_volume(p, i), static_cast<double>(p.template get<field::energy>()[i]) - shear_energy(p, i));
  }
  template <class Columns> double material_volume(const Columns& p, std::size_t i) const {
    if constexpr (Failure::may_fail)
      if (p.template get<field::failed>()[i] > 0) return static_cast<double>(p.template get<field::material_volume>()[i]);
    return static_cast<double>(p.template get<field::volume>()[i]);
  }
  /// Elastic shear energy of particle i, J/kg.
  template <class Columns> double shear_energy(const Columns& p, std::size_t i) const {
    if constexpr (Strength::carries_shear) {
      const double v = static_cast<double>(p.template get<field::volume>()[i]), m = static_cast<double>(p.template get<field::mass>()[i]);
      double g = strength.shear_modulus;
      if constexpr (varies) g = static_cast<double>(p.template get<field::shear_modulus>()[i]);
      if constexpr (softens) g *= 1 - static_cast<double>(p.template get<field::lost_capacity>()[i]);
      return g > 0 ? contract_stored(p, i) * v / (4 * g * m) : 0;
    } else return 0;
  }

  /// rho c of the reference state, Pa s/m.
  double impedance() const { return eos.reference_density() * std::sqrt(c2_reference_); }

private:
  static constexpr bool varies = Strength::carries_shear && VariableShearModulus<Strength>;
  static constexpr bool softens = SofteningFailure<Failure>;
  static constexpr bool accumulates = AccumulatingFailure<Failure>;
  double c2_reference_;

  template <class Columns> double contract_stored(const Columns& p, std::size_t i) const {
    using space = typename Columns::space;
    typename space::template deviator<double> s;
    for (int c = 0; c < space::deviator_size; ++c) s[static_cast<std::size_t>(c)] = static_cast<double>(p.template get<field::deviator>(c)[i]);
    return space::contract(s, s);
  }

  template <class Space, class V, class Columns> static BOLIDE_INLINE typename Space::template deviator<V> load_deviator(const Columns& p, std::size_t at) {
    typename Space::template deviator<V> s{};
    if constexpr (Strength::carries_shear)
      for (int c = 0; c < Space::deviator_size; ++c) s[static_cast<std::size_t>(c)] = load<V>(p.template get<field::deviator>(c) + at);
    return s;
  }
  template <class Space, class V, class Scalar> static BOLIDE_INLINE typename Space::template gradient<V> load_gradient(const Scalar (*l)[chunk_size], int k) {
    typename Space::template gradient<V> g;
    for (int c = 0; c < Space::gradient_size; ++c) g[static_cast<std::size_t>(c)] = load<V>(l[c] + k);
    return g;
  }

  template <class T> detail::update_constants<T> constants(const step_context<T>& step) const {
    detail::update_constants<T> c{static_cast<T>(expansion_limit / eos.reference_density()), step.courant * step.cell, T(1) / (step.courant * step.cell), {}};
    if constexpr (Strength::carries_shear) {
      const double g = strength.shear_modulus;
      c.shear = {static_cast<T>(g), static_cast<T>(2 * g), static_cast<T>(1 / (4 * g)), static_cast<T>(1 / (3 * g))};
    }
    return c;
  }

  /// The shear modulus that the stored deviator was made with, and the one of the new state.
  template <class V, class Columns>
  BOLIDE_INLINE detail::modulus<V> modulus_before(const Columns& p, std::size_t at, const detail::update_constants<scalar_t<V>>& fixed) const {
    if constexpr (!varies && !softens) return {V(fixed.shear.g), V(fixed.shear.twice), V(fixed.shear.quarter_inverse), V(fixed.shear.third_inverse)};
    else {
      V g(scalar_t<V>(strength.shear_modulus));
      if constexpr (varies) g = load<V>(p.template get<field::shear_modulus>() + at);
      if constexpr (softens) g = g * (scalar_t<V>(1) - load<V>(p.template get<field::lost_capacity>() + at));
      return detail::modulus_of(g);
    }
  }
  template <class V, class Columns>
  BOLIDE_INLINE detail::modulus<V> modulus_now(Columns& p, std::size_t at, int n, V pressure, V rho, const thermal_point<V>& state, V capacity,
                                                 const detail::update_constants<scalar_t<V>>& fixed) const {
    if constexpr (!varies && !softens) return modulus_before<V>(p, at, fixed);
    else {
      V g(scalar_t<V>(strength.shear_modulus));
      if constexpr (varies) {
        g = strength.shear_modulus_at(pressure, rho, state.temperature, state.melting_temperature);
        store_first(g, p.template get<field::shear_modulus>() + at, n);
      }
      return detail::modulus_of(g * capacity);
    }
  }
  template <class V> BOLIDE_INLINE V yield_floor(V pressure, V rho, const thermal_point<V>& state) const {
    if constexpr (varies) return strength.yield_floor(state.temperature, state.melting_temperature, pressure, rho);
    else return strength.yield_floor(state.temperature, state.melting_temperature);
  }
  template <class V> BOLIDE_INLINE V yield_stress(V strain, V rate, V pressure, V rho, const thermal_point<V>& state) const {
    if constexpr (varies) return strength.yield_stress(strain, rate, state.temperature, state.melting_temperature, pressure, rho);
    else return strength.yield_stress(strain, rate, state.temperature, state.melting_temperature);
  }
  /// A stress with the capacity that is left.
  template <class V> static BOLIDE_INLINE V bearing([[maybe_unused]] V capacity, V stress) {
    if constexpr (softens) return stress * capacity;
    else return stress;
  }
  /// A softening point between opening and closing: its own volume takes the strain that leads from the stored pressure to 0 or to -tension,
  /// and the void takes the rest.
  template <class V> BOLIDE_INLINE V elastic_own_volume(V own_before, V change, V mass, V pressure, V tension) const {
    using T = scalar_t<V>;
    const V zero(T(0)), per_pressure = own_before * own_before / (mass * T(c2_reference_));
    return own_before + clip(change, per_pressure * min(pressure, zero), per_pressure * max(tension + pressure, zero));
  }

  template <class Space, class V, class Columns>
  BOLIDE_INLINE void update_lane(Columns& p, std::size_t at, int n, const scalar_t<V> (*gradients)[chunk_size], int k, const step_context<scalar_t<V>>& step,
                   const detail::update_constants<scalar_t<V>>& fixed, detail::lane_sum<V>& plastic_work, update_report& report) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1)), dt(step.dt);
    const auto active = first_lanes<V>(n);
    const auto l = load_gradient<Space, V>(gradients, k);
    const V mass = load<V>(p.template get<field::mass>() + at), e = load<V>(p.template get<field::energy>() + at);
    const V p_old = load<V>(p.template get<field::pressure>() + at);

    if (at_rest<Space, V>(p, at, n, l, mass, step, fixed, report)) return;

    // kinematics
    const V divergence = Space::divergence(l);
    const V ratio = step.gradient_at_end ? one / Space::jacobian(l, -dt) : Space::jacobian(l, dt);
    const V volume_before = load<V>(p.template get<field::volume>() + at);
    V volume = volume_before * ratio;
    const V largest = mass * fixed.greatest_specific_volume;
    if (const auto over = volume > largest && active; any(over)) {
      report.floors.add(floor_kind::expansion, count(over));
      volume = select(over, largest, volume);
    }
    const V rho = mass / volume, specific_volume = one / rho;

    // elastic trial of the deviator
    auto s = load_deviator<Space, V>(p, at);
    const auto rate = Space::deviatoric_rate(l);
    V shear_power = zero, shear_energy = zero;
    [[maybe_unused]] detail::modulus<V> before{};
    if constexpr (Strength::carries_shear) {
      before = modulus_before<V>(p, at, fixed);
      shear_power = Space::contract(s, rate);
      shear_energy = Space::contract(s, s) * specific_volume * before.quarter_inverse;
      const auto spin = Space::jaumann_rate(s, l);
      for (std::size_t c = 0; c < Space::deviator_size; ++c) s[c] = s[c] + dt * (spin[c] + before.twice * rate[c]);
    }
    // the material's own volume; artificial viscosity, which a void does not carry
    V own_volume = volume;
    auto failed = volume < zero; // none
    auto gone = failed;          // failed and without any capacity left
    [[maybe_unused]] V lost_before = zero, lost = zero, held = zero, own_before = volume_before;
    if constexpr (Failure::may_fail) {
      const V state_of_failure = load<V>(p.template get<field::failed>() + at);
      failed = state_of_failure > zero;
      own_before = load<V>(p.template get<field::material_volume>() + at);
      V own_now = own_before;
      gone = failed;
      if constexpr (softens) {
        lost_before = load<V>(p.template get<field::lost_capacity>() + at);
        held = load<V>(p.template get<field::held_tension>() + at);
        lost = select(failed, failure.capacity_lost(lost_before, held, volume_before / own_before - one, step.dt, step.cell), zero);
        gone = failed && lost >= one;
        own_now = elastic_own_volume(own_before, volume - volume_before, mass, p_old, held * (one - lost));
      }
      own_volume = select(failed && own_before < volume_before, min(volume, own_now), volume); // without a void it fills all there is
      if (!any(!(state_of_failure > one && volume > own_volume) && active)) { // all settled
        store_first(volume, p.template get<field::volume>() + at, n);
        limit_step<Space, V>(p, at, n, l, divergence, zero, zero, step, fixed, report);
        return;
      }
    }
    V q = zero;
    if constexpr (Viscosity::present) {
      q = viscosity.pressure(rho, load<V>(p.template get<field::sound_speed>() + at), divergence, step.cell);
      if constexpr (requires { viscosity.factor(q, q, q); })
        q = q * viscosity.factor(divergence, detail::vorticity_squared<Space, V>(l), Space::contract(rate, rate));
      if constexpr (Failure::may_fail) q = select(failed && volume > own_volume, zero, q);
    }
    const V predicted = e - shear_energy + T(0.5) * dt * (shear_power - (p_old + q) * divergence) * specific_volume;

    // equation of state
    V own_rho = rho;
    if constexpr (Failure::may_fail)
      if (any(failed && active)) own_rho = mass / own_volume;
    const thermal_point<V> state = detail::evaluate_all(eos, own_rho, predicted);
    V pressure = state.pressure;
    const V c2_floor(T(sound_speed_floor * sound_speed_floor * c2_reference_));
    if (const auto low = !(state.sound_speed_squared >= c2_floor) && active; any(low)) report.floors.add(floor_kind::sound_speed, count(low));
    const V c2 = max(c2_floor, state.sound_speed_squared); // in this order NaN stays NaN and is seen
    if constexpr (thermal)
      if (const auto below = state.temperature < zero && active; any(below)) report.floors.add(floor_kind::cold_energy, count(below));
    if constexpr (requires { eos.outside_validity(own_rho, predicted); })
      if (const auto outside = eos.outside_validity(own_rho, predicted) && active; any(outside)) report.floors.add(floor_kind::validity, count(outside));

    // failure, and the void that opens around failed material
    if constexpr (Failure::may_fail) {
      auto now = !failed && failure.fails(pressure, state.temperature, state.melting_temperature, state.melt_fraction);
      if constexpr (accumulates) now = now || (!failed && load<V>(p.template get<field::damage>() + at) >= one);
      const V tension = min(pressure, zero);
      if constexpr (softens) held = select(now, -tension, held);
      else {
        if (any(now && active)) { // elastic energy p^2 / (2 rho c^2) and that of shear turn to heat
          const V released = select(now, volume * T(0.5) * tension * tension / (rho * c2) + mass * shear_energy, zero);
          report.failure_release += detail::sum(released, n);
        }
        gone = gone || now;
      }
      failed = failed || now;
      if (any(failed && active)) {
        V target = zero; // of the pressure while a void opens or closes
        if constexpr (softens) target = min(max(pressure, -held * (one - lost)), zero);
        const V step_back = (pressure - target) / (own_rho * c2);
        const V limited = clip(step_back, V(T(-0.2)), V(T(0.25)));
        const auto open = volume > own_volume || pressure < target;
        if (const auto cut = failed && open && active && limited != step_back; any(cut)) report.floors.add(floor_kind::void_iteration, count(cut));
        const V without_void = select(failed && open, min(volume, own_volume * (one + limited)), volume);
        pressure = select(failed && open, target, pressure);
        store_first(without_void, p.template get<field::material_volume>() + at, n);
        const auto settled = gone && volume > own_volume && abs(step_back) <= V(T(8) * std::numeric_limits<T>::epsilon());
        store_first(select(failed, select(settled, V(T(2)), one), zero), p.template get<field::failed>() + at, n);
        if constexpr (softens) {
          const V opened = max((volume - without_void) - (volume_before - own_before), zero), part = (lost - lost_before) / max(one - lost_before, V(T(1e-30)));
          const V released = select(failed && !now, -T(0.5) * (min(p_old, zero) + min(pressure, zero)) * opened + mass * shear_energy * part, zero);
          report.failure_release += detail::sum(released, n);
          store_first(lost, p.template get<field::lost_capacity>() + at, n);
          store_first(held, p.template get<field::held_tension>() + at, n);
        }
      }
    }

    // radial return; a square root only where the cheap bound of the yield stress is passed
    auto empty = own_volume < volume;
    if constexpr (softens) empty = empty && gone;
    V wave2 = select(empty, zero, c2); // an open void carries no wave
    if constexpr (Strength::carries_shear) {
      const V capacity = one - lost;
      const auto g = modulus_now<V>(p, at, n, pressure, own_rho, state, capacity, fixed);
      if constexpr (varies || softens) {
        const V change = select(before.g > zero, g.g / max(before.g, V(std::numeric_limits<T>::min())), zero); // the elastic strain is kept
        for (std::size_t c = 0; c < Space::deviator_size; ++c) s[c] = s[c] * change;
      }
      if constexpr (strength_yields<Strength>) {
        const V equivalent2 = T(1.5) * Space::contract(s, s);
        const auto may_yield = !gone && equivalent2 > square(bearing(capacity, yield_floor(pressure, own_rho, state)));
        if (any(may_yield && active)) {
          const V equivalent = sqrt(equivalent2), rate_equivalent = sqrt(T(2.0 / 3) * Space::contract(rate, rate));
          const V strain = load<V>(p.template get<field::plastic_strain>() + at);
          V yield = bearing(capacity, yield_stress(strain, rate_equivalent, pressure, own_rho, state));
          const auto yields = may_yield && equivalent > yield;
          V increment = select(yields, (equivalent - yield) * g.third_inverse, zero);
          if constexpr (requires { strength.hardening_modulus; }) {
            const T h = T(strength.hardening_modulus);
            increment = select(yields, (equivalent - yield) / (T(3) * g.g + h * capacity), zero);
            plastic_work.add(volume * (yield + T(0.5) * h * capacity * increment) * increment, n);
            yield = yield + h * capacity * increment;
          } else plastic_work.add(volume * yield * increment, n);
          const V scale = select(yields, yield / equivalent, one);
          for (std::size_t c = 0; c < Space::deviator_size; ++c) s[c] = s[c] * scale;
          store_first(strain + increment, p.template get<field::plastic_strain>() + at, n);
          if constexpr (accumulates) {
            const V gain = failure.damage_increment(increment, rate_equivalent, pressure, yield, state.temperature, state.melting_temperature);
            const V damage = load<V>(p.template get<field::damage>() + at);
            store_first(min(damage + select(yields, gain, zero), one), p.template get<field::damage>() + at, n);
          }
        }
      }
      for (int c = 0; c < Space::deviator_size; ++c)
        store_first(select(gone, zero, s[static_cast<std::size_t>(c)]), p.template get<field::deviator>(c) + at, n);
      wave2 = wave2 + select(gone, zero, T(4.0 / 3) * g.g * specific_volume);
    }

    store_first(volume, p.template get<field::volume>() + at, n);
    store_first(pressure, p.template get<field::pressure>() + at, n);
    const V sound_speed = sqrt(c2);
    if constexpr (Viscosity::present) {
      store_first(q, p.template get<field::viscous_pressure>() + at, n);
      store_first(sound_speed, p.template get<field::sound_speed>() + at, n);
    }
    if constexpr (particle_fields::template contains<field::peak_pressure>)
      store_first(max(pressure, load<V>(p.template get<field::peak_pressure>() + at)), p.template get<field::peak_pressure>() + at, n);

    limit_step<Space, V>(p, at, n, l, divergence, wave2, sound_speed, step, fixed, report);
  }

  /// A strain increment below the machine epsilon changes no volume and no pressure: sound material that is not being deformed keeps its
  /// state as it is (most of a target is so for most of a run), and only asks for its time step.
  template <class Space, class V, class Columns>
  BOLIDE_INLINE bool at_rest(Columns& p, std::size_t at, int n, const typename Space::template gradient<V>& l, V mass,
                             const step_context<scalar_t<V>>& step, const detail::update_constants<scalar_t<V>>& fixed, update_report& report) const {
    using T = scalar_t<V>;
    if constexpr (!Viscosity::present) return false;
    else {
      auto active = !(Space::magnitude(l) * step.dt <= V(std::numeric_limits<T>::epsilon() / 2)); // NaN is not at rest
      if constexpr (Failure::may_fail) active = active || load<V>(p.template get<field::failed>() + at) > V(T(0));
      if (any(active && first_lanes<V>(n))) return false;
      const V c = load<V>(p.template get<field::sound_speed>() + at);
      V wave2 = c * c;
      if constexpr (Strength::carries_shear && !varies) wave2 = wave2 + T(4.0 / 3 * strength.shear_modulus) * load<V>(p.template get<field::volume>() + at) / mass;
      if constexpr (varies) wave2 = wave2 + T(4.0 / 3) * load<V>(p.template get<field::shear_modulus>() + at) * load<V>(p.template get<field::volume>() + at) / mass;
      store_first(V(T(0)), p.template get<field::viscous_pressure>() + at, n);
      limit_step<Space, V>(p, at, n, l, V(T(0)), wave2, c, step, fixed, report);
      return true;
    }
  }

  /// Finds the particle that asks for the shortest step: courant h / (Q + sqrt(Q^2 + c^2) + |v|), and 0.25 / |L|.
  template <class Space, class V, class Columns>
  BOLIDE_INLINE void limit_step(const Columns& p, std::size_t at, int n, const typename Space::template gradient<V>& l, V divergence, V wave2, V sound_speed,
                                const step_context<scalar_t<V>>& step, const detail::update_constants<scalar_t<V>>& fixed, update_report& report) const {
    using T = scalar_t<V>;
    if (!(report.limit.rate == report.limit.rate)) return; // NaN was found before: its particle is the one to name
    const V q_speed = select(wave2 > V(T(0)), viscosity.signal_speed(sound_speed, divergence, step.cell), V(T(0)));
    const V strain = Space::magnitude(l) * T(4);
    const T asked = static_cast<T>(std::max(report.limit.rate, step.ignore_below));
    V v2(T(0));
    for (int d = 0; d < Space::dim; ++d) v2 = v2 + square(load<V>(p.template get<field::velocity>(d) + at));
    // Without a square root: sqrt(a) + sqrt(b) <= m  <=>  m >= 0, a + b <= m^2 and 4 a b <= (m^2 - a - b)^2; here a = Q^2 + c^2, b = v^2, m = h asked - Q
    const V m = asked * fixed.reach - q_speed, m2 = m * m * T(1 - 16 * std::numeric_limits<T>::epsilon());
    const V wave = q_speed * q_speed + wave2, rest = m2 - wave - v2;
    const auto slow = m >= V(T(0)) && rest >= V(T(0)) && T(4) * wave * v2 <= rest * rest && strain <= V(asked);
    if (!any(!slow && first_lanes<V>(n))) return;
    const V signal = q_speed + sqrt(q_speed * q_speed + wave2), speed = sqrt(v2);
    const V travel = (signal + speed) * fixed.inverse_reach;
    const V wanted = max(strain, travel); // in this order NaN stays NaN
    const T best = static_cast<T>(report.limit.rate);
    if (!any(!(wanted <= V(best)) && first_lanes<V>(n))) return; // NaN counts as too fast
    for (int i = 0; i < n; ++i) {
      const double r = static_cast<double>(lane(wanted, i));
      if (r <= report.limit.rate) continue;
      report.limit.rate = r;
      report.limit.particle = p.id()[at + static_cast<std::size_t>(i)];
      const T w = std::sqrt(lane(wave2, i));
      report.limit.cause = lane(strain, i) > lane(travel, i)                                ? step_cause::strain
                           : lane(speed, i) > lane(signal, i)                               ? step_cause::velocity
                           : lane(signal, i) - w > w                                        ? step_cause::viscosity
                                                                                            : step_cause::sound;
      if (!(r == r)) return;
    }
  }

  template <class Space, class V, class Columns>
  BOLIDE_INLINE void work_lane(Columns& p, std::size_t at, int n, const scalar_t<V> (*gradients)[chunk_size], int k, scalar_t<V> dt,
                               detail::lane_sum<V>& all, detail::lane_sum<V>& viscous_part) const {
    const auto l = load_gradient<Space, V>(gradients, k);
    const V divergence = Space::divergence(l);
    const V volume = load<V>(p.template get<field::volume>() + at), mass = load<V>(p.template get<field::mass>() + at);
    V power = -load<V>(p.template get<field::pressure>() + at) * divergence;
    if constexpr (Viscosity::present) {
      const V viscous = -load<V>(p.template get<field::viscous_pressure>() + at) * divergence;
      power = power + viscous;
      viscous_part.add(volume * viscous * dt, n);
    }
    if constexpr (Strength::carries_shear) power = power + Space::contract(load_deviator<Space, V>(p, at), Space::deviatoric_rate(l));
    const V gain = dt * power * volume;
    all.add(gain, n);
    store_first(load<V>(p.template get<field::energy>() + at) + gain / mass, p.template get<field::energy>() + at, n);
  }
};

} // namespace bolide
