#pragma once

#include <map>
#include <string>

#include "proofs/replay/statement.hpp"

namespace delcert::replay {

/// What names in formulas stand for: constants, abbreviations, the arguments of definitions.
using Meanings = std::map<std::string, NodePointer>;

/// Reads a formula of a claim's file (docs/claim-format.md, "Formulas") as far as steps have them, so no quantifiers:
/// "a <= x + 1 < b and not (x = 0)". The constants of the paper, such as constant_c(m, mu0), are what they are defined
/// to be. Throws Malformed.
NodePointer read_formula(const std::string& text);

/// The formula with what names stand for in their places.
NodePointer with_meanings(const NodePointer& formula, const Meanings& meanings);

/// A number as a formula has it: −3/4 is (- (/ 3 4)).
NodePointer formula_of(const Number& value);

}  // namespace delcert::replay
