#include "kernel/formula/map_piece.hpp"

#include <numeric>

namespace delcert {

namespace {

constexpr std::size_t most_pieces = 64;
constexpr std::size_t most_absolute_values = 10;

/// Σ c_k x_k + c > 0: the coefficients, then c.
using Inequality = std::vector<Rational>;

Inequality inequality_of(const Polynomial& p) {
  Inequality result(p.ring()->variable_count() + 1);
  for (const Polynomial::Term& term : p.terms()) {
    std::size_t at = 0;
    while (at + 1 < result.size() && term.exponents[at] == 0) ++at;
    result[at] = term.coefficient;
  }
  return result;
}

/// Both, such that the coefficient `at`, positive in one and negative in the other, is 0.
Inequality without(std::size_t at, const Inequality& positive, const Inequality& negative) {
  Inequality result;
  for (std::size_t k = 0; k < positive.size(); ++k)
    result.push_back(positive[at] * negative[k] - negative[at] * positive[k]);
  return result;
}

/// Chooses signs for the absolute values of formulas, in the order in which they are read.
class SignPattern {
 public:
  /// ±a, and the condition for it; none if that is not affine, or there are too many.
  std::optional<RationalFunction> absolute_value(const RationalFunction& a) {
    if (!a.denominator.constant() || !is_affine(a.numerator)) return std::nullopt;
    if (const auto value = a.numerator.constant())
      return *value < Rational(0) ? RationalFunction{-a.numerator, a.denominator} : a;
    if (used_ == is_negative_.size()) {
      if (used_ == most_absolute_values) return std::nullopt;
      is_negative_.push_back(false);
    }
    const RationalFunction result = is_negative_[used_++] ? RationalFunction{-a.numerator, a.denominator} : a;
    conditions_.push_back(result.numerator);
    return result;
  }

  /// To be called when all formulas have been read.
  [[nodiscard]] std::vector<Polynomial> take_conditions() { return std::move(conditions_); }
  /// Goes on to the next pattern; false if there is none.
  bool advance() {
    used_ = 0;
    conditions_.clear();
    while (!is_negative_.empty() && is_negative_.back()) is_negative_.pop_back();
    if (is_negative_.empty()) return false;
    is_negative_.back() = true;
    return true;
  }

 private:
  std::vector<bool> is_negative_;
  std::size_t used_ = 0;
  std::vector<Polynomial> conditions_;
};

bool is_affine(const std::vector<RationalFunction>& map) {
  for (const RationalFunction& f : map) {
    if (!f.denominator.constant() || !is_affine(f.numerator)) return false;
  }
  return true;
}

}  // namespace

bool is_affine(const Polynomial& p) {
  for (const Polynomial::Term& term : p.terms()) {
    if (std::accumulate(term.exponents.begin(), term.exponents.end(), 0UL) > 1) return false;
  }
  return true;
}

bool may_be_positive_together(const std::vector<Polynomial>& polynomials) {
  std::vector<Inequality> left;
  for (const Polynomial& p : polynomials) {
    if (is_affine(p)) left.push_back(inequality_of(p));
  }
  if (left.empty()) return true;
  const std::size_t variables = left.front().size() - 1;
  for (std::size_t at = 0; at < variables; ++at) {
    std::vector<Inequality> next;
    for (const Inequality& one : left) {
      if (one[at] == Rational(0)) next.push_back(one);
      if (one[at] <= Rational(0)) continue;
      for (const Inequality& other : left) {
        if (other[at] < Rational(0)) next.push_back(without(at, one, other));
      }
    }
    left = std::move(next);
  }
  for (const Inequality& constant : left) {
    if (constant.back() <= Rational(0)) return false;
  }
  return true;
}

std::optional<std::vector<MapPiece>> pieces_of(const std::vector<ExpressionPointer>& formulas,
                                               const std::vector<std::string>& variables, const RingPointer& ring) {
  std::vector<MapPiece> result;
  SignPattern signs;
  do {
    MapPiece piece;
    for (const ExpressionPointer& formula : formulas) {
      auto f = rational_function_of(*formula, variables, ring,
                                    [&](const RationalFunction& a) { return signs.absolute_value(a); });
      if (!f) return std::nullopt;
      piece.map.push_back(*std::move(f));
    }
    piece.nonnegative = signs.take_conditions();
    if (!piece.nonnegative.empty() && !is_affine(piece.map)) return std::nullopt;
    if (may_be_positive_together(piece.nonnegative)) result.push_back(std::move(piece));
    if (result.size() > most_pieces) return std::nullopt;
  } while (signs.advance());
  return result;
}

std::optional<std::vector<MapPiece>> composed(const std::vector<MapPiece>& second, const std::vector<MapPiece>& first) {
  std::vector<MapPiece> result;
  for (const MapPiece& one : first) {
    for (const MapPiece& other : second) {
      MapPiece both{one.nonnegative, {}};
      for (const Polynomial& p : other.nonnegative) both.nonnegative.push_back(sign_after(p, one.map));
      if (!may_be_positive_together(both.nonnegative)) continue;
      for (const RationalFunction& f : other.map) {
        auto found = composed(f, one.map);
        if (!found) return std::nullopt;
        both.map.push_back(*std::move(found));
      }
      result.push_back(std::move(both));
    }
  }
  return result;
}

Polynomial sign_after(const Polynomial& p, const std::vector<RationalFunction>& f) {
  const RationalFunction found = composed(p, f);
  return found.denominator.constant() ? found.numerator : found.numerator * found.denominator;
}

bool are_same(const std::vector<RationalFunction>& a, const std::vector<RationalFunction>& b) {
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    if (!(a[axis] == b[axis])) return false;
  }
  return true;
}

bool is_identity(const std::vector<RationalFunction>& map) {
  for (std::size_t axis = 0; axis < map.size(); ++axis) {
    if (!(map[axis] == variable_function(map[axis].numerator.ring(), axis))) return false;
  }
  return true;
}

}  // namespace delcert
