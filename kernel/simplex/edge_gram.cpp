#include "kernel/simplex/edge_gram.hpp"

#include <algorithm>

#include "kernel/simplex/fraction_free.hpp"

namespace delcert {

namespace {

using Points = std::vector<std::vector<Rational>>;

std::size_t bits_of(mpz_srcptr integer) { return mpz_sizeinbase(integer, 2); }
/// The least common denominator of all coordinates, while it is not much longer than the longest of them: 0 where it
/// is.
Integer common_denominator(const Points& points) {
  constexpr std::size_t spare_bits = 64;
  std::size_t longest = 0;
  for (const auto& point : points) {
    for (const Rational& x : point) longest = std::max(longest, bits_of(mpq_denref(x.gmp())));
  }
  Integer result(1);
  for (const auto& point : points) {
    for (const Rational& x : point) {
      include_denominator(result, x);
      if (bits_of(raw(result)) > 2 * longest + spare_bits) return Integer(0);
    }
  }
  return result;
}

/// The edges p_i − p_0, i = 1 … k, times a common denominator.
std::vector<std::vector<Integer>> integral_edges(const Points& points, const Integer& denominator) {
  std::vector<std::vector<Integer>> result;
  for (const auto& point : points) {
    auto& integral = result.emplace_back();
    for (const Rational& x : point) integral.push_back(whole_multiple(x, denominator));
  }
  for (std::size_t i = 1; i < result.size(); ++i) {
    for (std::size_t axis = 0; axis < result[i].size(); ++axis) result[i][axis] -= result[0][axis];
  }
  result.erase(result.begin());
  return result;
}

/// numerator/(denominator)², where the denominator is a power of two with this exponent if that is not negative.
Rational over_square(const Integer& numerator, const Integer& squared_denominator, long exponent) {
  if (exponent < 0) return Rational(numerator, squared_denominator);
  Rational::Wrapped result(numerator);
  mpq_div_2exp(result.backend().data(), result.backend().data(), static_cast<mp_bitcnt_t>(2 * exponent));
  return Rational(std::move(result));
}

}  // namespace

EdgeGram<Rational> edge_gram_from_points(const Points& points) {
  const auto in_fractions = [&points] {
    return edge_gram_from_points(points, [](const std::vector<Rational>& x, const std::vector<Rational>& y) {
      Rational sum(0);
      for (std::size_t axis = 0; axis < x.size(); ++axis) sum += x[axis] * y[axis];
      return sum;
    });
  };
  const bool fit = std::all_of(points.begin(), points.end(),
                               [&](const auto& point) { return point.size() == points.front().size(); });
  // What does not fit is refused there.
  if (points.size() < 2 || !fit) return in_fractions();
  const Integer denominator = common_denominator(points);
  if (denominator == 0) return in_fractions();
  const auto shift = static_cast<long>(bits_of(raw(denominator))) - 1;
  const bool is_dyadic = mpz_scan1(raw(denominator), 0) == static_cast<mp_bitcnt_t>(shift);
  const Integer squared = denominator * denominator;

  const auto over_squared = [&, exponent = is_dyadic ? shift : -1](const Integer& numerator) {
    return over_square(numerator, squared, exponent);
  };

  const auto edges = integral_edges(points, denominator);
  const std::size_t k = edges.size();
  SymmetricMatrix<Rational> gram(k);
  SymmetricMatrix<Rational> squared_edges(k + 1);
  std::vector<Integer> squares(k);
  std::vector<Integer> products(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Integer product;
      for (std::size_t axis = 0; axis < edges[i].size(); ++axis) {
        mpz_addmul(raw(product), raw(edges[i][axis]), raw(edges[j][axis]));
      }
      gram(i, j) = over_squared(product);
      if (i == j) {
        squared_edges(i + 1, 0) = gram(i, i);
        squares[i] = std::move(product);
      } else {
        products[j] = std::move(product);
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      // |e_i − e_j|²
      squared_edges(i + 1, j + 1) = over_squared(squares[i] + squares[j] - products[j] - products[j]);
    }
  }
  return {std::move(gram), std::move(squared_edges)};
}

}  // namespace delcert
