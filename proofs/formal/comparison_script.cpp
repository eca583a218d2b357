#include "proofs/formal/comparison_script.hpp"

#include <algorithm>

#include "proofs/formal/sign_script.hpp"
#include "proofs/formal/symbolic_powers.hpp"
#include "proofs/formal/terms.hpp"
#include "proofs/prover/rational_function.hpp"

namespace delcert {

namespace {

/// Thrown inside this file where no certificate is found.
struct NoCertificate {};

class Certificate {
 public:
  Certificate(const FormalParameters& parameters, const SymbolicPowers& powers, const KnownSigns& known)
      : names_(coq_names(parameters)), known_(known) {
    std::vector<std::string> names;
    std::vector<bool> squared;
    for (const FormalParameter& parameter : parameters) {
      names.push_back(parameter.name);
      squared.push_back(parameter.is_squared);
      variables_.push_back(parameter.variable());
    }
    for (const FormalVariable& variable : powers.variables()) {
      names.push_back(variable.text);
      squared.push_back(false);
      variables_.push_back(variable);
    }
    ring_ = std::make_shared<PolynomialRing>(std::move(names));
    reader_.emplace(ring_, std::move(squared), [this](const Polynomial& p) { return sign(p); });
  }

  std::string tactics(const Expression& comparison) {
    const bool turned = comparison.operation == Operation::greater || comparison.operation == Operation::greater_equal;
    const bool strict = comparison.operation == Operation::less || comparison.operation == Operation::greater;
    const ExpressionPointer& left = comparison.children[turned ? 1 : 0];
    const ExpressionPointer& right = comparison.children[turned ? 0 : 1];
    without_roots(left);
    without_roots(right);
    const ExpressionPointer difference = binary_term(Operation::subtract, right, left);
    const RationalFunction value = read(difference);
    for (const Polynomial& divisor : reader_->divisors()) {
      if (!divisor.constant()) signed_factors(divisor, true);
    }
    if (value.numerator.is_zero()) {
      if (strict) throw NoCertificate();
      const bool equal = comparison.operation == Operation::equal;
      return script_ + (turned ? "apply Rle_ge; " : "") + (equal ? "" : "apply Req_le; ") +
             "field_simplify_eq; [try ring | nonzero ..].\n";
    }
    if (comparison.operation == Operation::equal) throw NoCertificate();
    Product denominator = signed_factors(value.denominator, true);
    Product numerator = signed_factors(value.numerator, strict);
    numerator.constant /= denominator.constant;
    if (numerator.constant < Rational(0)) throw NoCertificate();
    const std::string quotient = numerator.text() + " " + (denominator.factors.empty() ? "1" : denominator.text(false));
    return script_ + (turned ? (strict ? "apply Rlt_gt; " : "apply Rle_ge; ") : "") + "apply (" +
           (strict ? "lt_by" : "le_by") + " _ _ " + quotient + ").\n{ " + (strict ? "positive" : "nonneg") +
           ". }\n{ positive. }\n{ field; nonzero. }\n";
  }

  [[nodiscard]] const std::set<std::size_t>& wanted_squares() const { return reader_->wanted_squares(); }

 private:
  struct Product {
    Rational constant = Rational(1);
    std::vector<std::string> factors;
    [[nodiscard]] std::string text(bool with_constant = true) const {
      std::string result = with_constant ? coq_number(constant) : "";
      for (const std::string& factor : factors) result += (result.empty() ? "" : " * ") + factor;
      return "(" + result + ")";
    }
  };

  RationalFunction read(const ExpressionPointer& term) {
    kept_.push_back(term);
    auto value = reader_->read(*term);
    if (!value) throw NoCertificate();
    return std::move(*value);
  }

  /// A polynomial as a product of factors that are not negative (of positive ones), with the facts asserted.
  Product signed_factors(const Polynomial& polynomial, bool strict) {
    Product result;
    if (const auto constant = polynomial.constant()) {
      result.constant = *constant;
      return result;
    }
    const auto factors = polynomial.factors();
    result.constant = factors.constant;
    for (const auto& [base, exponent] : factors.powers) {
      const Sign known = sign(base);
      const bool odd = exponent % 2 != 0;
      if (known == Sign::unknown || (strict && !is_strict(known))) {
        if (strict || odd) throw NoCertificate();
        result.factors.push_back("(" + polynomial_text(base, variables_) + " ^ 2) ^ " + std::to_string(exponent / 2));
        continue;
      }
      const bool negative = known == Sign::negative || known == Sign::nonpositive;
      const Polynomial factor = negative ? -base : base;
      if (negative && odd) result.constant = -result.constant;
      assert_sign(factor, is_strict(known));
      result.factors.push_back(power_text(polynomial_text(factor, variables_), exponent));
    }
    return result;
  }

