#include "proofs/prover/goal.hpp"

#include <algorithm>
#include <stdexcept>

namespace delcert {

namespace {

/// A root box is looked at once, not subdivided; large tensors are left to the search.
constexpr std::size_t most_coefficients_for_signs = 20000;

ExpressionPointer join(Operation operation, ExpressionPointer a, ExpressionPointer b, const Type& type = types::truth) {
  auto result = std::make_shared<Expression>();
  result->operation = operation;
  result->type = type;
  result->children = {std::move(a), std::move(b)};
  return result;
}

ExpressionPointer negative(const ExpressionPointer& term) {
  auto result = std::make_shared<Expression>();
  result->operation = Operation::negate;
  result->type = term->type;
  result->children = {term};
  return result;
}

bool may_be_undefined(const Expression& term) {
  if (term.operation == Operation::divide || term.operation == Operation::power) return true;
  if (term.operation == Operation::call && (term.text == "sqrt" || term.text == "log2")) return true;
  return std::any_of(term.children.begin(), term.children.end(),
                     [](const auto& child) { return may_be_undefined(*child); });
}

/// The terms of which the greatest (least) is meant; empty if the term is no max, min or abs.
std::vector<ExpressionPointer> candidates(const ExpressionPointer& term) {
  if (term->operation != Operation::call) return {};
  if (term->text == "max" || term->text == "min") return term->children;
  if (term->text == "abs") return {term->children[0], negative(term->children[0])};
  return {};
}

/// max(a, b) <= c is a <= c and b <= c; max(a, b) >= c is a >= c or b >= c if both have values.
ExpressionPointer resolved_comparison(const ExpressionPointer& comparison) {
  if (comparison->operation == Operation::equal) return comparison;
  const bool less = comparison->operation == Operation::less || comparison->operation == Operation::less_equal;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const auto terms = candidates(comparison->children[side]);
    if (terms.empty()) continue;
    const bool greatest = comparison->children[side]->text != "min";
    const bool for_all = greatest == (less == (side == 0));
    ExpressionPointer result;
    for (const auto& term : terms) {
      auto part = std::make_shared<Expression>(*comparison);
      part->children[side] = term;
      auto next = resolved_comparison(part);
      result = result ? join(for_all ? Operation::conjunction : Operation::disjunction, result, next) : next;
    }
    if (for_all) return result;
    for (const auto& term : terms) {
      if (may_be_undefined(*term)) result = join(Operation::conjunction, join(Operation::equal, term, term), result);
    }
    return result;
  }
  return comparison;
}

ExpressionPointer resolved(const ExpressionPointer& statement) {
  if (is_comparison(statement->operation)) return resolved_comparison(statement);
  auto result = std::make_shared<Expression>(*statement);
  for (auto& child : result->children) child = resolved(child);
  return result;
}

void split(const std::vector<ExpressionPointer>& hypotheses, const ExpressionPointer& claim,
           std::vector<ExpressionPointer>& goals) {
  if (claim->operation == Operation::conjunction) {
    for (const auto& part : claim->children) split(hypotheses, part, goals);
    return;
  }
  if (claim->operation == Operation::implication) {
    auto longer = hypotheses;
    longer.push_back(claim->children[0]);
    split(longer, claim->children[1], goals);
    return;
  }
  ExpressionPointer goal = claim;
  for (auto hypothesis = hypotheses.rbegin(); hypothesis != hypotheses.rend(); ++hypothesis) {
    goal = join(Operation::implication, *hypothesis, goal);
  }
  goals.push_back(std::move(goal));
}

Sign common_sign(Sign a, Sign b) {
  if (a == b) return a;
  const auto is = [](Sign sign, Sign strict, Sign weak) {
    return sign == strict || sign == weak || sign == Sign::zero;
  };
  if (is(a, Sign::positive, Sign::nonnegative) && is(b, Sign::positive, Sign::nonnegative)) return Sign::nonnegative;
  if (is(a, Sign::negative, Sign::nonpositive) && is(b, Sign::negative, Sign::nonpositive)) return Sign::nonpositive;
  return Sign::unknown;
}

class Builder {
 public:
  Builder(const ExpressionPointer& statement, const std::map<std::string, StepRange>& parameters) {
    goal_.statement = statement;
    for (const auto& [name, range] : parameters) {
      goal_.names.push_back(name);
      goal_.ranges.push_back(range);
    }
    goal_.is_squared.assign(goal_.names.size(), false);
  }

