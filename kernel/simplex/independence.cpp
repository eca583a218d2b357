#include "kernel/simplex/independence.hpp"

#include <cstdint>
#include <optional>

#include "kernel/simplex/realisability.hpp"

namespace delcert {

namespace {

__extension__ using Wide = unsigned __int128;

/// The Mersenne prime 2⁶¹ − 1.
constexpr unsigned field_bits = 61;
constexpr std::uint64_t prime = (std::uint64_t{1} << field_bits) - 1;

/// 2⁶¹ = 1
std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  const Wide whole = Wide{a} * b;
  const std::uint64_t sum = static_cast<std::uint64_t>(whole & prime) + static_cast<std::uint64_t>(whole >> field_bits);
  return sum >= prime ? sum - prime : sum;
}
std::uint64_t difference(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + prime - b; }

std::uint64_t inverse(std::uint64_t a) {
  // Fermat: a to the power prime − 2.
  std::uint64_t result = 1;
  for (std::uint64_t exponent = prime - 2; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = product(result, a);
    a = product(a, a);
  }
  return result;
}

/// Nothing where the denominator is a multiple of the prime.
std::optional<std::uint64_t> residue(const Rational& x) {
  mpz_srcptr denominator = mpq_denref(x.gmp());
  const std::uint64_t numerator = mpz_fdiv_ui(mpq_numref(x.gmp()), prime);
  const mp_bitcnt_t shift = mpz_sizeinbase(denominator, 2) - 1;
  if (mpz_scan1(denominator, 0) == shift) {
    return product(numerator, std::uint64_t{1} << ((field_bits - shift % field_bits) % field_bits));
  }
  const std::uint64_t divisor = mpz_fdiv_ui(denominator, prime);
  if (divisor == 0) return std::nullopt;
  return product(numerator, inverse(divisor));
}

/// Whether the rows are independent over the field.
bool are_independent(std::vector<std::vector<std::uint64_t>> rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::size_t column = 0;
    while (column < rows[row].size() && rows[row][column] == 0) ++column;
    if (column == rows[row].size()) return false;
    // Rows are multiplied by the pivot, which is not 0, instead of divided: an inverse takes longer than all products.
    const std::uint64_t pivot = rows[row][column];
    for (std::size_t later = row + 1; later < rows.size(); ++later) {
      const std::uint64_t multiplier = rows[later][column];
      if (multiplier == 0) continue;
      for (std::size_t at = 0; at < rows[row].size(); ++at) {
        rows[later][at] = difference(product(pivot, rows[later][at]), product(multiplier, rows[row][at]));
      }
    }
  }
  return true;
}

bool are_independent_modulo_prime(const std::vector<std::vector<Rational>>& points) {
  std::vector<std::vector<std::uint64_t>> residues;
  for (const auto& point : points) {
    residues.emplace_back();
    for (const Rational& x : point) {
      const auto value = residue(x);
      if (!value) return false;
      residues.back().push_back(*value);
    }
    if (residues.size() == 1) continue;
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
      residues.back()[axis] = difference(residues.back()[axis], residues.front()[axis]);
    }
  }
  residues.erase(residues.begin());
  return are_independent(std::move(residues));
}

}  // namespace

bool are_affinely_independent(const std::vector<std::vector<Rational>>& points) {
  if (points.empty()) throw std::invalid_argument("no points");
  for (const auto& point : points) {
    if (point.size() != points.front().size()) throw std::invalid_argument("points of different dimensions");
  }
  if (points.size() == 1) return true;
  if (points.size() > points.front().size() + 1) return false;
  return are_independent_modulo_prime(points) || is_proved(is_non_degenerate(edge_gram_from_points(points)));
}

}  // namespace delcert
