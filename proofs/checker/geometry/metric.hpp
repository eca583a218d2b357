#pragma once

#include <vector>

#include "proofs/checker/arithmetic/decide.hpp"
#include "proofs/checker/arithmetic/vector.hpp"

namespace delcert::checker {

/// The inner product <x, y> = x^T G y of the frame.
class Metric {
 public:
  Metric() = default;
  /// `gram` has m rows of m numbers, or is empty for the identity. Throws Malformed (form.gram) unless the matrix is
  /// symmetric and positive definite.
  Metric(int dimension, const std::vector<Rational>& gram);

  int dimension() const { return dimension_; }
  /// An upper bound of sqrt((G^-1)_kk): a vector of length a has |x_k| <= a stretch(k).
  double stretch(std::size_t k) const { return stretch_[k]; }

  /// G x.
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
  N product(const Vector<N>& x, const Vector<N>& y) const {
    return dot(x, covector(y), static_cast<std::size_t>(dimension_));
  }
  template <class N>
  N squared_length(const Vector<N>& x) const {
    N sum(0);
    for (const Entry& entry : entries_) {
      sum = sum +
            entry.value.template as<N>() * (entry.i == entry.k ? square(x[entry.i]) : N(2) * x[entry.i] * x[entry.k]);
    }
    return sum;
  }

 private:
  /// An entry G_ik = G_ki, i <= k, other than 0.
  struct Entry {
    std::size_t i, k;
    Quantity value;
  };
  int dimension_ = 0;
  std::vector<Entry> entries_;
  std::array<double, 4> stretch_{};
};

}  // namespace delcert::checker
