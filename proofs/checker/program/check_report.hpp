#pragma once

#include <string>
#include <vector>

#include "proofs/checker/program/check_file.hpp"

namespace delcert::checker {

/// The exit status for several files: that of the worst, in the order of the help.
int worst_status(const std::vector<FileOutcome>& outcomes);

/// The outcomes of the files, one for each, with what checked them, where, and when: a JSON document. Nothing signs it.
std::string report_text(const std::vector<std::string>& files, const std::vector<FileOutcome>& outcomes);

/// Writes the text to a temporary file, which then takes the place of this one. Throws std::runtime_error, and leaves
/// what was there, if that fails.
void write_whole(const std::string& path, const std::string& text);

}  // namespace delcert::checker
