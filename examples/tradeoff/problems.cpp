// SPDX-License-Identifier: MIT
#include "problems.hpp"

namespace tradeoff {

std::vector<problem> matrix_problems() {
  return {plate_impact_paper(), plate_impact_steel(), noh_sphere(), taylor_copper(), taylor_steel(), breathing_aluminium(), breathing_lead(), paper_impact()};
}
std::vector<problem> judge_problems() {
  return {plate_impact_copper(), plate_impact_tillotson(), sod_tube(), noh_cylinder(), taylor_aluminium(), breathing_steel()};
}

} // namespace tradeoff
