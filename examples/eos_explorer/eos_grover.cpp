// SPDX-License-Identifier: MIT
// paper, mixed, helm: a cold curve and Grover's phase regions.
#include "adapted_eos.hpp"
#include "cold_curves.hpp"
#include "registry.hpp"

#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"

namespace explorer {
namespace {
template <class Phase> eos_pointer make_grover(model_choice& choice) {
  bolide::phase::grover_parameters q;
  choice.set.apply({{"R", "J/(kg K)", &q.R},
                    {"G", "J/(kg K2)", &q.G},
                    {"dS", "J/(kg K)", &q.dS},
                    {"al", "J/(kg K)", &q.al},
                    {"g0", "", &q.g0},
                    {"a", "", &q.a},
                    {"ge", "", &q.ge},
                    {"Tm0", "K", &q.Tm0},
                    {"xj", "", &q.xj}});
  any_cold cold = make_cold(choice.cold, choice.set, choice.table);
  const std::string remark = cold.remark();
  return adapt(bolide::eos::grover{std::move(cold), Phase{q}}, phases::by_region, remark);
}
} // namespace

eos_pointer make_paper(model_choice& choice) { return make_grover<bolide::phase::paper>(choice); }
eos_pointer make_mixed(model_choice& choice) { return make_grover<bolide::phase::mixed>(choice); }
eos_pointer make_helm(model_choice& choice) { return make_grover<bolide::phase::helm>(choice); }

} // namespace explorer
