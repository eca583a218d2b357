#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The kind `map` and the quantities about circumscribing balls and points (section 4.2).
void add_map_quantities(Vocabulary& vocabulary);

}  // namespace delcert
