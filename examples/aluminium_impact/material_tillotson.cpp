// SPDX-License-Identifier: MIT
// --eos tillotson at its own density, with the temperature of the isentrope modifier
#include "assemble_material.hpp"

#include "bolide/eos/isentrope_temperature.hpp"

namespace impact {
template <class T> chosen_material<T> make_tillotson(const bolide::data::parameter_set& set, const settings& s) {
  using namespace bolide;
  const eos::isentrope_temperature thermal{eos::tillotson{*set.tillotson}, set.heat_capacity, room_temperature, set.melting};
  return assemble<T>(thermal, set, s, [c_v = set.heat_capacity](double, const thermal_point<double>& at) { return c_v * at.temperature; });
}
template chosen_material<double> make_tillotson<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_tillotson<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
