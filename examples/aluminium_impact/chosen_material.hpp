// SPDX-License-Identifier: MIT
// A material chosen at run time: the equations of state are compiled in units of their own (material_*.cpp), the solver in others
// (composition_*.cpp), and meet through any_material, so that six of the one and twelve of the other do not make sixty.
#pragma once

#include "settings.hpp"

#include "bolide/material/any_material.hpp"
#include "bolide/material/data/parameter_set.hpp"
#include "bolide/space/axisymmetric.hpp"

#include <functional>

namespace impact {

inline constexpr double room_temperature = 293; // K

template <class T> struct chosen_material {
  bolide::any_material<T, bolide::space::axisymmetric> material;
  double density, energy; // kg/m3, J/kg, at the start
  /// The thermal energy (J/kg) of a state from its temperature, region and melt fraction: the inverse of T(e), so that the thermal
  /// channel of the ledger is no remainder.
  std::function<double(double density, const bolide::thermal_point<double>&)> thermal_energy;
};

template <class T> chosen_material<T> make_paper(const bolide::data::parameter_set&, const settings&);
template <class T> chosen_material<T> make_mixed(const bolide::data::parameter_set&, const settings&);
template <class T> chosen_material<T> make_helm(const bolide::data::parameter_set&, const settings&);
template <class T> chosen_material<T> make_reference(const bolide::data::parameter_set&, const settings&);
template <class T> chosen_material<T> make_mie_grueneisen(const bolide::data::parameter_set&, const settings&);
template <class T> chosen_material<T> make_tillotson(const bolide::data::parameter_set&, const settings&);

/// By the name of settings::eos.
template <class T> chosen_material<T> make_material(const bolide::data::parameter_set&, const settings&);

} // namespace impact
