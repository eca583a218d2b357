#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The quantities of one simplex, by the words of the glossary.
void add_simplex_quantities(Vocabulary& vocabulary);

}  // namespace delcert
