// SPDX-License-Identifier: MIT
// mie-gruneisen, tillotson, ideal-gas, stiffened-gas, jwl: closed formulae, as the literature has them.
#include "adapted_eos.hpp"
#include "registry.hpp"

#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"

namespace explorer {

eos_pointer make_mie_grueneisen(model_choice& choice) {
  bolide::eos::mie_grueneisen_parameters q;
  double constant_gamma = 0, fading_expansion = 0; // the forms of expansion beside the literature's: 1 chooses one
  choice.set.apply({{"rho0", "kg/m3", &q.rho0},
                    {"c0", "m/s", &q.c0},
                    {"s", "", &q.s},
                    {"s2", "s/m", &q.s2},
                    {"gamma0", "", &q.gamma0},
                    {"gamma_far", "", &q.gamma_far},
                    {"guard", "", &q.guard},
                    {"constant_gamma", "", &constant_gamma},
                    {"fading_expansion", "", &fading_expansion}});
  q.constant_gamma = constant_gamma != 0;
  q.fading_expansion = fading_expansion != 0;
  return adapt_or_tabulate(bolide::eos::mie_grueneisen(q), phases::single, choice.table);
}

eos_pointer make_tillotson(model_choice& choice) {
  bolide::eos::tillotson_parameters q;
  choice.set.apply({{"rho0", "kg/m3", &q.rho0},
                    {"a", "", &q.a},
                    {"b", "", &q.b},
                    {"A", "Pa", &q.A},
                    {"B", "Pa", &q.B},
                    {"E0", "J/kg", &q.E0},
                    {"alpha", "", &q.alpha},
                    {"beta", "", &q.beta},
                    {"Eiv", "J/kg", &q.E_iv},
                    {"Ecv", "J/kg", &q.E_cv}});
  return adapt_or_tabulate(bolide::eos::tillotson(q), phases::by_formula, choice.table);
}

eos_pointer make_ideal_gas(model_choice& choice) {
  bolide::eos::ideal_gas_parameters q;
  choice.set.apply({{"gamma", "", &q.gamma}, {"c_v", "J/(kg K)", &q.c_v}, {"rho0", "kg/m3", &q.rho0}});
  return adapt_or_tabulate(bolide::eos::ideal_gas(q), phases::single, choice.table);
}

eos_pointer make_stiffened_gas(model_choice& choice) {
  bolide::eos::stiffened_gas_parameters q;
  choice.set.apply({{"gamma", "", &q.gamma}, {"p_inf", "Pa", &q.p_inf}, {"rho0", "kg/m3", &q.rho0}});
  return adapt_or_tabulate(bolide::eos::stiffened_gas(q), phases::single, choice.table);
}

eos_pointer make_jwl(model_choice& choice) {
  bolide::eos::jwl_parameters q;
  for (const char* name : {"rho0", "A", "B", "R1", "R2", "omega"})
    if (!choice.set.sets(name))
      throw bolide::bad_parameter(std::string("'jwl' has no default parameters (a fit belongs to one explosive): --set ") + name + "=... is missing");
  choice.set.apply({{"rho0", "kg/m3", &q.rho0},
                    {"A", "Pa", &q.A},
                    {"B", "Pa", &q.B},
                    {"R1", "", &q.R1},
                    {"R2", "", &q.R2},
                    {"omega", "", &q.omega}});
  return adapt_or_tabulate(bolide::eos::jwl(q), phases::single, choice.table);
}

} // namespace explorer
