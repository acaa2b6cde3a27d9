// SPDX-License-Identifier: MIT
// The equations of state by name.
#pragma once

#include "any_eos.hpp"
#include "parameters.hpp"

#include <string>
#include <vector>

namespace explorer {

/// What of the command line chooses a model.
struct model_choice {
  std::string eos = "mixed", cold = "cai-ye";
  assignments set;
  bool table = false;
};

struct eos_entry {
  std::string name, source;
  bool aluminium; // its defaults are aluminium's
  eos_pointer (*make)(model_choice&);
};
const std::vector<eos_entry>& all_equations_of_state();
const eos_entry& find_eos(const std::string& name);

/// The model with all of its parameters; throws bolide::bad_parameter for names that nobody knows.
eos_pointer make_eos(model_choice& choice);

// One file of makers each.
eos_pointer make_paper(model_choice&);
eos_pointer make_mixed(model_choice&);
eos_pointer make_helm(model_choice&);
eos_pointer make_reference(model_choice&);
eos_pointer make_mie_grueneisen(model_choice&);
eos_pointer make_tillotson(model_choice&);
eos_pointer make_ideal_gas(model_choice&);
eos_pointer make_stiffened_gas(model_choice&);
eos_pointer make_jwl(model_choice&);

} // namespace explorer
