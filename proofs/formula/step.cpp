#include "proofs/formula/step.hpp"

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/parser.hpp"
#include "kernel/formula/token.hpp"
#include "proofs/formula/substitution.hpp"

namespace delcert {

namespace {

class RangeReader {
 public:
  explicit RangeReader(std::string_view text) : tokens_(tokens_of(text)) {}

  StepRange read() {
    StepRange range;
    if (here().is("integer")) {
      range.is_integer = true;
      ++at_;
    }
    if (!here().is("(") && !here().is("[")) refuse("an interval such as (0, 1] or integer [1, infinity)");
    const std::size_t begin = here().offset;
    range.has_lower = here().is("[");
    ++at_;
    range.lower = end(-1);
    if (!range.lower && range.has_lower) throw FormulaError(begin, "infinity is not a number: write (-infinity");
    take(",", "a comma between the ends");
    range.upper = end(1);
    const std::size_t last = here().offset;
    if (!here().is(")") && !here().is("]")) refuse("the end of the interval, ) or ]");
    range.has_upper = here().is("]");
    if (!range.upper && range.has_upper) throw FormulaError(last, "infinity is not a number: write infinity)");
    ++at_;
    if (here().kind != TokenKind::end) refuse("the end");
    if (is_empty(range)) throw FormulaError(begin, "an empty interval");
    return range;
  }

 private:
  [[nodiscard]] const Token& here() const { return tokens_[at_]; }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw FormulaError(here().offset, here().shown() + " where " + expected + " was expected");
  }
  void take(std::string_view what, const std::string& expected) {
    if (!here().is(what)) refuse(expected);
    ++at_;
  }

  Rational integer() {
    if (here().kind != TokenKind::number) refuse("a number or infinity");
    const ExpressionPointer number = parse_formula(here().text);
    ++at_;
    return number->value;
  }

  /// Nothing for infinity, which must have the sign given.
  std::optional<Rational> end(int sign_of_infinity) {
    const std::size_t begin = here().offset;
    const bool negative = here().is("-");
    if (negative) ++at_;
    if (here().is("infinity")) {
      if (negative != (sign_of_infinity < 0)) throw FormulaError(begin, "an empty interval");
      ++at_;
      return std::nullopt;
    }
    Rational result = integer();
    if (here().is("/")) {
      ++at_;
      const std::size_t offset = here().offset;
      const Rational denominator = integer();
      if (denominator == Rational(0)) throw FormulaError(offset, "a denominator of 0");
      result /= denominator;
    }
    return negative ? -result : result;
  }

  static bool is_empty(const StepRange& range) {
    if (!range.lower || !range.upper) return false;
    if (!range.is_integer) {
      return *range.upper < *range.lower || (*range.upper == *range.lower && !(range.has_lower && range.has_upper));
    }
    Integer first = ceiling_of(*range.lower);
    if (!range.has_lower && Rational(first) == *range.lower) ++first;
    return !range.contains(Rational(first));
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

std::string end_text(const Rational& end) {
  const Integer denominator = end.denominator();
  return end.numerator().str() + (denominator == 1 ? "" : "/" + denominator.str());
}

}  // namespace

std::string_view name_of(ClaimStatus status) {
  switch (status) {
    case ClaimStatus::paper:
      return "paper";
    case ClaimStatus::mended:
      return "mended";
    case ClaimStatus::sharper:
      return "sharper";
    default:
      return "user";
  }
}

bool StepRange::contains(const Rational& x) const {
  if (is_integer && x.denominator() != 1) return false;
  if (lower && (x < *lower || (x == *lower && !has_lower))) return false;
  return !upper || x < *upper || (x == *upper && has_upper);
}

StepRange parse_step_range(std::string_view text) { return RangeReader(text).read(); }

std::string step_range_text(const StepRange& range) {
  return std::string(range.is_integer ? "integer " : "") + (range.has_lower ? "[" : "(") +
         (range.lower ? end_text(*range.lower) : "-infinity") + ", " +
         (range.upper ? end_text(*range.upper) : "infinity") + (range.has_upper ? "]" : ")");
}

ExpressionPointer expanded(const Step& step, const ExpressionPointer& formula) {
  return expanded(step, step.constants, formula);
}

ExpressionPointer expanded(const Step& step, const std::map<std::string, Rational>& constants,
                           const ExpressionPointer& formula) {
  Replacements replacements;
  for (const auto& [name, value] : constants) replacements[name] = number_expression(value);
  for (const Statement& abbreviation : step.abbreviations) {
    replacements[abbreviation.name] = without_definitions(replaced(abbreviation.formula, replacements));
  }
  return without_definitions(replaced(formula, replacements));
}

}  // namespace delcert
