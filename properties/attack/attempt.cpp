#include "properties/attack/attempt.hpp"

#include <mpfr.h>

#include <algorithm>
#include <filesystem>

#include "proofs/formula/builtin_claims.hpp"
#include "proofs/formula/formula_error.hpp"
#include "proofs/formula/type_check.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long fine = -60;
constexpr unsigned enough_bits = 30;

/// A number of the range: an end that belongs to it, any number, or one near the lower end.
Rational draw_parameter(const ParameterRange& range, Choices& choices) {
  const Rational width = range.upper - range.lower;
  const double kind = choices.unit();
  const Rational where = choices.fraction(16);
  if (kind < 0.25 && range.has_upper) return range.upper;
  if (kind < 0.35 && range.has_lower) return range.lower;
  // Neither 0 nor 1, so that open ends are safe.
  const Rational inside = (where + Rational::power_of_two(-17));
  if (kind < 0.75) return range.lower + width * inside;
  return range.lower + width * inside * Rational::power_of_two(-choices.between(1, 40));
}

DoubleBounds double_bounds(const BigInterval& x) {
  return {mpfr_get_d(&x.mpfi()->left, MPFR_RNDD), mpfr_get_d(&x.mpfi()->right, MPFR_RNDU)};
}

/// Not where the bounds are infinite.
bool is_sharp(const DoubleBounds& ratio) {
  constexpr double sharp_enough = 0x1p-20;
  return ratio.upper - ratio.lower <= sharp_enough * ratio.upper;
}

/// The ratio from the filter; from 128 bits, which mostly are there already where the filter does not tell; or from
/// more: until it is sharp, or certainly not above a known one.
std::optional<DoubleBounds> ratio_as_sharp_as_needed(const Expression& statement, Scene& scene, const double* known) {
  std::optional<DoubleBounds> ratio = ratio_bounds(statement, scene, false);
  const auto is_enough = [&] { return ratio && (is_sharp(*ratio) || (known != nullptr && ratio->upper <= *known)); };
  if (is_enough()) return ratio;
  {
    constexpr unsigned bits = 128;
    const BigInterval::Precision precision(PrecisionBits{bits});
    const auto sharper = Evaluation<BigInterval>(scene).ratio(statement);
    if (sharper) ratio = double_bounds(*sharper);
  }
  if (is_enough()) return ratio;
  const auto sharpest = ratio_bounds(statement, scene, true);
  return sharpest ? sharpest : ratio;
}

/// A lower bound of the term, within 2⁻³⁰ of it.
std::optional<Rational> quick_lower_bound(const Expression& term, Scene& scene) {
  {
    const RoundingGuard guard;
    const auto value = Evaluation<Interval>(scene).number(term);
    if (value && value->lower() > 0 && value->upper() - value->lower() <= 0x1p-30 * value->lower()) {
      return Rational::exactly(value->lower());
    }
  }
  return lower_bound(term, scene, enough_bits);
}

}  // namespace

Attempt attempt(const Claim& claim, const Bindings& bindings, std::span<const double> known) {
  Scene scene(bindings);
  Attempt result;
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    result.hypotheses = conjunction(result.hypotheses, decide_statement(*hypothesis.formula, scene));
    if (is_refuted(result.hypotheses)) return result;
  }
  if (!is_proved(result.hypotheses)) return result;
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    const Expression& statement = *claim.conclusions[at].formula;
    ConclusionOutcome outcome;
    outcome.verdict = decide_statement(statement, scene);
    outcome.ratio = ratio_as_sharp_as_needed(statement, scene, known.empty() ? nullptr : &known[at]);
    result.conclusions.push_back(outcome);
  }
  return result;
}

std::optional<DoubleBounds> attempted_ratio(const Claim& claim, std::size_t conclusion, const Bindings& bindings,
                                            double known) {
  Scene scene(bindings);
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    if (!is_proved(decide_statement(*hypothesis.formula, scene))) return std::nullopt;
  }
  return ratio_as_sharp_as_needed(*claim.conclusions.at(conclusion).formula, scene, &known);
}

HypothesisLimits::HypothesisLimits(const Claim& claim) {
  for (const Hypothesis& hypothesis : claim.hypotheses) collect(hypothesis.formula);
}

