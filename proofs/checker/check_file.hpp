#pragma once

#include <string>

#include "proofs/checker/arguments.hpp"

namespace delcert::checker {

/// What became of one file: its exit status, and the words for a person and for a program. A file that is not checked
/// at all has its reason in `error`, and no words.
struct FileOutcome {
  int status = 0;
  std::string text, json, error;
};

/// Checks one file under the limits of the command line, in a process of its own.
FileOutcome check_file(const std::string& file, const Arguments& arguments);

}  // namespace delcert::checker
