#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "proofs/replay/polynomial.hpp"
#include "proofs/replay/product.hpp"
#include "proofs/replay/statement.hpp"

namespace delcert::replay {

/// A comparison, given the sign of left − right: 1 true, −1 false, 0 unknown.
int truth(const std::string& relation, int sign);

/// A goal as far as it has been read: each product has been found to be the difference of its comparison.
struct GoalParts {
  const Node& statement;
  const std::vector<const Node*>& comparisons;
  const std::vector<std::optional<Product>>& products;
  const std::vector<Polynomial>& factors;
  const std::vector<Side>& ranges;
  const std::vector<std::vector<Side>>& boxes;
  const Variables& variables;
};

/// Checks a proof by sums of squares (docs/prover.md, "The log"): each sum is the factor, the weights are positive,
/// what is multiplied by is not negative where the hypotheses hold, and the signs make the conclusion true. Throws
/// Rejected.
void require_proved_by_squares(const nlohmann::json& squares, const GoalParts& goal);

}  // namespace delcert::replay
