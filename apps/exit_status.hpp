#pragma once

#include <functional>
#include <ostream>

namespace delcert {

/// What a program of this project says by its exit status; the same everywhere (docs/cli.md).
enum class ExitStatus : int {
  verified = 0,
  rejected = 1,
  undecided = 2,
  malformed = 3,
  vacuous = 4,
  usage = 64,
  internal = 70,
  interrupted = 130
};

/// What a subcommand does once its options have been read.
using Action = std::function<ExitStatus()>;

/// Runs the action; what it throws becomes one line "delcert: error: …" and the status of its kind:
/// Rejection, Undecided, InputError, Interrupted each its own, everything else `internal`.
[[nodiscard]] ExitStatus run_reporting(const Action& action, std::ostream& errors);

/// The line itself, for what is found before there is an action.
void report_error(std::ostream& errors, const std::string& message);

}  // namespace delcert
