#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/point_rules.hpp"
#include "proofs/formula/step.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

struct Hypothesis : Statement {
  /// Why the claim without this hypothesis need not be refuted; empty if it has to be.
  std::string no_twin;
  /// It belongs to what the points of the claim are (`PointRules`).
  bool is_constraint = false;
};

struct Conclusion : Statement {
  /// The conclusion with its constant moved past what holds: it has to be refuted.
  std::optional<Statement> twin;
  /// A term that both sides of its comparisons exceed or come near to: what is measured is the ratio of the excesses,
  /// so that where nothing is distorted is not where the ratio is greatest.
  std::optional<Statement> base;
  /// Why there is no twin, if there is none.
  std::string no_twin;
};

/// A claim about all instances of a class (docs/claim-format.md): whenever the hypotheses hold, so do the conclusions;
/// and the steps of its proof that are about numbers.
struct Claim {
  std::string file;
  std::string name;
  std::string title;
  std::string source;  ///< the LaTeX label in the paper, or a citation; may be empty for a user's claim
  ClaimStatus status = ClaimStatus::user;
  std::string instance;  ///< the instance class; empty for a file of steps only, which has no conclusions
  std::string note;
  std::map<std::string, ParameterRange> parameters;
  std::optional<PointRules> points;      ///< what the points of the class `point-set` are
  std::vector<Statement> abbreviations;  ///< `let`; formulas have what they stand for in their place
  std::vector<Hypothesis> hypotheses;
  std::vector<Conclusion> conclusions;
  std::vector<Step> steps;
};

/// The names that each instance class binds.
using Signatures = std::map<std::string, Signature>;

/// Reads a claim. Throws InputError for anything that is not as docs/claim-format.md says, in the form
/// "file:line:column: what is wrong", with a suggestion where a word is nearly one that exists.
[[nodiscard]] Claim parse_claim(const std::string& text, const std::string& file, const Vocabulary& vocabulary,
                                const Signatures& signatures);

/// The same from a file. Throws InputError also if it cannot be read or is larger than 1 MiB.
[[nodiscard]] Claim read_claim(const std::string& file, const Vocabulary& vocabulary, const Signatures& signatures);

}  // namespace delcert
