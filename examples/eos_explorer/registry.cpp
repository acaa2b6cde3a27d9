// SPDX-License-Identifier: MIT
#include "registry.hpp"

#include "cold_curves.hpp"

#include "bolide/core/contract.hpp"

namespace explorer {

const std::vector<eos_entry>& all_equations_of_state() {
  static const std::vector<eos_entry> all = {
      {"paper", "phase parameters of the paper (section 3)", true, make_paper},
      {"mixed", "phase parameters of the paper; with a mixed phase", true, make_mixed},
      {"helm", "phase parameters of the paper; one free energy", true, make_helm},
      {"reference", "one free energy of aluminium fitted to measurements (docs/eos.md)", true, make_reference},
      {"mie-gruneisen", "2024-T4: LASL shock data (from memory)", true, make_mie_grueneisen},
      {"tillotson", "aluminium as in public codes (Ecv also printed as 15 MJ/kg)", true, make_tillotson},
      {"ideal-gas", "air", false, make_ideal_gas},
      {"stiffened-gas", "water", false, make_stiffened_gas},
      {"jwl", "a fit belongs to one explosive: rho0 A B R1 R2 omega", false, make_jwl},
  };
  return all;
}

const eos_entry& find_eos(const std::string& name) {
  std::string list;
  for (const auto& entry : all_equations_of_state()) {
    if (entry.name == name) return entry;
    list += (list.empty() ? "" : ", ") + entry.name;
  }
  throw bolide::bad_parameter("'" + name + "': no such equation of state; there are " + list);
}

eos_pointer make_eos(model_choice& choice) {
  const eos_entry& entry = find_eos(choice.eos);
  check_cold_name(choice.cold); // whether it is used or not
  eos_pointer eos = entry.make(choice);
  choice.set.check(choice.eos);
  return eos;
}

} // namespace explorer
