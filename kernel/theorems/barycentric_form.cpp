#include "kernel/theorems/barycentric_form.hpp"

#include <algorithm>
#include <limits>

namespace delcert {

namespace {

/// The monomials of each degree. The key of a monomial is the number that has its exponents for digits, so keys of
/// factors add up to that of the product.
template <int m>
struct Monomials {
  static constexpr std::size_t base = BarycentricForm<m>::greatest_degree + 1;

  std::array<std::vector<std::size_t>, base> keys;  // by degrees
  std::array<std::vector<int>, base> multiplicity;  // degree! / product of the factorials of the exponents
  std::vector<std::size_t> place;                   // of a key in the list of its degree

  static std::size_t key_of(std::size_t variable) {
    std::size_t key = 1;
    for (std::size_t k = 0; k < variable; ++k) key *= base;
    return key;
  }

  Monomials() {
    const std::size_t keys_in_all = key_of(m + 1);
    place.resize(keys_in_all);
    for (std::size_t key = 0; key < keys_in_all; ++key) {
      std::size_t degree = 0;
      int orders = 1;
      std::size_t rest = key;
      for (std::size_t variable = 0; variable <= m; ++variable, rest /= base) {
        // A product of binomial coefficients.
        for (std::size_t k = 1; k <= rest % base && degree < base; ++k) {
          ++degree;
          orders = orders * static_cast<int>(degree) / static_cast<int>(k);
        }
      }
      if (degree >= base) continue;
      place[key] = keys[degree].size();
      keys[degree].push_back(key);
      multiplicity[degree].push_back(orders);
    }
  }

  static const Monomials& all() {
    static const Monomials tables;
    return tables;
  }
};

}  // namespace

template <int m>
BarycentricForm<m>::BarycentricForm(std::size_t degree)
    : degree_(degree), coefficients_(Monomials<m>::all().keys[degree].size()) {}

template <int m>
Interval& BarycentricForm<m>::of_pair(std::size_t k, std::size_t l) {
  return coefficients_[Monomials<m>::all().place[Monomials<m>::key_of(k) + Monomials<m>::key_of(l)]];
}

template <int m>
BarycentricForm<m>& BarycentricForm<m>::operator+=(const BarycentricForm& other) {
  for (std::size_t at = 0; at < coefficients_.size(); ++at) coefficients_[at] += other.coefficients_[at];
  return *this;
}

template <int m>
BarycentricForm<m>& BarycentricForm<m>::operator-=(const BarycentricForm& other) {
  for (std::size_t at = 0; at < coefficients_.size(); ++at) coefficients_[at] -= other.coefficients_[at];
  return *this;
}

template <int m>
double BarycentricForm<m>::least_control() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t at = 0; at < coefficients_.size(); ++at) {
    const Interval control = coefficients_[at] / Interval(Monomials<m>::all().multiplicity[degree_][at]);
    if (!(control.lower() > -std::numeric_limits<double>::infinity())) return -std::numeric_limits<double>::infinity();
    least = std::min(least, control.lower());
  }
  return least;
}

template <int m>
BarycentricForm<m> product(const BarycentricForm<m>& a, const BarycentricForm<m>& b) {
  const Monomials<m>& monomials = Monomials<m>::all();
  BarycentricForm<m> result(a.degree_ + b.degree_);
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
    for (std::size_t k = 0; k < b.coefficients_.size(); ++k) {
      const std::size_t key = monomials.keys[a.degree_][i] + monomials.keys[b.degree_][k];
      result.coefficients_[monomials.place[key]] += a.coefficients_[i] * b.coefficients_[k];
    }
  }
  return result;
}

template <int m>
BarycentricForm<m> determinant(const FormMatrix<m>& a) {
  constexpr auto n = static_cast<std::size_t>(m);
  const auto minor = [&](std::size_t row, std::size_t first, std::size_t second) {
    BarycentricForm<m> result = product(a[row * n + first], a[(row + 1) * n + second]);
    result -= product(a[row * n + second], a[(row + 1) * n + first]);
    return result;
  };
  if constexpr (m == 2) {
    return minor(0, 0, 1);
  } else {
    BarycentricForm<m> result = product(a[0], minor(1, 1, 2));
    result -= product(a[1], minor(1, 0, 2));
    result += product(a[2], minor(1, 0, 1));
    return result;
  }
}

#define DELCERT_INSTANTIATE(m)                                                                  \
  template class BarycentricForm<m>;                                                            \
  template BarycentricForm<m> product<m>(const BarycentricForm<m>&, const BarycentricForm<m>&); \
  template BarycentricForm<m> determinant<m>(const FormMatrix<m>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
