#pragma once

#include <string>

#include "proofs/checker/run.hpp"

namespace delcert::checker {

/// A line for each level and one for the whole.
std::string as_text(const Outcome& outcome);

/// One JSON object on one line.
std::string as_json(const std::string& file, const Outcome& outcome);

}  // namespace delcert::checker
