// SPDX-License-Identifier: MIT
// The materials of the library as this program offers them.
#pragma once

#include <iosfwd>
#include <string>

namespace impact {

/// The table of --list-materials.
void print_materials(std::ostream& to);

/// Throws bad_parameter unless the library has the material `name` and parameters for `eos`. `label` is the option's name.
void check_material(const std::string& name, const std::string& eos, const std::string& label);

/// A pressure (Pa) that no particle should exceed in earnest when bodies of these materials meet at closing speed U (m/s): the larger
/// of the detachment and the jet stagnation pressure at the contact line, on the Mie-Grueneisen Hugoniot; of unlike materials the
/// larger of what each would have against itself. NaN where there is no attached shock to detach (slow impacts).
double contact_line_reference(const std::string& projectile, const std::string& target, double speed);

} // namespace impact
