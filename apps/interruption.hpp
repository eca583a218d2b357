#pragma once

#include <stdexcept>
#include <string>

namespace delcert {

/// Thrown by long work that was asked to stop. Exit status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; nothing was written") {}
};

/// The same where finished parts are kept in a log.
class InterruptedWithLog : public Interrupted {
 public:
  explicit InterruptedWithLog(const std::string& log)
      : what_("interrupted; the same command goes on from what is finished in " + log) {}
  [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

/// From now on the first interrupt (Ctrl-C) or request to terminate only sets a flag; the second ends the program at
/// once.
void catch_interruptions();

/// Throws Interrupted if the flag is set. Cheap enough for every round of a loop that does some work.
void throw_if_interrupted();

}  // namespace delcert
