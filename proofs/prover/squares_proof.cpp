#include "proofs/prover/squares_proof.hpp"

#include <algorithm>

namespace delcert {

namespace {

constexpr std::size_t most_terms = 400;

class SquaresSearch {
 public:
  explicit SquaresSearch(const Goal& goal) : goal_(goal), boxes_(boxes_of(goal.ranges, goal.is_squared)) {}

  std::optional<SquaresProof> run() {
    const Expression* claim = goal_.statement.get();
    std::size_t atom = 0;
    while (claim->operation == Operation::implication) {
      collect(*claim->children[0], true, atom);
      claim = claim->children[1].get();
    }
    if (!is_comparison(claim->operation) || claim->operation == Operation::equal) return std::nullopt;
    const Atom& conclusion = goal_.atoms.at(atom);
    if (!conclusion.polynomial || conclusion.polynomial->constant == Rational(0)) return std::nullopt;
    add_ends();
    for (const SquaresConstraint& constraint : proof_.constraints) polynomials_.push_back(constraint.polynomial);
    make_points();
    if (!signs_of(*conclusion.polynomial, conclusion.relation)) return std::nullopt;
    // Without a single square it would be no proof of another kind than the search's.
    const bool has_squares = std::any_of(proof_.signs.begin(), proof_.signs.end(),
                                         [](const FactorSign& sign) { return !sign.terms.empty(); });
    if (!has_squares) return std::nullopt;
    return std::move(proof_);
  }

 private:
  /// The comparisons of a hypothesis that hold whenever it does; the others are only counted.
  void collect(const Expression& statement, bool holds, std::size_t& atom) {
    if (is_comparison(statement.operation)) {
      if (holds) add_comparison(atom);
      ++atom;
      return;
    }
    const bool parts_hold = holds && statement.operation == Operation::conjunction;
    for (const auto& child : statement.children) collect(*child, parts_hold, atom);
  }

  /// Only what is a polynomial: a quotient might have no value.
  void add_comparison(std::size_t number) {
    const Atom& atom = goal_.atoms[number];
    if (!atom.polynomial || !atom.polynomial->divisors.empty()) return;
    Polynomial difference(goal_.ring, atom.polynomial->constant);
    for (const auto& power : atom.polynomial->powers) {
      if (power.exponent < 0) return;
      difference = difference * goal_.factors[power.factor].power(static_cast<unsigned long>(power.exponent));
    }
    if (difference.constant() || difference.term_count() > most_terms) return;
    const auto kind = SquaresConstraint::Kind::comparison;
    switch (atom.relation) {
      case Operation::less:
      case Operation::less_equal:
        proof_.constraints.push_back({kind, number, false, -difference});
        break;
      case Operation::greater:
      case Operation::greater_equal:
        proof_.constraints.push_back({kind, number, false, difference});
        break;
      default:
        proof_.constraints.push_back({kind, number, false, difference});
        proof_.constraints.push_back({kind, number, true, -difference});
    }
  }

  /// The ends of the variables: of roots where a parameter is squared.
  void add_ends() {
    for (std::size_t i = 0; i < goal_.names.size(); ++i) {
      const auto [lower, upper] = variable_ends(i);
      const Polynomial x = Polynomial::variable(goal_.ring, i);
      if (lower) {
        proof_.constraints.push_back(
            {SquaresConstraint::Kind::lower_end, i, false, x - Polynomial(goal_.ring, *lower)});
      }
      if (upper) {
        proof_.constraints.push_back(
            {SquaresConstraint::Kind::upper_end, i, false, Polynomial(goal_.ring, *upper) - x});
      }
    }
  }

  /// Of a root only that it is not negative.
  [[nodiscard]] std::pair<std::optional<Rational>, std::optional<Rational>> variable_ends(std::size_t i) const {
    if (goal_.is_squared[i]) return {Rational(0), std::nullopt};
    return {goal_.ranges[i].lower, goal_.ranges[i].upper};
  }

