#include "proofs/certificate/placed_complex.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/element_words.hpp"

namespace delcert {

namespace {

[[noreturn]] void no_loop(std::size_t generator) {
  throw std::logic_error("no loop of the complex is generator " + std::to_string(generator + 1));
}

/// The simplices at their smallest label, as its chart sees them.
template <int m>
std::vector<LiftedSimplex<m>> seen_once(const ChartComplex<m>& complex) {
  std::vector<LiftedSimplex<m>> result;
  for (std::uint32_t index = 0; index < complex.size(); ++index) {
    for (const ChartSimplex<m>& others : complex.first_seen_from(Label(index))) {
      LiftedSimplex<m>& simplex = result.emplace_back();
      simplex[0] = {index, {}};
      std::copy(others.begin(), others.end(), simplex.begin() + 1);
    }
  }
  return result;
}

template <int m>
LiftedSimplex<m> by_labels(LiftedSimplex<m> simplex) {
  std::sort(simplex.begin(), simplex.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  return simplex;
}

/// Elements and simplices, where lifts differ by vectors of ℤᵐ.
template <int m>
PlacedComplex<m> placed_by_vectors(const std::vector<LiftedSimplex<m>>& simplices) {
  std::vector<Shift<m>> vectors;
  for (const auto& unsorted : simplices) {
    const LiftedSimplex<m> simplex = by_labels<m>(unsorted);
    for (const auto& vertex : simplex) {
      const Shift<m> vector = difference_of<m>(vertex.shift, simplex[0].shift);
      if (vector != Shift<m>{}) vectors.push_back(vector);
    }
  }
  std::sort(vectors.begin(), vectors.end());
  vectors.erase(std::unique(vectors.begin(), vectors.end()), vectors.end());
  PlacedComplex<m> result;
  for (const auto& vector : vectors) result.elements.emplace_back(vector.begin(), vector.end());
  for (const auto& unsorted : simplices) {
    const LiftedSimplex<m> simplex = by_labels<m>(unsorted);
    PlacedSimplex<m>& placed = result.simplices.emplace_back();
    for (std::size_t corner = 0; corner <= m; ++corner) {
      placed[corner] = simplex[corner].index;
      const Shift<m> vector = difference_of<m>(simplex[corner].shift, simplex[0].shift);
      if (corner == 0 || vector == Shift<m>{}) continue;
      const auto found = std::lower_bound(vectors.begin(), vectors.end(), vector);
      placed[m + corner] = static_cast<std::uint32_t>(found - vectors.begin()) + 1;
    }
  }
  std::sort(result.simplices.begin(), result.simplices.end());
  return result;
}

/// Translations of ℤᵐ, exact.
template <int m>
class Translations {
 public:
  using Motion = Shift<m>;

  Translations(const PlacedComplex<m>& complex, const FrameMetric<m>& metric, std::vector<Vector<double, m>> points)
      : complex_(complex), metric_(metric), points_(std::move(points)) {}

  [[nodiscard]] Motion identity() const { return {}; }
  [[nodiscard]] Motion of(std::uint32_t number) const {
    Motion result{};
    if (number > 0) std::copy_n(complex_.elements[number - 1].begin(), m, result.begin());
    return result;
  }
  [[nodiscard]] Motion inverse_of(std::uint32_t number) const { return difference_of<m>({}, of(number)); }
  [[nodiscard]] Motion product(const Motion& a, const Motion& b) const { return sum_of<m>(a, b); }
  [[nodiscard]] bool are_same(const Motion& a, const Motion& b) const { return a == b; }
  [[nodiscard]] double remaining(std::uint32_t label, const Motion& a, const Motion& target) const {
    Vector<double, m> step;
    for (std::size_t axis = 0; axis < m; ++axis)
      step[axis] = points_[label][axis] + a[axis] - points_[0][axis] - target[axis];
    const Vector<double, m> cartesian = metric_.approximate_cartesian(step);
    return std::inner_product(cartesian.begin(), cartesian.end(), cartesian.begin(), 0.0);
  }

 private:
  const PlacedComplex<m>& complex_;
  const FrameMetric<m>& metric_;
  std::vector<Vector<double, m>> points_;
};

/// Isometries of a model space in doubles: good enough to find a way, which is then tested exactly.
template <int m>
class Isometries {
 public:
  using Motion = ModelMatrix<double, m>;

  Isometries(const InvariantForm& form, const std::vector<FieldMatrix>& elements,
             const std::vector<Vector<Rational, m>>& points)
      : form_(form) {
    for (const FieldMatrix& element : elements) {
      matrices_.push_back(approximation(element));
      inverses_.push_back(approximation(form_.inverse_of(element)));
    }
    const double curvature = sign_of(form_.curvature());
    for (const Vector<Rational, m>& centre : points) {
      std::array<double, static_cast<std::size_t>(m)> a{};
      double squared = 0;
      for (std::size_t axis = 0; axis < m; ++axis) {
        a[axis] = approximate_double(centre[axis]);
        squared += a[axis] * a[axis];
      }
      const double deviation = curvature * squared / 4;
      auto& point = points_.emplace_back();
      point[0] = (1 - deviation) / (1 + deviation);
      for (std::size_t axis = 0; axis < m; ++axis) point[axis + 1] = a[axis] / (1 + deviation);
    }
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column)
        gram_[row][column] = form_.curvature() == Curvature::zero
                                 ? approximate_double(form_.gram()(row, column).rational())
                                 : (row == column ? 1.0 : 0.0);
    }
  }

