#pragma once

#include "kernel/formula/expression.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The same tree with the type of every node and the function of every call filled in. An integer serves as a number.
/// Throws FormulaError for an unknown name (with a suggestion), a wrong number or type of arguments, an exponent that
/// is not made of integers, or is a constant but no integer and no half of one or beyond ±1 000 000, a quantifier over
/// what is no set, a variable whose name is taken, or a whole that is not of the type expected.
[[nodiscard]] ExpressionPointer type_checked(const ExpressionPointer& expression, const Vocabulary& vocabulary,
                                             const Signature& signature, const Type& expected);

/// The same, whatever the type of the whole.
[[nodiscard]] ExpressionPointer type_checked(const ExpressionPointer& expression, const Vocabulary& vocabulary,
                                             const Signature& signature);

/// The names of the signature that occur in the expression, each once, in alphabetical order.
[[nodiscard]] std::vector<std::string> free_names(const Expression& expression);

}  // namespace delcert
