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

/// Runs a function in a process of its own, whose exit status is the function's value. What one certificate does to
/// memory, or to a limit of time, does nothing to the next. The process ends with its parent.
class SeparateProcess {
 public:
  /// Throws std::system_error if the system has no process or pipe to give.
  explicit SeparateProcess(const std::function<int()>& function);
  SeparateProcess(const SeparateProcess&) = delete;
  SeparateProcess& operator=(const SeparateProcess&) = delete;
  /// Kills it if its end has not been waited for.
  ~SeparateProcess();

  /// Waits for its end. Precondition: once.
  Ended end();

 private:
  int child_ = -1, output_ = -1;
};

}  // namespace delcert::checker
