// SPDX-License-Identifier: MIT
// The umbrella for users. No library header includes it; gsl/ and png/ are optional targets and included on their own.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"
#include "bolide/core/quantity.hpp"
#include "bolide/core/unit.hpp"

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/concepts/phase_solver.hpp"