  [[nodiscard]] const KnownSign* known_sign(const Polynomial& polynomial) const {
    if (known_.empty()) return nullptr;
    const auto found = known_.find(polynomial.text());
    return found == known_.end() ? nullptr : &found->second;
  }

  /// The sign that a certificate shows: positive or negative if it can be strict.
  Sign sign(const Polynomial& polynomial) {
    if (const KnownSign* known = known_sign(polynomial)) return known->strict ? Sign::positive : Sign::nonnegative;
    if (const KnownSign* known = known_sign(-polynomial)) return known->strict ? Sign::negative : Sign::nonpositive;
    const int guess = sign_at_some_point(polynomial, variables_);
    for (const int turn : {1, -1}) {
      if (guess == -turn) continue;
      const Polynomial candidate = turn > 0 ? polynomial : -polynomial;
      if (sign_script(candidate, variables_, true)) return turn > 0 ? Sign::positive : Sign::negative;
      if (sign_script(candidate, variables_, false)) return turn > 0 ? Sign::nonnegative : Sign::nonpositive;
    }
    return Sign::unknown;
  }

  void assert_sign(const Polynomial& polynomial, bool strict) {
    const std::string text = polynomial_text(polynomial, variables_);
    // Of a variable the hypotheses say it.
    const bool is_variable =
        std::any_of(variables_.begin(), variables_.end(), [&](const FormalVariable& one) { return one.text == text; });
    if (is_variable || !asserted_.insert(text).second) return;
    const KnownSign* known = known_sign(polynomial);
    const auto proof = known != nullptr ? std::optional(known->script) : sign_script(polynomial, variables_, strict);
    if (!proof) throw NoCertificate();
    script_ += "assert (0 " + std::string(strict ? "<" : "<=") + " " + text + ").\n{ " + *proof + " }\n";
  }

  /// The term as the goal has it once its roots are polynomials; the tactics that make them so are added.
  ExpressionPointer without_roots(const ExpressionPointer& term) {
    const auto exponent =
        term->operation == Operation::power ? rational_constant(*term->children[1]) : std::optional<Rational>();
    if (exponent && exponent->denominator() == 2) {
      return power_term(root(term->children[0]), static_cast<long>(exponent->numerator()));
    }
    if (term->operation == Operation::call && term->text == "sqrt") return root(term->children[0]);
    std::vector<ExpressionPointer> children;
    for (const auto& child : term->children) children.push_back(without_roots(child));
    return with_children(term, std::move(children));
  }

  ExpressionPointer root(const ExpressionPointer& argument) {
    const auto printed = coq_of(*without_roots(argument), names_);
    const auto half = number_term(Rational(1) / Rational(2));
    const RationalFunction value = read(binary_term(Operation::power, argument, half));
    const Product denominator = signed_factors(value.denominator, true);
    Product numerator = signed_factors(value.numerator, false);
    numerator.constant /= denominator.constant;
    if (!printed || numerator.constant < Rational(0)) throw NoCertificate();
    const bool is_fraction = !denominator.factors.empty();
    const std::string text =
        is_fraction ? "(" + numerator.text() + " / " + denominator.text(false) + ")" : numerator.text();
    const std::string fact = "sqrt " + *printed + " = " + text;
    if (asserted_.insert(fact).second) {
      const std::string name = "root_fact_" + std::to_string(++roots_);
      script_ += "assert (" + name + " : " + fact + ").\n{ apply sqrt_is; [" +
                 (is_fraction ? "apply quotient_nonneg; [nonneg | positive]" : "nonneg") +
                 " | field; nonzero]. }\ntry rewrite " + name + "; clear " + name + ".\n";
    }
    names_[text] = text;
    return name_term(text);
  }

  CoqNames names_;
  const KnownSigns& known_;
  FormalVariables variables_;
  RingPointer ring_;
  std::optional<RationalFunctionReader> reader_;
  std::vector<ExpressionPointer> kept_;  ///< the reader knows terms by their addresses
  std::set<std::string> asserted_;
  std::string script_;
  int roots_ = 0;
};

}  // namespace

ComparisonScript comparison_script(const ExpressionPointer& comparison, const FormalParameters& parameters,
                                   const KnownSigns& known) {
  SymbolicPowers powers(parameters);
  const auto plain = powers.replaced(comparison);
  if (!plain) return {};
  Certificate certificate(parameters, powers, known);
  try {
    std::string tactics = powers.script() + certificate.tactics(**plain);
    return {std::move(tactics), certificate.wanted_squares()};
  } catch (const NoCertificate&) {
    return {std::nullopt, certificate.wanted_squares()};
  }
}

}  // namespace delcert
