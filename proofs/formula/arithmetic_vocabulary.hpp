#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// sqrt, abs, min, max, log2, sets of integers.
void add_arithmetic(Vocabulary& vocabulary);

/// The paper's constants as formulas: C, Γ₀, α̃₀ and so on, by the names of the ledger.
void add_constants_of_the_paper(Vocabulary& vocabulary);

}  // namespace delcert
