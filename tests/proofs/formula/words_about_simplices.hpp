#pragma once

#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/simplex_vocabulary.hpp"

namespace delcert::words_about_simplices {

/// What formulas about simplices consist of.
inline const Vocabulary& vocabulary() {
  static const Vocabulary result = [] {
    Vocabulary made;
    add_arithmetic(made);
    add_constants_of_the_paper(made);
    add_simplex_quantities(made);
    return made;
  }();
  return result;
}

}  // namespace delcert::words_about_simplices
