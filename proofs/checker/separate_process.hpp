#pragma once

#include <functional>
#include <string>

namespace delcert::checker {

/// The exit status of a process that did not come as far as its own.
constexpr int no_outcome = 70;

/// What a process of its own wrote and ended with.
struct Ended {
  int status = 0;      // its exit status, or no_outcome
  int signal = 0;      // the signal, or 0
  std::string output;  // what it wrote to its standard output
};

/// Runs the function in a process of its own, whose exit status is the function's value, and waits for its end. What
/// one certificate does to memory, or to a limit of time, does nothing to the next. The process ends with its parent.
/// Throws std::system_error if the system has no process or pipe to give.
Ended run_separately(const std::function<int()>& function);

}  // namespace delcert::checker