  /// Points at which no constraint is negative, the same ones each time: they tell which sign a factor may have.
  void make_points() {
    constexpr int most_tries = 400;
    constexpr std::size_t enough = 60;
    unsigned long state = 12345;
    const auto next = [&state](unsigned long bound) {
      state = (state * 1103515245UL + 12345UL) % 2147483648UL;
      return static_cast<long>((state >> 8U) % bound);
    };
    for (int tries = 0; tries < most_tries && points_.size() < enough; ++tries) {
      std::vector<Rational> point;
      for (std::size_t i = 0; i < goal_.names.size(); ++i) {
        const auto [lower, upper] = variable_ends(i);
        const Rational part = Rational(next(33)) / Rational(32);
        const Rational far = Rational(next(64)) / Rational(1 + next(16));
        if (lower && upper) {
          point.push_back(*lower + (*upper - *lower) * part);
        } else if (lower) {
          point.push_back(*lower + far);
        } else if (upper) {
          point.push_back(*upper - far);
        } else {
          point.push_back(next(2) == 0 ? far : -far);
        }
      }
      if (point.empty()) point.emplace_back(0);
      const bool is_allowed = std::all_of(polynomials_.begin(), polynomials_.end(),
                                          [&](const Polynomial& p) { return !(p.at(point) < Rational(0)); });
      if (is_allowed) points_.push_back(std::move(point));
    }
  }

  bool signs_of(const PolynomialForm& form, Operation relation) {
    for (const std::size_t divisor : form.divisors) {
      if (!is_strict(sign_of(divisor, true))) return false;
    }
    const bool strict = relation == Operation::less || relation == Operation::greater;
    Sign result = form.constant < Rational(0) ? Sign::negative : Sign::positive;
    for (const auto& power : form.powers) {
      if (!strict && power.exponent % 2 == 0) {
        result = product(result, Sign::nonnegative);
        continue;
      }
      const Sign sign = sign_of(power.factor, strict || power.exponent < 0);
      if (sign == Sign::unknown) return false;
      result = product(result, power.exponent % 2 != 0 ? sign : even_power(sign));
    }
    return is_proved(verdict_of(relation, result));
  }

  Sign sign_of(std::size_t factor, bool strict) {
    for (const FactorSign& known : proof_.signs) {
      if (known.factor == factor && (!strict || is_strict(known.sign))) return known.sign;
    }
    const Polynomial& polynomial = goal_.factors[factor];
    const Sign on_boxes = sign_on(boxes_, polynomial);
    if (on_boxes != Sign::unknown && (!strict || is_strict(on_boxes))) {
      proof_.signs.push_back({factor, on_boxes, {}});
      return on_boxes;
    }
    if (polynomial.term_count() > most_terms) return Sign::unknown;
    bool may_be_positive = true;
    bool may_be_negative = true;
    for (const auto& point : points_) {
      const Rational value = polynomial.at(point);
      if (value < Rational(0)) may_be_positive = false;
      if (Rational(0) < value) may_be_negative = false;
    }
    for (const bool positive : {true, false}) {
      if (!(positive ? may_be_positive : may_be_negative)) continue;
      const Polynomial turned = positive ? polynomial : -polynomial;
      auto terms = strict ? positive_sum_of_squares(turned, polynomials_) : sum_of_squares(turned, polynomials_);
      if (!terms) continue;
      const Sign sign =
          positive ? (strict ? Sign::positive : Sign::nonnegative) : (strict ? Sign::negative : Sign::nonpositive);
      proof_.signs.push_back({factor, sign, std::move(*terms)});
      return sign;
    }
    return Sign::unknown;
  }

  const Goal& goal_;
  std::vector<Box> boxes_;
  SquaresProof proof_;
  std::vector<Polynomial> polynomials_;
  std::vector<std::vector<Rational>> points_;
};

}  // namespace

std::optional<SquaresProof> squares_proof(const Goal& goal) { return SquaresSearch(goal).run(); }

}  // namespace delcert
