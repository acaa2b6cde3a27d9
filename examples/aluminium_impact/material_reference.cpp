// SPDX-License-Identifier: MIT
// --eos reference
#include "assemble_material.hpp"

#include "bolide/eos/reference.hpp"
#include "bolide/eos/scaled_density.hpp"

namespace impact {
/// Its density is scaled so that the body starts at the material's density, as Grover's is.
template <class T> chosen_material<T> make_reference(const bolide::data::parameter_set& set, const settings& s) {
  using namespace bolide;
  const eos::reference base;
  const double unscaled = s.initial == "cold" ? base.reference_density() : eos::ambient_state(base, room_temperature).density;
  const eos::scaled_density scaled{base, set.density / unscaled};
  const auto thermal = [base, factor = scaled.factor()](double density, const thermal_point<double>& at) { // the free energy's, from T
    return at.temperature > 0 ? base.at_temperature(density / factor, at.temperature).energy - at.cold_energy : 0.0;
  };
  return assemble<T>(scaled, set, s, thermal);
}
template chosen_material<double> make_reference<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_reference<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
