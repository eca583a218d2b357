#pragma once

#include <stdexcept>

namespace delcert {

/// Thrown by long work that was asked to stop. Exit status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; nothing was written") {}
};

/// From now on the first interrupt (Ctrl-C) or request to terminate only sets a flag; the second ends the program at
/// once.
void catch_interruptions();

/// Throws Interrupted if the flag is set. Cheap enough for every round of a loop that does some work.
void throw_if_interrupted();

}  // namespace delcert
