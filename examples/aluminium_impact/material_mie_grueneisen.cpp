// SPDX-License-Identifier: MIT
// --eos mie-gruneisen, with the temperature of the isentrope modifier
#include "assemble_material.hpp"

#include "bolide/eos/isentrope_temperature.hpp"

namespace impact {
template <class T> chosen_material<T> make_mie_grueneisen(const bolide::data::parameter_set& set, const settings& s) {
  using namespace bolide;
  const eos::isentrope_temperature thermal{eos::mie_grueneisen{set.mie_grueneisen}, set.heat_capacity, room_temperature, set.melting};
  return assemble<T>(thermal, set, s, [c_v = set.heat_capacity](double, const thermal_point<double>& at) { return c_v * at.temperature; });
}
template chosen_material<double> make_mie_grueneisen<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_mie_grueneisen<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
