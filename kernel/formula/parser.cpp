#include "kernel/formula/parser.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/token.hpp"

namespace delcert {

namespace {

constexpr std::size_t greatest_depth = 200;
constexpr std::size_t most_digits = 1000;

/// Recursive descent, one function for each level of precedence.
class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(tokens_of(text)) {}

  ExpressionPointer whole() {
    auto result = statement();
    expect_end();
    return result;
  }

  ParameterRange range() {
    ParameterRange result;
    if (!next_is("(") && !next_is("[")) refuse("an interval such as (0, 1]");
    result.has_lower = next_is("[");
    const std::size_t begin = here().offset;
    ++at_;
    result.lower = end(true);
    if (!result.lower && result.has_lower) throw FormulaError(begin, "infinity is not a number: write (-infinity");
    take(",", "a comma between the ends");
    result.upper = end(false);
    const std::size_t last = here().offset;
    if (!next_is(")") && !next_is("]")) refuse("the end of the interval, ) or ]");
    result.has_upper = next_is("]");
    if (!result.upper && result.has_upper) throw FormulaError(last, "infinity is not a number: write infinity)");
    ++at_;
    expect_end();
    if (result.lower && result.upper && is_empty(*result.lower, *result.upper, result.has_lower && result.has_upper)) {
      throw FormulaError(begin, "an empty interval");
    }
    return result;
  }

 private:
  using Pointer = ExpressionPointer;

  [[nodiscard]] const Token& here() const { return tokens_[at_]; }
  [[nodiscard]] bool next_is(std::string_view what) const { return here().is(what); }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw FormulaError(here().offset, here().shown() + " where " + expected + " was expected");
  }
  void take(std::string_view what, const std::string& expected) {
    if (!next_is(what)) refuse(expected);
    ++at_;
  }
  void expect_end() const {
    if (here().kind != TokenKind::end) refuse("an operator or the end");
  }
  [[noreturn]] static void refuse_depth(std::size_t offset) {
    throw FormulaError(offset, "more than 200 levels of nesting");
  }
  Pointer node(Operation operation, std::size_t offset, std::vector<Pointer> children, std::string text = {}) {
    std::size_t height = 0;
    for (const Pointer& child : children) {
      const auto known = heights_.find(child.get());
      height = std::max(height, known == heights_.end() ? 1 : known->second);
    }
    if (++height > greatest_depth) refuse_depth(offset);
    auto result = std::make_shared<Expression>();
    heights_[result.get()] = height;
    result->operation = operation;
    result->offset = offset;
    result->text = std::move(text);
    result->children = std::move(children);
    return result;
  }

  Pointer statement() {
    if (++depth_ > greatest_depth) refuse_depth(here().offset);
    auto result = implication();
    --depth_;
    return result;
  }

  Pointer implication() {
    auto left = chain_of("or", Operation::disjunction,
                         [this] { return chain_of("and", Operation::conjunction, [this] { return negated(); }); });
    if (!next_is("implies")) return left;
    const std::size_t offset = here().offset;
    ++at_;
    return node(Operation::implication, offset, {left, statement()});
  }

  template <class Part>
  Pointer chain_of(std::string_view word, Operation operation, const Part& part) {
    auto left = part();
    while (next_is(word)) {
      const std::size_t offset = here().offset;
      ++at_;
      left = node(operation, offset, {left, part()});
    }
    return left;
  }

  Pointer negated() {
    const std::size_t offset = here().offset;
    if (next_is("not")) {
      ++at_;
      if (++depth_ > greatest_depth) refuse_depth(offset);
      auto part = negated();
      --depth_;
      return node(Operation::negation, offset, {part});
    }
    if (next_is("forall") || next_is("exists")) {
      const Operation operation = next_is("forall") ? Operation::for_all : Operation::exists;
      ++at_;
      return quantified(operation, offset);
    }
    return comparisons();
  }

  Pointer quantified(Operation operation, std::size_t offset) {
    const auto variables = variables_of("a colon and a statement, or a comma and another variable");
    return bound(operation, offset, variables, statement());
  }

  /// x in a, y in b: as far as the colon, or the error says what was expected there.
  std::vector<std::pair<std::string, Pointer>> variables_of(const std::string& expected) {
    std::vector<std::pair<std::string, Pointer>> variables;
    do {
      if (!variables.empty()) ++at_;
      if (here().kind != TokenKind::word || is_keyword(here().text)) refuse("a variable");
      std::string variable = here().text;
      ++at_;
      take("in", "'in'");
      variables.emplace_back(std::move(variable), set());
    } while (next_is(","));
    take(":", expected);
    return variables;
  }

  /// The last variable is the innermost.
  Pointer bound(Operation operation, std::size_t offset, const std::vector<std::pair<std::string, Pointer>>& variables,
                Pointer result) {
    for (auto variable = variables.rbegin(); variable != variables.rend(); ++variable) {
      result = node(operation, offset, {variable->second, result}, variable->first);
    }
    return result;
  }

  /// Whether "x in" follows, which begins no argument.
  [[nodiscard]] bool next_is_variable() const {
    return here().kind == TokenKind::word && !is_keyword(here().text) && tokens_[at_ + 1].is("in");
  }

  /// What stands in the parentheses of sum(x in a, y in b: term), and the one that closes them.
  Pointer over_set(const Token& word) {
    const auto operation = operation_over_set(word.text);
    if (!operation) {
      throw FormulaError(word.offset,
                         "no sum, product, min or max is called " + word.text +
                             suggestion(word.text, std::vector<std::string>{"sum", "product", "min", "max"}));
    }
    const auto variables = variables_of("a colon and a term, or a comma and another variable");
    auto result = bound(*operation, word.offset, variables, statement());
    take(")", "an operator or )");
    return result;
  }

