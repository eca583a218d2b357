#pragma once

#include <string>

#include "proofs/checker/program/arguments.hpp"

namespace delcert::checker {

/// What became of one file: its exit status, and the words for a person and for a program. A file that is not checked
/// at all has its reason in `error`, and no words.
struct FileOutcome {
  int status = 0;
  std::string text, json, error;
  std::string receipt;  // of a part, unless the certificate is malformed or a limit was reached
};

/// Checks one file under the limits of the command line, in a process of its own.
FileOutcome check_file(const std::string& file, const Arguments& arguments);

/// Puts the receipts among the files together; the other one, if there is one, is their certificate.
FileOutcome merge_files(const std::vector<std::string>& files);

}  // namespace delcert::checker
