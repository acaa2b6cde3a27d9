// SPDX-License-Identifier: MIT
// The problems, each in a file of its own that says what its error is. All are in r-z, so that every composition is compiled once.
//
//   name          in tables and files
//   kind          of errors: problems of one kind are expected to lose accuracy in the same way. "shock" (of a metal), "gas" (its tubes),
//                 "convergence", "plasticity", "wave", "impact"
//   length        m, what `settings::cells` counts: cell = length / cells
//   extent        how much material: its area in the r-z plane over length^2, or, in a tube of four cells' width, its length over `length`
//   duration      time x fastest speed (sound + material) over length: what steps are counted by
//   strength      what tells problems of one kind apart: share of volume that a shock takes; rho v^2/Y of a bar; Poisson's ratio of a sphere; dimensions that gas
//                 converges in; speed over sound speed of an impact
//   ladder        cells of the matrix, coarse to fine, each twice the one before
// The judge's problems are not in the matrix: the table that the advisor reads has never seen them.
#pragma once

#include "settings.hpp"

#include <functional>

namespace tradeoff {

struct problem {
  std::string name, kind, measure_text;
  double length = 0, extent = 0, duration = 0, strength = 1;
  bool tube = false, has_table = false;
  std::vector<double> ladder{};
  std::function<outcome(const settings&)> measure{}; // throws failed_run
};

// in the matrix
problem plate_impact_paper();   // the paper's equation of state, 6.64 km/s
problem plate_impact_steel();   // Mie-Grueneisen, 3 km/s
problem plate_impact_fast();    // Mie-Grueneisen aluminium, 12 km/s
problem noh_sphere();           // an ideal gas falls into one point
problem sod_tube();
problem light_tube();           // pressure ratio 30, gamma 1.4
problem taylor_copper();        // 190 m/s
problem taylor_steel();         // 300 m/s
problem taylor_steel_slow();    // 200 m/s
problem breathing_aluminium();
problem breathing_lead();
problem breathing_glass();
problem paper_impact();         // the paper's case
problem thick_impact();         // 8 mm on 3 mm at 4.5 km/s

// for the judge
problem plate_impact_copper();  // Mie-Grueneisen, 2 km/s
problem plate_impact_tillotson(); // Tillotson's aluminium, 9 km/s
problem noh_cylinder();         // falls onto a line
problem taylor_aluminium();     // 250 m/s, a slender bar
problem breathing_steel();
problem plate_impact_tungsten(); // Mie-Grueneisen, 4 km/s
problem taylor_iron();          // 220 m/s
problem breathing_tungsten();

// for the judge, and defined after the advisor: nothing in it was changed with an eye on them
problem plate_impact_lead();    // Mie-Grueneisen, 1.2 km/s
problem plate_impact_iron();    // Tillotson's iron, 6 km/s
problem strong_tube();          // pressure ratio 100, gamma 5/3
problem taylor_nickel();        // 250 m/s
problem breathing_copper();
problem slower_impact();        // 6 mm on 1.5 mm at 5 km/s

std::vector<problem> matrix_problems();
std::vector<problem> judge_problems();
std::vector<problem> fresh_problems();

} // namespace tradeoff
