// SPDX-License-Identifier: MIT
// --eos paper
#include "assemble_grover.hpp"

#include "bolide/eos/phase/paper.hpp"

namespace impact {
template <class T> chosen_material<T> make_paper(const bolide::data::parameter_set& set, const settings& s) {
  return assemble_grover<T, bolide::phase::paper>(set, s);
}
template chosen_material<double> make_paper<double>(const bolide::data::parameter_set&, const settings&);
template chosen_material<float> make_paper<float>(const bolide::data::parameter_set&, const settings&);
} // namespace impact
