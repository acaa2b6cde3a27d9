// SPDX-License-Identifier: MIT
// Plate impact in Mie-Grueneisen metals and in Tillotson's aluminium.
#include "plate.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/material/data/aluminium.hpp"
#include "bolide/material/data/copper.hpp"
#include "bolide/material/data/iron.hpp"
#include "bolide/material/data/lead.hpp"
#include "bolide/material/data/steel_4340.hpp"
#include "bolide/material/data/tungsten.hpp"

namespace tradeoff {
namespace {
problem of_metal(std::string name, const bolide::data::parameter_set& set, double speed) {
  return plate_problem_of(std::move(name), bolide::eos::mie_grueneisen{set.mie_grueneisen}, {set.mie_grueneisen.rho0, 0}, speed);
}
} // namespace

problem plate_impact_steel() { return of_metal("plate impact, steel at 3 km/s", bolide::data::steel_4340, 3000); }
problem plate_impact_fast() { return of_metal("plate impact, aluminium at 12 km/s", bolide::data::aluminium, 12000); }
problem plate_impact_tungsten() { return of_metal("plate impact, tungsten at 4 km/s", bolide::data::tungsten, 4000); }
problem plate_impact_copper() { return of_metal("plate impact, copper at 2 km/s", bolide::data::copper, 2000); }
problem plate_impact_tillotson() { return plate_problem_of("plate impact, Tillotson at 9 km/s", bolide::eos::tillotson{}, {2700, 0}, 9000); }
problem plate_impact_lead() { return of_metal("plate impact, lead at 1.2 km/s", bolide::data::lead, 1200); }
problem plate_impact_iron() { return plate_problem_of("plate impact, Tillotson's iron at 6 km/s", bolide::eos::tillotson{*bolide::data::iron.tillotson}, {7800, 0}, 6000); }

} // namespace tradeoff
