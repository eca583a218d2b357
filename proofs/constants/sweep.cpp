#include "proofs/constants/sweep.hpp"

#include <algorithm>

#include "support/error.hpp"

namespace delcert {

namespace {

/// Throws the reason why the combinations with a certain value are left out, if no ledger has that value.
template <class HasValue>
void require_some_ledger(const SweptLedgers& swept, const HasValue& has_value) {
  if (std::any_of(swept.ledgers.begin(), swept.ledgers.end(), has_value)) return;
  const auto first = std::find_if(swept.left_out.begin(), swept.left_out.end(), has_value);
  throw InputError(first->reason);
}

}  // namespace

SweptLedgers ledgers_of(const Sweep& sweep) {
  SweptLedgers result;
  const auto add = [&](Dimension dimension, const Rational& separation, const Rational& perturbation) {
    try {
      result.ledgers.push_back(constants_for(dimension, separation, perturbation, sweep.radius_variation,
                                             sweep.distortion, sweep.constraints));
    } catch (const InputError& reason) {
      result.left_out.push_back({dimension, separation, perturbation, reason.what()});
    }
  };
  for (const Dimension dimension : sweep.dimensions) {
    for (const Rational& separation : sweep.separations) {
      if (sweep.perturbations.empty())
        add(dimension, separation, largest_perturbation(separation, sweep.radius_variation, sweep.distortion));
      for (const Rational& perturbation : sweep.perturbations) add(dimension, separation, perturbation);
    }
  }
  for (const Dimension dimension : sweep.dimensions)
    require_some_ledger(result, [&](const auto& each) { return each.dimension == dimension; });
  for (const Rational& separation : sweep.separations)
    require_some_ledger(result, [&](const auto& each) { return each.separation == separation; });
  for (const Rational& perturbation : sweep.perturbations)
    require_some_ledger(result, [&](const auto& each) { return each.perturbation == perturbation; });
  return result;
}

}  // namespace delcert