  Goal build() {
    goal_.root = collect(goal_.statement);
    // A root that is met may ask for other variables; each round adds one at least.
    while (true) {
      start_reading();
      for (Atom& atom : goal_.atoms) {
        try {
          read(atom);
        } catch (const Polynomial::NotFactored&) {
          atom.polynomial.reset();
        }
      }
      bool again = false;
      for (const std::size_t parameter : reader_->wanted_squares()) {
        if (!goal_.is_squared[parameter]) again = true;
        goal_.is_squared[parameter] = true;
      }
      if (!again) break;
    }
    goal_.tape = EnclosureTape(goal_.names);
    for (Atom& atom : goal_.atoms) {
      if (atom.polynomial) continue;
      clear_denominators(atom);
      atom.enclosure =
          atom.is_about_definedness ? goal_.tape.add(atom.left) : goal_.tape.add_difference(atom.left, atom.right);
    }
    return std::move(goal_);
  }

 private:
  std::size_t node(GoalNode::Kind kind, std::vector<std::size_t> children, std::size_t atom = 0) {
    goal_.nodes.push_back({kind, atom, std::move(children)});
    return goal_.nodes.size() - 1;
  }

  std::size_t collect(const ExpressionPointer& statement) {
    if (is_comparison(statement->operation)) {
      const auto& left = statement->children[0];
      const auto& right = statement->children[1];
      const bool definedness = statement->operation == Operation::equal && left == right;
      goal_.atoms.push_back({statement->operation, left, right, definedness, std::nullopt, 0});
      return node(GoalNode::Kind::atom, {}, goal_.atoms.size() - 1);
    }
    const std::size_t first = collect(statement->children.at(0));
    if (statement->operation == Operation::negation) return node(GoalNode::Kind::negation, {first});
    const std::size_t second = collect(statement->children.at(1));
    if (statement->operation == Operation::implication) {
      return node(GoalNode::Kind::disjunction, {node(GoalNode::Kind::negation, {first}), second});
    }
    const bool is_conjunction = statement->operation == Operation::conjunction;
    return node(is_conjunction ? GoalNode::Kind::conjunction : GoalNode::Kind::disjunction, {first, second});
  }

  void start_reading() {
    goal_.ring = std::make_shared<const PolynomialRing>(goal_.names);
    goal_.factors.clear();
    boxes_ = boxes_of(goal_.ranges, goal_.is_squared);
    reader_.emplace(goal_.ring, goal_.is_squared, [this](const Polynomial& p) { return sign_everywhere(p); });
  }

  /// a/b <= c becomes a <= c*b where b is positive everywhere: of a quotient without bound above and below, nothing
  /// would be known.
  void clear_denominators(Atom& atom) {
    while (!atom.is_about_definedness) {
      if (atom.left->operation == Operation::divide && is_positive_everywhere(atom.left->children[1])) {
        atom.right = join(Operation::multiply, atom.right, atom.left->children[1], types::number);
        atom.left = atom.left->children[0];
      } else if (atom.right->operation == Operation::divide && is_positive_everywhere(atom.right->children[1])) {
        atom.left = join(Operation::multiply, atom.left, atom.right->children[1], types::number);
        atom.right = atom.right->children[0];
      } else {
        return;
      }
    }
  }

