#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Adds stars of points of a space in exponential charts and in the space, and what they measure.
/// Precondition: the kind of points of a space is there.
void add_space_stars(Vocabulary& vocabulary);

}  // namespace delcert
