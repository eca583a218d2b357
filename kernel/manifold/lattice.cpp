#include "kernel/manifold/lattice.hpp"

#include <algorithm>
#include <utility>

#include "kernel/number/exact_text.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// The Gram–Schmidt coefficients of a basis and the squared lengths of its orthogonal parts, from its Gram matrix.
template <int m>
struct Orthogonalised {
  Matrix<Rational, m> coefficient{};
  Vector<Rational, m> squared{};

  explicit Orthogonalised(const Matrix<Rational, m>& gram) {
    Matrix<Rational, m> part{};
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column <= row; ++column) {
        part[row][column] = gram[row][column];
        for (std::size_t k = 0; k < column; ++k) part[row][column] -= coefficient[column][k] * part[row][k];
        if (column < row) coefficient[row][column] = part[row][column] / squared[column];
      }
      squared[row] = part[row][row];
    }
  }
};

/// Takes a multiple of one vector of the basis from another.
template <int m>
void subtract(Matrix<Rational, m>& gram, std::size_t from, const Rational& factor, std::size_t vector) {
  for (std::size_t k = 0; k < m; ++k) gram[from][k] -= factor * gram[vector][k];
  for (std::size_t k = 0; k < m; ++k) gram[k][from] -= factor * gram[k][vector];
}

template <int m>
void exchange(Matrix<Rational, m>& gram, std::size_t a, std::size_t b) {
  std::swap(gram[a], gram[b]);
  for (auto& row : gram) std::swap(row[a], row[b]);
}

}  // namespace

template <int m>
Matrix<Rational, m> reduced_gram(const FrameMetric<m>& metric) {
  const Rational half = Rational(1) / Rational(2);
  const Rational delta = Rational(99) / Rational(100);
  Matrix<Rational, m> gram = metric.gram();
  for (std::size_t at = 1; at < m;) {
    for (std::size_t before = at; before > 0; --before) {
      const Rational coefficient = Orthogonalised<m>(gram).coefficient[at][before - 1];
      if (absolute(coefficient) > half) subtract<m>(gram, at, Rational(floor_of(coefficient + half)), before - 1);
    }
    const Orthogonalised<m> parts(gram);
    if (parts.squared[at] >= (delta - square(parts.coefficient[at][at - 1])) * parts.squared[at - 1]) {
      ++at;
    } else {
      exchange<m>(gram, at, at - 1);
      if (at > 1) --at;
    }
  }
  return gram;
}

template <int m>
std::string gram_text(const Matrix<Rational, m>& gram) {
  std::string result = "gram = [";
  for (std::size_t row = 0; row < m; ++row) {
    result += row == 0 ? "[" : ", [";
    for (std::size_t column = 0; column < m; ++column)
      result += (column == 0 ? "\"" : ", \"") + exact_text(gram[row][column]) + "\"";
    result += "]";
  }
  return result + "]";
}

template <int m>
Rational squared_systole(const FrameMetric<m>& given) {
  const FrameMetric<m> metric(reduced_gram<m>(given));
  const auto exact = metric.template on<Rational>();
  Rational best = metric.gram()[0][0];
  for (std::size_t axis = 1; axis < m; ++axis) best = minimum(best, metric.gram()[axis][axis]);

  Shift<m> bound;
  for (std::size_t axis = 0; axis < m; ++axis) {
    bound[axis] =
        floor_of(square_root_upper(best * metric.inverse_diagonal(axis), 32)).template convert_to<std::int32_t>();
  }

  Shift<m> x;
  for (std::size_t axis = 0; axis < m; ++axis) x[axis] = -bound[axis];
  while (true) {
    if (std::any_of(x.begin(), x.end(), [](auto coordinate) { return coordinate != 0; })) {
      Vector<Rational, m> vector;
      for (std::size_t axis = 0; axis < m; ++axis) vector[axis] = Rational(x[axis]);
      best = minimum(best, exact.squared_norm(vector));
    }
    std::size_t axis = m;
    while (axis > 0 && ++x[axis - 1] > bound[axis - 1]) {
      x[axis - 1] = -bound[axis - 1];
      --axis;
    }
    if (axis == 0) return best;
  }
}

#define DELCERT_INSTANTIATE(m)                                         \
  template Rational squared_systole<m>(const FrameMetric<m>&);         \
  template Matrix<Rational, m> reduced_gram<m>(const FrameMetric<m>&); \
  template std::string gram_text<m>(const Matrix<Rational, m>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
