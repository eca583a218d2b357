#include "proofs/checker/arithmetic/map_piece.hpp"

#include <algorithm>

namespace delcert::checker {
namespace {

/// c_0 x_0 + ... + c > 0: the coefficients, then c.
using Inequality = std::vector<Rational>;

Inequality inequality_of(const Polynomial& p) {
  const std::size_t m = p.variable_count();
  Vector<Rational> x{};
  const Rational c = p.at(x);
  Inequality result;
  for (std::size_t k = 0; k < m; ++k) {
    x[k] = Rational(1);
    result.push_back(p.at(x) - c);
    x[k] = Rational(0);
  }
  result.push_back(c);
  return result;
}

[[noreturn]] void refuse() {
  throw Malformed("form.formula", "a transition is neither a rational function nor piecewise linear");
}

}  // namespace

bool is_affine(const Polynomial& p) {
  const std::size_t m = p.variable_count();
  const Inequality coefficients = inequality_of(p);
  Polynomial sum(m, coefficients[m]);
  for (std::size_t k = 0; k < m; ++k) sum = sum + Polynomial(m, coefficients[k]) * Polynomial::variable(m, k);
  return sum == p;
}

bool may_be_positive_together(const std::vector<Polynomial>& polynomials) {
  std::vector<Inequality> left;
  std::size_t m = 0;
  for (const Polynomial& p : polynomials) {
    m = p.variable_count();
    if (is_affine(p)) left.push_back(inequality_of(p));
  }
  for (std::size_t at = 0; at < m; ++at) {
    std::vector<Inequality> next;
    for (const Inequality& one : left) {
      if (one[at].sign() == 0) next.push_back(one);
      for (const Inequality& other : left) {
        if (one[at].sign() <= 0 || other[at].sign() >= 0) continue;
        Budget::spend(10);
        Inequality both;
        for (std::size_t k = 0; k <= m; ++k) both.push_back(one[at] * other[k] - other[at] * one[k]);
        next.push_back(both);
      }
    }
    left = std::move(next);
  }
  return std::all_of(left.begin(), left.end(), [](const Inequality& one) { return one.back().sign() > 0; });
}

std::vector<MapPiece> pieces_of(std::size_t m, const FormulaMap& f) {
  constexpr std::size_t most_absolute_values = 10;
  std::vector<std::size_t> folds;
  for (std::size_t step = 0; step < f.steps().size(); ++step) {
    if (f.steps()[step].operation == FormulaMap::Operation::absolute && f.depends(step)) folds.push_back(step);
  }
  if (folds.size() > most_absolute_values) refuse();
  std::vector<MapPiece> result;
  for (std::size_t pattern = 0; pattern < std::size_t{1} << folds.size(); ++pattern) {
    MapPiece piece;
    bool is_repeated = false;
    const auto map = composed(f, identity_map(m), [&](std::size_t step, const RationalFunction& of) {
      if (!of.denominator.is_constant() || !is_affine(of.numerator)) refuse();
      const auto number = static_cast<std::size_t>(std::find(folds.begin(), folds.end(), step) - folds.begin());
      const Polynomial& p = of.numerator;
      const bool flipped = (pattern >> number & 1U) != 0;
      // The absolute value of a constant is no fold: one pattern is enough.
      is_repeated = is_repeated || (flipped && p.is_constant());
      const bool positive = p.is_constant() ? p.at({}).sign() >= 0 : !flipped;
      const Polynomial value = positive ? p : Polynomial(m, Rational(0)) - p;
      if (!p.is_constant()) piece.nonnegative.push_back(value);
      return RationalFunction(value);
    });
    if (!map) throw Malformed("form.formula", "a transition divides by 0 everywhere");
    piece.map = *map;
    for (const RationalFunction& g : *map) {
      if (!piece.nonnegative.empty() && !(g.denominator.is_constant() && is_affine(g.numerator))) refuse();
    }
    if (!is_repeated && may_be_positive_together(piece.nonnegative)) result.push_back(std::move(piece));
  }
  return result;
}

std::vector<Polynomial> signs_after(const std::vector<Polynomial>& polynomials, const RationalMap& map) {
  std::vector<Polynomial> result;
  const auto after = composed(formulas_of(map.size(), polynomials), map);
  for (const RationalFunction& f : *after) result.push_back(f.sign());
  return result;
}

std::optional<MapPiece> composed_pieces(const MapPiece& first, const MapPiece& second) {
  const std::size_t m = first.map.size();
  MapPiece result{{}, first.nonnegative};
  for (Polynomial& p : signs_after(second.nonnegative, first.map)) result.nonnegative.push_back(std::move(p));
  for (const RationalFunction& f : second.map) {
    const auto parts = composed(formulas_of(m, {f.numerator, f.denominator}), first.map);
    if ((*parts)[1].numerator.is_zero()) return std::nullopt;
    result.map.emplace_back((*parts)[0].numerator * (*parts)[1].denominator,
                            (*parts)[0].denominator * (*parts)[1].numerator);
  }
  return result;
}

}  // namespace delcert::checker
