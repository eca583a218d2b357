#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/decide.hpp"
#include "proofs/checker/failure.hpp"

namespace delcert::checker {

template <class N>
using Vector = std::array<N, 4>;  // the first m entries count

/// The integer vector that is added to a point.
using Lift = std::array<std::int32_t, 4>;
std::string to_string(const Lift& lift, int dimension);

/// Calls f with every integer vector that has first[k] <= x[k] <= last[k], the other entries 0, until f returns true.
/// Throws Undecided if there are more than 10^7, or if an entry would have more than 30 binary digits.
template <class F>
void for_each_integer_vector(int dimension, const std::array<double, 4>& first, const std::array<double, 4>& last,
                             const F& f) {
  double number = 1;
  Lift x{};
  for (int k = 0; k < dimension; ++k) {
    const auto a = static_cast<std::size_t>(k);
    if (first[a] > last[a]) return;
    number *= last[a] - first[a] + 1;
    if (!(number <= 1e7 && first[a] > -0x1p30 && last[a] < 0x1p30))
      throw Undecided("too many lattice vectors to look at");
    x[a] = static_cast<std::int32_t>(first[a]);
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension);) {
    if (f(x)) return;
    for (k = 0; k < static_cast<std::size_t>(dimension) && x[k] == static_cast<std::int32_t>(last[k]); ++k) {
      x[k] = static_cast<std::int32_t>(first[k]);
    }
    if (k < static_cast<std::size_t>(dimension)) ++x[k], k = 0;
  }
}

/// The inner product <x, y> = x^T G y of the frame.
class Metric {
 public:
  /// `gram` has m rows of m numbers, or is empty for the identity. Throws Malformed (form.gram) unless the matrix is
  /// symmetric and positive definite.
  Metric(int dimension, const std::vector<std::string_view>& gram);

  int dimension() const { return dimension_; }
  /// An upper bound of sqrt((G^-1)_kk): a vector of length a has |x_k| <= a stretch(k).
  double stretch(std::size_t k) const { return stretch_[k]; }

  template <class N>
  N product(const Vector<N>& x, const Vector<N>& y) const {
    return sum<N>([&](std::size_t i, std::size_t k) { return i == k ? x[i] * y[i] : x[i] * y[k] + x[k] * y[i]; });
  }
  /// G x, so that <x, y> is the sum of the products of its entries with those of y.
  template <class N>
  Vector<N> covector(const Vector<N>& x) const {
    Vector<N> result{};
    for (const Entry& entry : entries_) {
      const N& value = entry.value.template as<N>();
      result[entry.i] = result[entry.i] + value * x[entry.k];
      if (entry.i != entry.k) result[entry.k] = result[entry.k] + value * x[entry.i];
    }
    return result;
  }
  template <class N>
  N squared_length(const Vector<N>& x) const {
    return sum<N>([&](std::size_t i, std::size_t k) { return i == k ? square(x[i]) : N(2) * x[i] * x[k]; });
  }

  /// A lattice vector other than 0 of length <= a (closed) or < a, if there is one. Precondition: a >= 0.
  std::optional<Lift> lattice_vector_within(const Quantity& a, bool closed) const;

 private:
  /// An entry G_ik = G_ki, i <= k, other than 0.
  struct Entry {
    std::size_t i, k;
    bool unit;
    Quantity value;
  };
  template <class N, class Term>
  N sum(const Term& term) const {
    N total(0);
    for (const Entry& entry : entries_) {
      total = total + (entry.unit ? term(entry.i, entry.k) : entry.value.template as<N>() * term(entry.i, entry.k));
    }
    return total;
  }

  int dimension_;
  std::vector<Entry> entries_;
  std::array<double, 4> stretch_{};
};

}  // namespace delcert::checker
