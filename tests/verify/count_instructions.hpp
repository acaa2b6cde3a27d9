// SPDX-License-Identifier: MIT
// How many instructions does the processor execute in f()? A child process runs f between two stops and is stepped through it one instruction at a time
// (ptrace): exact, the same in every run, no tool and no counter of the machine needed. Some 2 us per instruction: f should have less than a million.
#pragma once

#include <sys/ptrace.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace bolide::verify {

/// -1: this machine does not let a process step its child. f runs in the child: nothing that it does is seen here.
template <class F> long instructions_of(F&& f) {
  const pid_t child = fork();
  if (child == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
    raise(SIGSTOP);
    f();
    raise(SIGSTOP);
    _exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return -1;
  long count = 0;
  for (;; ++count) {
    if (ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) != 0) break;
    if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return -1; // f crashed or ended the process
    if (WSTOPSIG(status) == SIGSTOP) break;
  }
  ptrace(PTRACE_KILL, child, nullptr, nullptr);
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return count;
}

} // namespace bolide::verify
