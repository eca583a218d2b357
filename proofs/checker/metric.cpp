#include "proofs/checker/metric.hpp"

#include "proofs/checker/exact_number.hpp"
#include "proofs/checker/report.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {

std::string to_string(const Lift& lift, int dimension) {
  std::string text;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    text += (k == 0 ? "(" : ", ") + std::to_string(lift[k]);
  }
  return text + ")";
}

Metric::Metric(int dimension, const std::vector<std::string_view>& gram) : dimension_(dimension) {
  const auto m = static_cast<std::size_t>(dimension);
  Matrix<Rational> matrix{};
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      matrix[i][k] = gram.empty() ? Rational(i == k) : exact_value(gram[i * m + k]);
      if (i > k) {
        const bool equal = fmpq_equal(matrix[i][k].raw(), matrix[k][i].raw()) != 0;
        Report::require("form.gram", equal, "gram is not symmetric");
      }
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = i; k < m; ++k) {
      if (matrix[i][k].sign() == 0) continue;
      const bool unit =
          less(matrix[i][k], Rational(1)) == Verdict::refuted && less(Rational(1), matrix[i][k]) == Verdict::refuted;
      entries_.push_back({i, k, unit, Quantity(matrix[i][k])});
    }
  }
  if (invert(matrix, dimension) != Verdict::proved) throw Malformed("form.gram", "gram is not positive definite");
  for (std::size_t k = 0; k < m; ++k) stretch_[k] = upper_root(enclosure(matrix[k][k]));
}

std::optional<Lift> Metric::lattice_vector_within(const Quantity& a, bool closed) const {
  std::array<double, 4> first{}, last{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    last[k] = std::floor(a.filter.upper() * stretch_[k]);
    first[k] = -last[k];
  }
  std::optional<Lift> found;
  for_each_integer_vector(dimension_, first, last, [&](const Lift& lift) {
    const auto within = [&]<class N>(In<N>) {
      Vector<N> x{};
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = N(lift[k]);
      const N length = squared_length(x), bound = square(a.as<N>());
      return closed ? less_equal(length, bound) : less(length, bound);
    };
    if (lift != Lift{} && decide(within)) found = lift;
    return found.has_value();
  });
  return found;
}

}  // namespace delcert::checker
