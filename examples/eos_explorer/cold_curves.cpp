// SPDX-License-Identifier: MIT
#include "cold_curves.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/eos/cold/birch_murnaghan.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/cold/vinet.hpp"
#include "bolide/potential/zhou04.hpp"

namespace explorer {
namespace {

any_cold make_cai_ye(const std::string& name, assignments& set) {
  bolide::cold::cai_ye_parameters q;
  set.apply({{"alpha", "eV", &q.alpha},
             {"beta", "", &q.beta},
             {"r_a", "angstrom", &q.r_a},
             {"F0", "eV", &q.F0},
             {"F1", "eV", &q.F1},
             {"n", "", &q.n},
             {"chi", "1/angstrom", &q.chi},
             {"a0", "angstrom", &q.a0},
             {"mass", "u", &q.mass},
             {"sharp_cutoff", "", &q.sharp_cutoff}});
  return any_cold(bolide::cold::cai_ye(name == "cai-ye" ? bolide::cold::cutoff::none : bolide::cold::cutoff::sharp, q));
}

any_cold make_zhou04(assignments& set) {
  bolide::potential::zhou_parameters q;
  set.apply({{"mass", "u", &q.mass}});
  return any_cold(bolide::cold::lattice(bolide::potential::zhou04(q)));
}

any_cold make_rose(assignments& set) {
  bolide::cold::rose_parameters q;
  set.apply({{"density", "kg/m3", &q.density}, {"bulk_modulus", "Pa", &q.bulk_modulus}, {"cohesive_energy", "J/kg", &q.cohesive_energy}});
  return any_cold(bolide::cold::rose(q));
}

/// vinet, bm3: the same three numbers.
template <class Cold, class Parameters> any_cold make_from_moduli(assignments& set) {
  Parameters q;
  set.apply({{"density", "kg/m3", &q.density},
             {"bulk_modulus", "Pa", &q.bulk_modulus},
             {"bulk_modulus_derivative", "", &q.bulk_modulus_derivative}});
  return any_cold(Cold(q));
}

any_cold make_exact(const std::string& name, assignments& set) {
  namespace cold = bolide::cold;
  if (name == "cai-ye" || name == "cai-ye-sharp") return make_cai_ye(name, set);
  if (name == "zhou04") return make_zhou04(set);
  if (name == "rose") return make_rose(set);
  if (name == "vinet") return make_from_moduli<cold::vinet, cold::vinet_parameters>(set);
  if (name == "bm3") return make_from_moduli<cold::birch_murnaghan, cold::birch_murnaghan_parameters>(set);
  if (name.rfind("setfl:", 0) == 0) return make_setfl(name.substr(6));
  if (name.rfind("table:", 0) == 0) return make_user_table(name.substr(6), set);
  check_cold_name(name);
  throw bolide::bad_parameter("'" + name + "': no such cold curve");
}

} // namespace

void check_cold_name(const std::string& name) {
  std::string list;
  for (const auto& entry : all_cold_curves()) {
    const std::string kind = entry.name.substr(0, entry.name.find("FILE")); // of setfl:FILE all that starts with setfl:
    if (name == entry.name || (kind != entry.name && name.rfind(kind, 0) == 0)) return;
    list += (list.empty() ? "" : ", ") + entry.name;
  }
  throw bolide::bad_parameter("'" + name + "': no such cold curve; there are " + list);
}

const std::vector<cold_entry>& all_cold_curves() {
  static const std::vector<cold_entry> all = {
      {"cai-ye", "Cai and Ye 1996; summed to 20 angstrom"},
      {"cai-ye-sharp", "Cai and Ye 1996; cut off at 1.65 a0 as published"},
      {"zhou04", "Zhou and Johnson and Wadley 2004"},
      {"rose", "Rose 1984; Johnson's nearest-neighbour potential exactly"},
      {"vinet", "Vinet 1987"},
      {"bm3", "Birch-Murnaghan of third order"},
      {"setfl:FILE", "any embedded-atom potential in setfl form (setfl:FILE:ELEMENT where there are several)"},
      {"table:FILE", "two columns of yours under a header: x or rho_kg_m3 with pressure_Pa or pressure_GPa or energy_J_kg or energy_MJ_kg"},
  };
  return all;
}

any_cold make_cold(const std::string& name, assignments& set, bool table) {
  any_cold exact = make_exact(name, set);
  if (!table) return exact;
  bolide::cold::tabulated fast(exact);
  const auto error = fast.error();
  return any_cold(std::move(fast), "table of the cold curve: measured error of pressure " + bolide::to_text(error.pressure) +
                                       " of (|p| + 1 GPa), of energy " + bolide::to_text(error.energy) +
                                       " of (|e| + 1 GPa/rho0), for x from 0.2 to 5");
}

} // namespace explorer
