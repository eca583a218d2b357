#include "proofs/checker/geometry/metric.hpp"

#include <flint/fmpq_mat.h>

#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

namespace {

/// A square matrix that is cleared also when what it is filled with is refused.
struct Square {
  explicit Square(int size) { fmpq_mat_init(value, size, size); }
  Square(const Square&) = delete;
  Square& operator=(const Square&) = delete;
  ~Square() { fmpq_mat_clear(value); }
  fmpq_mat_t value;
};

}  // namespace

Metric::Metric(int dimension, const std::vector<Rational>& gram) : dimension_(dimension) {
  const auto m = static_cast<std::size_t>(dimension);
  for (int size = 1; size <= dimension; ++size) {
    Square leading(size), inverse(size);
    for (int i = 0; i < size; ++i) {
      for (int k = 0; k < size; ++k) {
        const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(k);
        const Rational entry = gram.empty() ? Rational(i == k ? 1 : 0) : gram[row * m + column];
        if (!gram.empty()) {
          Report::require("form.gram", entry == gram[column * m + row], "gram is not symmetric");
        }
        fmpq_set(fmpq_mat_entry(leading.value, i, k), entry.raw());
        if (size == dimension && i <= k && entry.sign() != 0) entries_.push_back({row, column, Quantity(entry)});
      }
    }
    Rational minor;
    fmpq_mat_det(minor.raw(), leading.value);
    if (minor.sign() <= 0) throw Malformed("form.gram", "gram is not positive definite");
    if (size == dimension && fmpq_mat_inv(inverse.value, leading.value) != 0) {
      for (std::size_t k = 0; k < m; ++k) {
        Rational diagonal;
        fmpq_set(diagonal.raw(), fmpq_mat_entry(inverse.value, static_cast<slong>(k), static_cast<slong>(k)));
        stretch_[k] = upper_root(enclosure(diagonal));
      }
    }
  }
}

}  // namespace delcert::checker