  /// A set is a call, or a range of integers a .. b, which is the call of `range`.
  Pointer set() {
    const std::size_t offset = here().offset;
    auto first = sum();
    if (!next_is("..")) return first;
    ++at_;
    return node(Operation::call, offset, {first, sum()}, "range");
  }

  [[nodiscard]] std::optional<Operation> relation() const {
    if (next_is("<")) return Operation::less;
    if (next_is("<=")) return Operation::less_equal;
    if (next_is(">")) return Operation::greater;
    if (next_is(">=")) return Operation::greater_equal;
    if (next_is("=")) return Operation::equal;
    return std::nullopt;
  }

  /// a < b <= c stands for a < b and b <= c.
  Pointer comparisons() {
    auto left = sum();
    Pointer result;
    while (const auto operation = relation()) {
      const std::size_t offset = here().offset;
      ++at_;
      auto right = sum();
      auto comparison = node(*operation, offset, {left, right});
      result = result ? node(Operation::conjunction, offset, {result, comparison}) : comparison;
      left = right;
    }
    return result ? result : left;
  }

  Pointer sum() {
    auto left = product();
    while (next_is("+") || next_is("-")) {
      const Operation operation = next_is("+") ? Operation::add : Operation::subtract;
      const std::size_t offset = here().offset;
      ++at_;
      left = node(operation, offset, {left, product()});
    }
    return left;
  }

  Pointer product() {
    auto left = signed_power();
    while (next_is("*") || next_is("/")) {
      const Operation operation = next_is("*") ? Operation::multiply : Operation::divide;
      const std::size_t offset = here().offset;
      ++at_;
      left = node(operation, offset, {left, signed_power()});
    }
    return left;
  }

  Pointer signed_power() {
    if (!next_is("-")) return power();
    const std::size_t offset = here().offset;
    ++at_;
    if (++depth_ > greatest_depth) refuse_depth(offset);
    auto part = signed_power();
    --depth_;
    return node(Operation::negate, offset, {part});
  }

  Pointer power() {
    auto base = atom();
    if (!next_is("^")) return base;
    const std::size_t offset = here().offset;
    ++at_;
    if (++depth_ > greatest_depth) refuse_depth(offset);
    auto exponent = signed_power();
    --depth_;
    return node(Operation::power, offset, {base, exponent});
  }

  Pointer atom() {
    const Token token = here();
    if (token.kind == TokenKind::number) {
      auto result = std::make_shared<Expression>();
      result->offset = token.offset;
      result->value = integer();
      return result;
    }
    if (token.is("(")) {
      ++at_;
      auto result = statement();
      take(")", "an operator or )");
      return result;
    }
    if (token.kind != TokenKind::word || is_keyword(token.text)) refuse("a number, a name or (");
    ++at_;
    if (!next_is("(")) return node(Operation::name, token.offset, {}, token.text);
    ++at_;
    if (next_is_variable()) return over_set(token);
    std::vector<Pointer> arguments;
    if (!next_is(")")) {
      arguments.push_back(statement());
      while (next_is(",")) {
        ++at_;
        arguments.push_back(statement());
      }
    }
    take(")", "a comma or )");
    return node(Operation::call, token.offset, std::move(arguments), token.text);
  }

  Rational integer() {
    if (here().kind != TokenKind::number) refuse("a number");
    if (here().text.size() > most_digits) throw FormulaError(here().offset, "a number of more than 1000 digits");
    // GMP takes leading zeros for octal.
    const std::size_t first = here().text.find_first_not_of('0');
    Rational result(first == std::string::npos ? Integer(0) : Integer(here().text.substr(first)));
    ++at_;
    return result;
  }

  Rational rational() {
    const bool negative = next_is("-");
    if (negative) ++at_;
    Rational result = integer();
    if (next_is("/")) {
      ++at_;
      const std::size_t offset = here().offset;
      const Rational denominator = integer();
      if (denominator == Rational(0)) throw FormulaError(offset, "a denominator of 0");
      result /= denominator;
    }
    return negative ? -result : result;
  }

  /// Nothing for infinity, which has a minus sign at a lower end.
  std::optional<Rational> end(bool lower) {
    const std::size_t begin = here().offset;
    const bool negative = next_is("-");
    if (!tokens_[at_ + (negative ? 1 : 0)].is("infinity")) return rational();
    if (negative != lower) throw FormulaError(begin, "an empty interval");
    at_ += negative ? 2 : 1;
    return std::nullopt;
  }

  static bool is_empty(const Rational& lower, const Rational& upper, bool has_both) {
    return upper < lower || (upper == lower && !has_both);
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::unordered_map<const Expression*, std::size_t> heights_;  ///< of the trees that are not leaves
};

}  // namespace

ExpressionPointer parse_formula(std::string_view text) { return Parser(text).whole(); }

std::optional<Operation> operation_over_set(std::string_view word) {
  for (const Operation operation :
       {Operation::sum_over, Operation::product_over, Operation::least_over, Operation::greatest_over}) {
    if (word == word_over_set(operation)) return operation;
  }
  return std::nullopt;
}

std::string_view word_over_set(Operation operation) {
  switch (operation) {
    case Operation::sum_over:
      return "sum";
    case Operation::product_over:
      return "product";
    case Operation::least_over:
      return "min";
    case Operation::greatest_over:
      return "max";
    default:
      return "";
  }
}

ParameterRange parse_range(std::string_view text) { return Parser(text).range(); }

}  // namespace delcert