void HypothesisLimits::collect(const ExpressionPointer& statement) {
  if (statement->operation == Operation::conjunction) {
    for (const auto& part : statement->children) collect(part);
    return;
  }
  const bool turned = statement->operation == Operation::greater || statement->operation == Operation::greater_equal;
  if (!turned && statement->operation != Operation::less && statement->operation != Operation::less_equal) return;
  const auto& name = statement->children[turned ? 1 : 0];
  const auto& term = statement->children[turned ? 0 : 1];
  if (name->operation != Operation::name) return;
  const bool is_strict = statement->operation == Operation::less || statement->operation == Operation::greater;
  limits_.push_back({name->text, term, is_strict, free_names(*term)});
}

std::optional<Rational> HypothesisLimits::most(const std::string& name, const Bindings& bound, bool exact) const {
  std::optional<Rational> result;
  Scene scene(bound);
  for (const Limit& limit : limits_) {
    const bool known = std::all_of(limit.needs.begin(), limit.needs.end(),
                                   [&](const std::string& need) { return bound.contains(need); });
    if (limit.name != name || !known) continue;
    std::optional<Rational> here = exact ? exact_value(*limit.term, scene) : std::nullopt;
    if (!here) here = quick_lower_bound(*limit.term, scene);
    if (!here) here = Rational(0);
    if (limit.is_strict) *here -= absolute(*here) * Rational::power_of_two(fine);
    result = result ? minimum(*result, *here) : *here;
  }
  return result;
}

std::optional<Instance> draw_instance(const Claim& claim, const HypothesisLimits& limits, const Shape& shape,
                                      Choices& choices) {
  Bindings given;
  for (const auto& [name, range] : claim.parameters) given[name] = draw_parameter(range, choices);
  return instance_class(claim.instance).draw(shape, given, limits, choices);
}

void require_names_of(const Claim& claim, const Bindings& bindings) {
  const InstanceClass& its_class = instance_class(claim.instance);
  require_signature(its_class, bindings);
  for (const auto& [name, range] : claim.parameters) {
    const auto found = bindings.find(name);
    if (found == bindings.end()) throw InputError("the parameter " + name + " of " + claim.name + " is missing");
    const Rational& value = std::get<Rational>(found->second);
    const bool is_in_range = (range.lower < value || (range.has_lower && value == range.lower)) &&
                             (value < range.upper || (range.has_upper && value == range.upper));
    if (!is_in_range) throw InputError("the parameter " + name + " of " + claim.name + " is out of its range");
  }
  const Signature signature = its_class.signature();
  for (const auto& [name, binding] : bindings) {
    if (!signature.contains(name) && !claim.parameters.contains(name)) {
      throw InputError("neither the class " + its_class.name() + " nor " + claim.name + " has a name " + name);
    }
  }
}

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

const Signatures& all_signatures() {
  static const Signatures signatures = [] {
    Signatures result;
    for (const InstanceClass* each : instance_classes()) result[each->name()] = each->signature();
    return result;
  }();
  return signatures;
}

const std::vector<Claim>& builtin_files() {
  static const std::vector<Claim> claims = [] {
    std::vector<Claim> result;
    for (const auto& [name, text] : builtin_claims()) {
      result.push_back(parse_claim(text, "proofs/claims/" + name + ".toml", full_vocabulary(), all_signatures()));
    }
    return result;
  }();
  return claims;
}

const std::vector<Claim>& builtin_claim_list() {
  static const std::vector<Claim> claims = [] {
    std::vector<Claim> result;
    for (const Claim& claim : builtin_files()) {
      if (!claim.instance.empty()) result.push_back(claim);
    }
    return result;
  }();
  return claims;
}

Claim find_claim(const std::string& name_or_file) {
  std::vector<std::string> known;
  for (const auto& [name, text] : builtin_claims()) {
    if (name == name_or_file) {
      return parse_claim(text, "proofs/claims/" + name + ".toml", full_vocabulary(), all_signatures());
    }
    known.push_back(name);
  }
  // Not even whether a file exists is known of a name that is too long.
  std::error_code unknown;
  const bool is_file = name_or_file.ends_with(".toml") || name_or_file.find('/') != std::string::npos ||
                       std::filesystem::exists(name_or_file, unknown);
  if (is_file) return read_claim(name_or_file, full_vocabulary(), all_signatures());
  throw InputError("no claim is called " + name_or_file + suggestion(name_or_file, known) +
                   " (delcert claims lists them)");
}

}  // namespace delcert
