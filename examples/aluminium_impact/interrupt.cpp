// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace impact {
namespace {
volatile std::sig_atomic_t signal_that_came = 0;
extern "C" void note_signal(int number) { signal_that_came = number; }
} // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART); // the second signal has its usual effect
  for (const int number : {SIGINT, SIGTERM}) sigaction(number, &action, nullptr);
}

int interrupted() { return signal_that_came; }

} // namespace impact
