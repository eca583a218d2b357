#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// The limits that the hypotheses of a claim set: every part `name <= term`, `name < term` of them, or the same turned
/// round.
class HypothesisLimits : public Limits {
 public:
  /// Precondition: the claim outlives it.
  explicit HypothesisLimits(const Claim& claim);
  [[nodiscard]] std::optional<Rational> most(const std::string& name, const Bindings& bound, bool exact) const override;
  [[nodiscard]] const PointRules* points() const override { return claim_.points ? &*claim_.points : nullptr; }
  [[nodiscard]] std::vector<ExpressionPointer> constraints() const override;

 private:
  struct Limit {
    std::string name;
    ExpressionPointer term;
    bool is_strict = false;
    std::vector<std::string> needs;
  };
  void collect(const ExpressionPointer& statement);
  const Claim& claim_;
  std::vector<Limit> limits_;
};

/// Draws the parameters of the claim (its `forall`), then an instance of its class.
[[nodiscard]] std::optional<Instance> draw_instance(const Claim& claim, const Limits& limits, const Shape& shape,
                                                    Choices& choices);
/// The same with `InstanceClass::draw_structured`.
[[nodiscard]] std::optional<Instance> draw_structured_instance(const Claim& claim, const Limits& limits,
                                                               const Shape& shape, Choices& choices);

}  // namespace delcert
