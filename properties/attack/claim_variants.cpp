#include "properties/attack/claim_variants.hpp"

#include "proofs/formula/type_check.hpp"

namespace delcert {

Claim twin_of_conclusion(const Claim& claim, std::size_t conclusion) {
  Claim result = claim;
  Conclusion twin;
  static_cast<Statement&>(twin) = claim.conclusions.at(conclusion).twin.value();
  result.name += "/" + twin.name;
  result.conclusions = {twin};
  return result;
}

Claim twin_of_hypothesis(const Claim& claim, std::size_t hypothesis) {
  Claim result = claim;
  result.name += "/without-" + claim.hypotheses.at(hypothesis).name;
  result.hypotheses.erase(result.hypotheses.begin() + static_cast<std::ptrdiff_t>(hypothesis));
  return result;
}

ExpressionPointer made_strict(const ExpressionPointer& statement) {
  auto result = std::make_shared<Expression>(*statement);
  if (result->operation == Operation::less_equal) result->operation = Operation::less;
  if (result->operation == Operation::greater_equal) result->operation = Operation::greater;
  if (is_comparison(statement->operation)) return result;
  for (auto& child : result->children) {
    if (child->type == types::truth) child = made_strict(child);
  }
  return result;
}

}  // namespace delcert