  bool is_positive_everywhere(const ExpressionPointer& term) {
    EnclosureTape tape(goal_.names);
    const std::size_t number = tape.add(term);
    return std::all_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      tape.evaluate(parameter_box(box, PrecisionBits{64}));
      return tape.value(number) && tape.value(number)->is_positive();
    });
  }

  Sign sign_everywhere(const Polynomial& p) const {
    if (p.is_zero()) return Sign::zero;
    const auto factors = p.factors();
    Sign result = factors.constant < Rational(0) ? Sign::negative : Sign::positive;
    for (const auto& factor : factors.powers) {
      const Sign sign = sign_on(boxes_, factor.base);
      result = product(result, factor.exponent % 2 == 0 ? even_power(sign) : sign);
    }
    return result;
  }

  std::size_t factor_number(const Polynomial& factor) {
    const auto found = std::find(goal_.factors.begin(), goal_.factors.end(), factor);
    if (found != goal_.factors.end()) return static_cast<std::size_t>(found - goal_.factors.begin());
    goal_.factors.push_back(factor);
    return goal_.factors.size() - 1;
  }

  void read(Atom& atom) {
    atom.polynomial.reset();
    reader_->forget_divisors();
    const auto left = reader_->read(*atom.left);
    const auto right = reader_->read(*atom.right);
    if (!left || !right) return;
    const Polynomial difference = left->numerator * right->denominator - right->numerator * left->denominator;
    if (difference.term_count() > 20000) return;
    PolynomialForm form;
    std::vector<Polynomial> divisors = reader_->divisors();
    form.constant = Rational(0);
    if (!difference.is_zero()) {
      form.constant = Rational(1);
      multiply(form, difference, 1);
      multiply(form, left->denominator, -1);
      multiply(form, right->denominator, -1);
    }
    for (const Polynomial& divisor : divisors) {
      for (const auto& factor : divisor.factors().powers) form.divisors.push_back(factor_number(factor.base));
    }
    std::sort(form.divisors.begin(), form.divisors.end());
    form.divisors.erase(std::unique(form.divisors.begin(), form.divisors.end()), form.divisors.end());
    atom.polynomial = std::move(form);
  }

  /// Multiplies by p, or divides by it if the direction is −1.
  void multiply(PolynomialForm& form, const Polynomial& p, long direction) {
    const auto factors = p.factors();
    form.constant *= power(factors.constant, direction);
    for (const auto& [base, exponent] : factors.powers) {
      const std::size_t number = factor_number(base);
      const auto known = std::find_if(form.powers.begin(), form.powers.end(),
                                      [&](const PolynomialForm::Power& one) { return one.factor == number; });
      const long change = direction * static_cast<long>(exponent);
      if (known == form.powers.end()) {
        form.powers.push_back({number, change});
      } else {
        known->exponent += change;
      }
    }
  }

  Goal goal_;
  std::vector<Box> boxes_;
  std::optional<RationalFunctionReader> reader_;
};

}  // namespace

std::string Goal::method() const {
  const auto count =
      std::count_if(atoms.begin(), atoms.end(), [](const Atom& atom) { return atom.polynomial.has_value(); });
  return static_cast<std::size_t>(count) == atoms.size() ? "polynomial" : count == 0 ? "interval" : "mixed";
}

Verdict Goal::value(std::size_t node, const std::vector<Verdict>& verdicts) const {
  const GoalNode& here = nodes[node];
  switch (here.kind) {
    case GoalNode::Kind::atom:
      return verdicts[here.atom];
    case GoalNode::Kind::negation:
      return negation(value(here.children[0], verdicts));
    case GoalNode::Kind::conjunction:
      return conjunction(value(here.children[0], verdicts), value(here.children[1], verdicts));
    default:
      return disjunction(value(here.children[0], verdicts), value(here.children[1], verdicts));
  }
}

std::vector<ExpressionPointer> goal_statements(const std::vector<ExpressionPointer>& hypotheses,
                                               const ExpressionPointer& claim) {
  std::vector<ExpressionPointer> resolved_hypotheses;
  for (const auto& hypothesis : hypotheses) resolved_hypotheses.push_back(resolved(hypothesis));
  std::vector<ExpressionPointer> goals;
  split(resolved_hypotheses, resolved(claim), goals);
  return goals;
}

Goal make_goal(const ExpressionPointer& statement, const std::map<std::string, StepRange>& parameters) {
  return Builder(statement, parameters).build();
}

Sign sign_on(const std::vector<Box>& boxes, const Polynomial& polynomial) {
  std::optional<Sign> result;
  for (const Box& box : boxes) {
    std::vector<UnitMap> maps;
    std::vector<OpenEnds> open;
    for (const BoxSide& side : box) {
      maps.push_back(side.map);
      open.push_back(side.unit_open());
    }
    try {
      const Sign here = BernsteinTensor(polynomial, maps, most_coefficients_for_signs).sign(open);
      result = result ? common_sign(*result, here) : here;
    } catch (const std::length_error&) {
      return Sign::unknown;
    }
  }
  return result.value_or(Sign::unknown);
}

Verdict verdict_of(Operation relation, Sign difference) {
  const bool nonnegative = difference == Sign::nonnegative || difference == Sign::positive || difference == Sign::zero;
  const bool nonpositive = difference == Sign::nonpositive || difference == Sign::negative || difference == Sign::zero;
  const auto choose = [](bool proved, bool refuted) {
    return proved ? Verdict::proved : refuted ? Verdict::refuted : Verdict::undecided;
  };
  switch (relation) {
    case Operation::less:
      return choose(difference == Sign::negative, nonnegative);
    case Operation::less_equal:
      return choose(nonpositive, difference == Sign::positive);
    case Operation::greater:
      return choose(difference == Sign::positive, nonpositive);
    case Operation::greater_equal:
      return choose(nonnegative, difference == Sign::negative);
    default:
      return choose(difference == Sign::zero, is_strict(difference));
  }
}

}  // namespace delcert
