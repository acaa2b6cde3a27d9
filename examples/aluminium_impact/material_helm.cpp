// SPDX-License-Identifier: MIT
// --eos helm
#include "assemble_grover.hpp"

#include "bolide/eos/phase/helm.hpp"

namespace impact {
template <class T> chosen_material<T> make_helm(const bolide::data::parameter_set& set, const settings& s) {
  return assemble_grover<T, bolide::phase::helm>(set, s);
}
template chosen_material<double> make_helm<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_helm<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