  [[nodiscard]] Motion approximation(const FieldMatrix& matrix) const {
    const auto rows = form_.in_standard_basis(matrix);
    Motion result;
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column)
        result[row][column] = approximate_double(rows[row][column].lower());
    }
    return result;
  }

  [[nodiscard]] Motion identity() const { return matrices_[0]; }
  [[nodiscard]] const Motion& of(std::uint32_t number) const { return matrices_[number]; }
  [[nodiscard]] const Motion& inverse_of(std::uint32_t number) const { return inverses_[number]; }
  [[nodiscard]] Motion product(const Motion& a, const Motion& b) const {
    Motion result{};
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column) {
        for (std::size_t k = 0; k <= m; ++k) result[row][column] += a[row][k] * b[k][column];
      }
    }
    return result;
  }
  [[nodiscard]] bool are_same(const Motion& a, const Motion& b) const {
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column) {
        if (!(std::abs(a[row][column] - b[row][column]) < 1e-6 * (1 + std::abs(a[row][column])))) return false;
      }
    }
    return true;
  }
  /// −cos d, d², cosh d.
  [[nodiscard]] double remaining(std::uint32_t label, const Motion& a, const Motion& target) const {
    const auto x = moved(a, points_[label]);
    const auto y = moved(target, points_[0]);
    double spatial = 0;
    double squared = 0;
    for (std::size_t row = 0; row < m; ++row) {
      spatial += x[row + 1] * y[row + 1];
      for (std::size_t column = 0; column < m; ++column)
        squared += gram_[row][column] * (x[row + 1] - y[row + 1]) * (x[column + 1] - y[column + 1]);
    }
    if (form_.curvature() == Curvature::zero) return squared;
    return form_.curvature() == Curvature::positive ? -x[0] * y[0] - spatial : x[0] * y[0] - spatial;
  }

 private:
  using Place = std::array<double, static_cast<std::size_t>(m) + 1>;
  static Place moved(const Motion& a, const Place& x) {
    Place result{};
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t k = 0; k <= m; ++k) result[row] += a[row][k] * x[k];
    }
    return result;
  }

  const InvariantForm& form_;
  std::vector<Motion> matrices_, inverses_;
  std::vector<Place> points_;
  Matrix<double, m> gram_;
};

/// The element that a path is: the product of g_a⁻¹ g_b over its steps.
template <int m>
FieldMatrix product_along(const std::vector<LoopStep>& loop, const std::vector<PlacedSimplex<m>>& simplices,
                          const InvariantForm& form, const std::vector<FieldMatrix>& elements) {
  FieldMatrix result = elements.front();
  for (const LoopStep& step : loop) {
    const std::uint32_t from = element_at<m>(simplices[step.simplex], step.from);
    const std::uint32_t to = element_at<m>(simplices[step.simplex], step.to);
    if (from == to) continue;
    result = result * form.inverse_of(elements[from]) * elements[to];
  }
  return result;
}

}  // namespace

