#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/claim.hpp"
#include "proofs/prover/prover.hpp"
#include "tests/support/ratio.hpp"

namespace delcert {

inline void PrintTo(Verdict verdict, std::ostream* stream) { *stream << name_of(verdict); }
inline void PrintTo(Sign sign, std::ostream* stream) { *stream << name_of(sign); }

}  // namespace delcert

namespace delcert::test {

/// What steps can use.
inline const Vocabulary& numbers() {
  static const Vocabulary vocabulary = [] {
    Vocabulary result;
    add_arithmetic(result);
    add_constants_of_the_paper(result);
    return result;
  }();
  return vocabulary;
}

/// A step from the lines of its table in a claim's file, but for its name.
inline Step step(const std::string& lines) {
  return parse_claim("name = 'a'\n[[step]]\nname = 'a'\n" + lines, "a.toml", numbers(), {}).steps.at(0);
}

inline StepOutcome outcome(const std::string& lines, const SearchLimits& limits = {}) {
  return prove(step(lines), limits);
}

inline Verdict verdict(const std::string& lines) { return outcome(lines).verdict; }

}  // namespace delcert::test
