// SPDX-License-Identifier: MIT
// The paper's equation of state, 6.64 km/s, from the cold state (its Hugoniot from 293 K has three roots near 150 GPa), exact or as a table.
#include "plate.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/tabulated.hpp"

namespace tradeoff {

problem plate_impact_paper() {
  using namespace bolide;
  const eos::grover exact{cold::tabulated{cold::cai_ye{}}, phase::paper{}};
  const initial_state cold{exact.reference_density(), 0};
  problem p = plate_problem_of("plate impact, paper's EOS", exact, cold, 6640);
  const auto f = figures_of_plates(exact, cold, 6640);
  p.has_table = true;
  p.measure = [f, exact_material = fluid(exact, cold), exact, cold](const settings& s) {
    if (!s.table) return measure_plates(s, f, exact_material);
    static const chosen_material table = fluid(eos::tabulated{exact}, cold);
    return measure_plates(s, f, table);
  };
  return p;
}

} // namespace tradeoff