template <int m>
std::vector<std::optional<std::vector<LoopStep>>> loops_along(
    const InvariantForm& form, const std::vector<Vector<Rational, m>>& points, const std::vector<FieldMatrix>& elements,
    const std::vector<FieldMatrix>& letters, const std::vector<PlacedSimplex<m>>& simplices, std::size_t most_places) {
  const Isometries<m> motions(form, elements, points);
  LoopSearch<m, Isometries<m>> search(simplices, points.size(), motions);
  std::vector<std::optional<std::vector<LoopStep>>> result;
  for (const FieldMatrix& letter : letters) {
    auto loop = search.find(motions.approximation(letter), most_places);
    if (loop && !(product_along<m>(*loop, simplices, form, elements) == letter)) loop.reset();
    result.push_back(std::move(loop));
  }
  return result;
}

template <int m>
PlacedComplex<m> placed_complex(const FlatAtlas<m>& atlas, const PointSet<m>& points, const StarComplex<m>& complex) {
  PlacedComplex<m> result = placed_by_vectors<m>(complex.simplices());
  if (!atlas.space().is_torus()) return result;
  const Translations<m> motions(result, atlas.metric(), points.approximate_all());
  LoopSearch<m, Translations<m>> search(result.simplices, atlas.size(), motions);
  for (std::size_t axis = 0; axis < m; ++axis) {
    Shift<m> target{};
    target[axis] = 1;
    auto loop = search.find(target);
    if (!loop) no_loop(axis);
    result.loops.push_back(std::move(*loop));
  }
  return result;
}

template <int m>
PlacedComplex<m> placed_complex(const SpaceFormAtlas<m>& atlas, const ChartComplex<m>& complex) {
  const InvariantForm& form = atlas.form().form();
  ElementWords words(form, atlas.form().description.generators);
  std::vector<LiftedSimplex<m>> simplices = seen_once<m>(complex);
  for (auto& simplex : simplices) simplex = by_labels<m>(simplex);
  std::sort(simplices.begin(), simplices.end());
  PlacedComplex<m> result;
  result.simplices.reserve(simplices.size());
  // By the numbers in the atlas: those of words are found by comparing matrices.
  std::vector<std::optional<std::uint32_t>> numbers(atlas.elements().size());
  for (const auto& simplex : simplices) {
    PlacedSimplex<m>& placed = result.simplices.emplace_back();
    for (std::size_t corner = 0; corner <= m; ++corner) {
      placed[corner] = simplex[corner].index;
      if (corner == 0) continue;
      const std::uint32_t element = simplex[corner].element;
      if (!numbers[element]) numbers[element] = words.number_of(atlas.elements()[element]);
      placed[m + corner] = *numbers[element];
    }
  }
  for (const auto& word : words.words()) result.elements.emplace_back(word.begin(), word.end());
  if (words.letter_count() == 0) return result;
  std::vector<FieldMatrix> elements, letters;
  for (std::uint32_t number = 0; number <= words.words().size(); ++number) elements.push_back(words.matrix(number));
  for (std::size_t at = 1; at <= words.letter_count(); ++at)
    letters.push_back(words.letter(static_cast<std::int32_t>(at)));
  std::vector<Vector<Rational, m>> points;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) points.push_back(atlas.centre(Label(index)));
  for (auto& loop : loops_along<m>(form, points, elements, letters, result.simplices)) {
    if (!loop) no_loop(result.loops.size());
    result.loops.push_back(std::move(*loop));
  }
  return result;
}

template <int m>
PlacedComplex<m> placed_complex(const ChartComplex<m>& complex) {
  return placed_by_vectors<m>(seen_once<m>(complex));
}

#define DELCERT_INSTANTIATE(m) \
  template PlacedComplex<m> placed_complex<m>(const FlatAtlas<m>&, const PointSet<m>&, const StarComplex<m>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE
#define DELCERT_INSTANTIATE(m)                                                                        \
  template std::vector<std::optional<std::vector<LoopStep>>> loops_along<m>(                          \
      const InvariantForm&, const std::vector<Vector<Rational, m>>&, const std::vector<FieldMatrix>&, \
      const std::vector<FieldMatrix>&, const std::vector<PlacedSimplex<m>>&, std::size_t);            \
  template PlacedComplex<m> placed_complex<m>(const SpaceFormAtlas<m>&, const ChartComplex<m>&);      \
  template PlacedComplex<m> placed_complex<m>(const ChartComplex<m>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE
template PlacedComplex<1> placed_complex<1>(const ChartComplex<1>&);

}  // namespace delcert
