// SPDX-License-Identifier: MIT
// reference: the calibrated free energy of aluminium.
#include "adapted_eos.hpp"
#include "registry.hpp"

#include "bolide/eos/reference.hpp"

namespace explorer {

eos_pointer make_reference(model_choice& choice) {
  bolide::eos::reference_parameters q;
  choice.set.apply({{"atomic_mass", "u", &q.atomic_mass},
                    {"statistical_weight", "", &q.statistical_weight},
                    {"G", "J/(kg K2)", &q.G},
                    {"electron_saturation", "", &q.electron_saturation},
                    {"E_coh", "J/kg", &q.E_coh},
                    {"rho0", "kg/m3", &q.rho0},
                    {"K0", "Pa", &q.K0},
                    {"eta", "", &q.eta},
                    {"delta", "", &q.delta},
                    {"theta", "K", &q.theta},
                    {"b", "", &q.b},
                    {"b_liquid", "", &q.b_liquid},
                    {"x_gamma", "", &q.x_gamma},
                    {"n", "", &q.n},
                    {"dS", "J/(kg K)", &q.dS},
                    {"c", "", &q.c},
                    {"x_join", "", &q.x_join},
                    {"b0", "J/kg", &q.b0},
                    {"b1", "J/kg", &q.b1},
                    {"b2", "J/kg", &q.b2},
                    {"b3", "J/kg", &q.b3}});
  return adapt_or_tabulate(bolide::eos::reference(q), phases::by_region, choice.table);
}

} // namespace explorer
