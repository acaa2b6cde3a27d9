// SPDX-License-Identifier: MIT
// Ctrl-C (SIGINT) and SIGTERM end the run at the next step, so that all files are finished. A second one ends the program at once.
#pragma once

namespace impact {

void catch_interrupts();
/// The signal that came, or 0.
int interrupted();

} // namespace impact
