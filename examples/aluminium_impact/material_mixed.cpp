// SPDX-License-Identifier: MIT
// --eos mixed
#include "assemble_grover.hpp"

#include "bolide/eos/phase/mixed.hpp"

namespace impact {
template <class T> chosen_material<T> make_mixed(const bolide::data::parameter_set& set, const settings& s) {
  return assemble_grover<T, bolide::phase::mixed>(set, s);
}
template chosen_material<double> make_mixed<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_mixed<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
