#pragma once

#include <optional>
#include <span>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/evaluation.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Whether a conclusion holds on an instance, and how much of what it allows is taken up.
struct ConclusionOutcome {
  Verdict verdict = Verdict::undecided;
  std::optional<DoubleBounds> ratio;  ///< see `Evaluation::ratio`
};

/// What a claim says about one instance.
struct Attempt {
  /// All hypotheses hold; one certainly does not; undecided.
  Verdict hypotheses = Verdict::proved;
  /// Empty unless the hypotheses hold.
  std::vector<ConclusionOutcome> conclusions;
};

/// Decides all hypotheses, and if they hold, all conclusions. Ratios are sharp, up to 2⁻²⁰, where that is possible; or,
/// if `known` is not empty and has a number for each conclusion, where they may be above it. Throws InputError where a
/// quantity is asked for what it cannot be asked (vertex 7 of a triangle).
[[nodiscard]] Attempt attempt(const Claim& claim, const Bindings& bindings, std::span<const double> known = {});

/// The ratio of one conclusion, sharp unless it certainly is not above `known`; nothing unless all hypotheses are
/// proved and it is defined. The conclusion is not decided, which next to equality takes longest.
[[nodiscard]] std::optional<DoubleBounds> attempted_ratio(const Claim& claim, std::size_t conclusion,
                                                          const Bindings& bindings, double known);

/// The limits that the hypotheses of a claim set: every part `name <= term`, `name < term` of them, or the same turned
/// round.
class HypothesisLimits : public Limits {
 public:
  /// Precondition: the claim outlives it.
  explicit HypothesisLimits(const Claim& claim);
  [[nodiscard]] std::optional<Rational> most(const std::string& name, const Bindings& bound, bool exact) const override;

 private:
  struct Limit {
    std::string name;
    ExpressionPointer term;
    bool is_strict = false;
    std::vector<std::string> needs;
  };
  void collect(const ExpressionPointer& statement);
  std::vector<Limit> limits_;
};

/// Draws the parameters of the claim (its `forall`), then an instance of its class.
[[nodiscard]] std::optional<Instance> draw_instance(const Claim& claim, const HypothesisLimits& limits,
                                                    const Shape& shape, Choices& choices);

/// Throws InputError, saying why, unless the bindings have the names of the claim's class, a number for each parameter
/// of the claim, within its range, and nothing else. That they are an instance of the class is another question
/// (`InstanceClass::require`).
void require_names_of(const Claim& claim, const Bindings& bindings);

/// The claim with one conclusion only, replaced by its twin. Precondition: it has one.
[[nodiscard]] Claim twin_of_conclusion(const Claim& claim, std::size_t conclusion);
/// The claim without one of its hypotheses.
[[nodiscard]] Claim twin_of_hypothesis(const Claim& claim, std::size_t hypothesis);

/// The statement with < for every <= and > for every >=: refuted where the statement holds with equality.
[[nodiscard]] ExpressionPointer made_strict(const ExpressionPointer& statement);

/// The names that each instance class binds.
[[nodiscard]] const Signatures& all_signatures();

/// All files of claims of the library by name, also those of steps only; they are read once. Throws InputError for a
/// file that is not a file of claims.
[[nodiscard]] const std::vector<Claim>& builtin_files();
/// Those of them that are about instances.
[[nodiscard]] const std::vector<Claim>& builtin_claim_list();

/// A claim by its name in the library, or by a file's name. Throws InputError, with a suggestion, if there is none.
[[nodiscard]] Claim find_claim(const std::string& name_or_file);

}  // namespace delcert
