#pragma once

#include <string>
#include <vector>

#include "proofs/checker/parts/share.hpp"

namespace delcert::checker {

/// What the command line asks for.
struct Arguments {
  std::vector<std::string> files;
  std::vector<std::string> levels;  // none: all that are claimed
  std::string expected;             // the file whose manifold is expected; empty: none
  std::string report;               // the file to which a report is written; empty: none
  double seconds = 0;               // limit of time for each file; 0: none
  double mebibytes = 0;             // limit of memory for each file; 0: none
  Share part;                       // what is checked of each file
  std::uint64_t chunk = 0;          // which chunk of a certificate in chunks is checked, from 1; 0: none
  std::string receipt;              // the file to which a receipt of the part is written; empty: none
  bool merge = false;               // the files are receipts, and perhaps their certificate
  unsigned threads = 1;             // how many processes share the work on each file
  bool json = false, quiet = false;
  std::string answer;  // the help or the version, where that is what was asked for: nothing is checked then
};

/// Reads the command line. Throws std::invalid_argument, with what is wrong, where it is not one of delcert-check.
Arguments parse_arguments(int argc, char** argv);

}  // namespace delcert::checker
