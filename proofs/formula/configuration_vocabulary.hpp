#pragma once

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The quantities of forbidden configurations: whether a simplex is one (def:forbidden.config), its properties P1 … P4
/// (lem:prop.forbid.cfg), distances from circumspheres and diametric spheres (section 2), and joins x ∗ σ.
void add_configuration_quantities(Vocabulary& vocabulary);

}  // namespace delcert
