#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Adds the kind run and what is certified of runs: the same on every rung.
void add_run_quantities(Vocabulary& vocabulary);

}  // namespace delcert
