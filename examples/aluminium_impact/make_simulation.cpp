// SPDX-License-Identifier: MIT
// From names to models: the only place where the choices of the command line become types.
#include "compositions.hpp"

#include "bolide/material/data/library.hpp"

namespace impact {

template <class T> chosen_material<T> make_material(const bolide::data::parameter_set& set, const settings& s) {
  if (s.eos == "paper") return make_paper<T>(set, s);
  if (s.eos == "helm") return make_helm<T>(set, s);
  if (s.eos == "reference") return make_reference<T>(set, s);
  if (s.eos == "mie-gruneisen") return make_mie_grueneisen<T>(set, s);
  if (s.eos == "tillotson") return make_tillotson<T>(set, s);
  return make_mixed<T>(set, s);
}

namespace {
template <class T> std::unique_ptr<simulation> make(const settings& s) {
  const auto ball = make_material<T>(bolide::data::find(s.projectile), s), plate = make_material<T>(bolide::data::find(s.target), s);
  if (s.shape == "linear") return compose_linear_flip<T>(s, ball, plate); // options.cpp refuses linear with apic
  return s.transfer == "flip" ? compose_bspline_flip<T>(s, ball, plate) : compose_bspline_apic<T>(s, ball, plate);
}
} // namespace

std::unique_ptr<simulation> make_simulation(const settings& s) { return s.precision == "float" ? make<float>(s) : make<double>(s); }

} // namespace impact
