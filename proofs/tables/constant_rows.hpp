#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// Which constants of a statement make it stronger.
enum class Direction : unsigned char {
  smaller,  ///< an upper bound: the best constant is the least
  larger    ///< a lower bound
};

/// A constant of a lemma: where the paper's value, the value that its proof gives, and a value that is refuted are
/// found.
struct ConstantRow {
  std::string label;      ///< of the paper
  std::string statement;  ///< in plain text, with the constant as c
  std::string latex;      ///< the same in LaTeX's math mode
  Direction direction = Direction::smaller;
  /// The claim whose conclusion (or, without a twin, hypothesis) has the constant, and the formula with C in its place.
  /// Empty if only a step has it.
  std::string claim;
  std::string conclusion;
  std::string pattern;
  /// The paper's constant, where the claim is about a better one; else it is that of the claim, or of the steps.
  std::optional<Rational> paper;
  /// Constants of steps, "claim/step/constant": the constant goes through the proof where it goes through all of them.
  std::vector<std::string> steps;
  /// Whether the steps have 1/c in the place of c.
  bool is_inverse_in_steps = false;
  std::string note;  ///< may be empty
};

/// A lemma that has no constant of its own, and why.
struct LemmaWithoutConstant {
  std::string label;
  std::string reason;
};

struct ConstantRows {
  std::vector<ConstantRow> rows;
  std::vector<LemmaWithoutConstant> without;
};

/// Reads what proofs/tables/constants.toml is made of: [[constant]] with the keys label, statement, latex, best
/// ("smaller" or "larger"), claim, conclusion, pattern, paper, steps, inverse, note, and [[without]] with label and
/// reason. Throws InputError, "file:line:column: what is wrong".
[[nodiscard]] ConstantRows parse_constant_rows(const std::string& text, const std::string& file);

/// Those of the library.
[[nodiscard]] const ConstantRows& builtin_constant_rows();

/// The text of proofs/tables/constants.toml. The definition is generated (cmake/EmbedFiles.cmake).
struct BuiltinTable {
  std::string name;
  std::string text;
};
[[nodiscard]] const std::vector<BuiltinTable>& builtin_tables();

}  // namespace delcert
