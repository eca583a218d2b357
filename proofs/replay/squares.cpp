#include "proofs/replay/squares.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace delcert::replay {

int truth(const std::string& relation, int sign) {
  if (relation == "<") return sign == -2 ? 1 : sign >= 0 ? -1 : 0;
  if (relation == "<=") return sign <= 0 ? 1 : sign == 2 ? -1 : 0;
  if (relation == ">") return sign == 2 ? 1 : sign <= 0 ? -1 : 0;
  if (relation == ">=") return sign >= 0 ? 1 : sign == -2 ? -1 : 0;
  return sign == 0 ? 1 : sign == 2 || sign == -2 ? -1 : 0;
}

namespace {

using Json = nlohmann::json;

class SquaresReplay {
 public:
  SquaresReplay(const Json& json, const GoalParts& goal) : json_(json), goal_(goal) {}

  void run() {
    const Node* claim = &goal_.statement;
    std::size_t at = 0;
    while (claim->head == "implies") {
      collect(*claim->parts.at(0), true, at);
      claim = claim->parts.at(1).get();
    }
    if (!claim->is_comparison() || at + 1 != goal_.comparisons.size() || goal_.comparisons[at] != claim) {
      throw Rejected("squares for a conclusion that is no single comparison");
    }
    for (const Json& constraint : json_.at("constraints")) constraints_.push_back(read_constraint(constraint));
    for (const Json& sign : json_.at("signs")) read_sign(sign);
    if (!goal_.products[at]) throw Rejected("squares for a comparison that is no quotient of polynomials");
    const Sign sign = sign_of(*goal_.products[at], [this](std::size_t factor) { return known_sign(factor); });
    if (!sign || truth(claim->head, *sign) != 1) throw Rejected("squares that do not show the conclusion");
  }

 private:
  /// Which comparisons hold wherever all hypotheses do.
  void collect(const Node& statement, bool holds, std::size_t& at) {
    if (statement.is_comparison()) {
      if (holds) assumed_.insert(at);
      ++at;
      return;
    }
    for (const NodePointer& part : statement.parts) collect(*part, holds && statement.head == "and", at);
  }

  /// What is not negative where the hypotheses hold.
  Polynomial read_constraint(const Json& json) const {
    const std::string kind = json.at(0).get<std::string>();
    if (kind == "lower" || kind == "upper") {
      const std::size_t at = goal_.variables.index(json.at(1).get<std::string>());
      const Side& range = goal_.ranges.at(at);
      const Polynomial x = Polynomial::variable(at, goal_.variables);
      std::optional<Number> end = kind == "lower" ? range.lower : range.upper;
      // Of a root only that it is not negative.
      if (range.is_squared) end = kind == "lower" ? std::optional<Number>(Number(0)) : std::nullopt;
      if (!end) throw Rejected("an end of a range that has none");
      const Polynomial constant(goal_.variables, *end);
      return kind == "lower" ? x - constant : constant - x;
    }
    if (kind != "comparison") throw Malformed("a constraint that is " + kind);
    const auto at = json.at(1).get<std::size_t>();
    const bool is_turned = json.at(2).get<bool>();
    if (!assumed_.contains(at)) throw Rejected("a comparison that no hypothesis grants");
    const auto& product = goal_.products.at(at);
    if (!product || !product->divisors.empty()) throw Rejected("a constraint that is no polynomial");
    Polynomial difference(goal_.variables, product->constant);
    for (const auto& [factor, exponent] : product->powers) {
      if (exponent < 0) throw Rejected("a constraint that is no polynomial");
      difference = difference * goal_.factors.at(factor).power(static_cast<unsigned long>(exponent));
    }
    const std::string& relation = goal_.comparisons.at(at)->head;
    bool is_negative = relation == "<" || relation == "<=";
    if (is_turned) {
      if (relation != "=") throw Rejected("a comparison that is turned, but no equation");
      is_negative = true;
    }
    return is_negative ? Polynomial(goal_.variables) - difference : difference;
  }

  void read_sign(const Json& json) {
    const auto factor = json.at("factor").get<std::size_t>();
    const int sign = json.at("sign").get<int>();
    if (sign < -2 || sign > 2) throw Malformed("the sign is not in -2 to 2");
    const Polynomial& polynomial = goal_.factors.at(factor);
    if (!json.contains("terms")) {
      require_on_boxes(polynomial, sign);
    } else {
      if (sign == 0) throw Rejected("squares for a sign that is 0");
      require_sum(json.at("terms"), sign > 0 ? polynomial : Polynomial(goal_.variables) - polynomial,
                  std::abs(sign) == 2);
    }
    int& known = signs_.try_emplace(factor, sign).first->second;
    if (std::abs(sign) == 2) known = sign;
  }

  /// A sign that is found may say more than the one that is needed: 0 is neither positive nor negative.
  static bool shows(int found, int sign) {
    if (sign == 0 || std::abs(sign) == 2) return found == sign;
    return sign > 0 ? found >= 0 : found <= 0;
  }

  void require_on_boxes(const Polynomial& polynomial, int sign) const {
    for (const auto& box : goal_.boxes) {
      std::vector<Side> sides;
      for (const Side& side : box) sides.push_back(variable_side(side));
      const auto found = polynomial.sign_on(sides);
      if (!found || !shows(*found, sign)) throw Rejected("a sign that the ranges do not show");
    }
  }

  void require_sum(const Json& terms, const Polynomial& polynomial, bool strict) const {
    Polynomial sum(goal_.variables);
    bool has_constant = false;
    for (const Json& term : terms) {
      const Number weight = Number::read(term.at("weight").get<std::string>());
      if (weight.sign() <= 0) throw Rejected("a square with a weight that is not positive");
      const Polynomial base = Polynomial::read(term.at("base").get<std::string>(), goal_.variables);
      Polynomial product = Polynomial(goal_.variables, weight) * base * base;
      for (const Json& number : term.at("times")) product = product * constraints_.at(number.get<std::size_t>());
      const auto constant = base.constant();
      has_constant = has_constant || (term.at("times").empty() && constant && constant->sign() != 0);
      sum = sum + product;
    }
    if (!(sum == polynomial)) throw Rejected("squares of which the sum is another polynomial");
    if (strict && !has_constant) throw Rejected("squares that may vanish together");
  }

  [[nodiscard]] Sign known_sign(std::size_t factor) const {
    const auto found = signs_.find(factor);
    return found == signs_.end() ? std::nullopt : std::optional(found->second);
  }

  const Json& json_;
  const GoalParts& goal_;
  std::set<std::size_t> assumed_;
  std::vector<Polynomial> constraints_;
  std::map<std::size_t, int> signs_;
};

}  // namespace

void require_proved_by_squares(const Json& squares, const GoalParts& goal) { SquaresReplay(squares, goal).run(); }

}  // namespace delcert::replay
