// SPDX-License-Identifier: MIT
#include "problems.hpp"

namespace tradeoff {

std::vector<problem> matrix_problems() {
  return {plate_impact_paper(), plate_impact_steel(), plate_impact_fast(), sod_tube(), light_tube(), noh_sphere(), taylor_copper(), taylor_steel(), taylor_steel_slow(),
          breathing_aluminium(), breathing_lead(), breathing_glass(), paper_impact(), thick_impact()};
}
std::vector<problem> judge_problems() {
  std::vector<problem> all = {plate_impact_copper(), plate_impact_tillotson(), plate_impact_tungsten(), noh_cylinder(), taylor_aluminium(), taylor_iron(), breathing_steel(), breathing_tungsten()};
  for (problem& p : all)
    if (p.kind == "plasticity") p.ladder.resize(3); // 1 % is reached there
  return all;
}
std::vector<problem> fresh_problems() {
  std::vector<problem> all = {plate_impact_lead(), plate_impact_iron(), strong_tube(), taylor_nickel(), breathing_copper(), slower_impact()};
  all[3].ladder.resize(3); // as in judge_problems()
  return all;
}

} // namespace tradeoff
