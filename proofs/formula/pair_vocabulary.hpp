#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The quantities of two simplices with corresponding vertices (section 4.1): the difference of their Gram matrices,
/// how closely an isometry aligns them. Needs the kind `simplex`.
void add_pair_quantities(Vocabulary& vocabulary);

}  // namespace delcert
