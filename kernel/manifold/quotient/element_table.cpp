#include "kernel/manifold/quotient/element_table.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "kernel/manifold/quotient/transition.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

constexpr unsigned stored_bits = 256;
/// Centres that are this close in one coordinate are compared.
constexpr double window = 0x1p-16;

template <int m>
ModelMatrix<BigInterval, m> in_big(const InvariantForm& form, const FieldMatrix& element) {
  const auto rows = form.in_standard_basis(element);
  ModelMatrix<BigInterval, m> result;
  for (std::size_t row = 0; row <= m; ++row) {
    for (std::size_t column = 0; column <= m; ++column) result[row][column] = rows[row][column];
  }
  return result;
}

template <int m>
MetricOn<Interval, m> metric_in_intervals(const InvariantForm& form) {
  const RoundingGuard guard;
  return chart_metric<m>(form).template on<Interval>();
}

/// Of the chord that belongs to this distance, which is at most π on the sphere.
Interval squared_chord_of(Curvature curvature, const Rational& distance) {
  const RoundingGuard guard;
  const Interval squared = square(scalar_from<Interval>(distance));
  return squared * square(sine_ratio(curvature, squared / Interval(4)));
}

}  // namespace

template <int m>
FrameMetric<m> chart_metric(const InvariantForm& form) {
  if (form.curvature() != Curvature::zero) return FrameMetric<m>::cartesian();
  Matrix<Rational, m> gram;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) gram[row][column] = form.gram()(row, column).rational();
  }
  return FrameMetric<m>(gram);
}

template <int m>
ElementTable<m>::ElementTable(const InvariantForm& form, std::vector<FieldMatrix> elements,
                              const Rational& least_displacement)
    : form_(form),
      metric_(metric_in_intervals<m>(form)),
      least_squared_chord_(squared_chord_of(form.curvature(), least_displacement)),
      elements_(std::move(elements)) {
  const FieldMatrix identity = FieldMatrix::identity(m + 1);
  std::sort(elements_.begin(), elements_.end(), [&identity](const FieldMatrix& a, const FieldMatrix& b) {
    if (a == identity || b == identity) return a == identity && !(b == identity);
    return Precedes{}(a, b);
  });
  elements_.erase(std::unique(elements_.begin(), elements_.end()), elements_.end());
  if (elements_.empty() || !(elements_.front() == identity)) elements_.insert(elements_.begin(), identity);
  {
    const BigInterval::Precision precision(PrecisionBits{stored_bits});
    for (const FieldMatrix& element : elements_) precise_.push_back(in_big<m>(form_, element));
  }
  for (const auto& precise : precise_) matrices_.push_back(in_doubles<m>(precise));
  for (std::uint32_t number = 0; number < size(); ++number) {
    by_coordinate_.emplace_back(matrices_[number][1][0].lower(), number);
  }
  std::sort(by_coordinate_.begin(), by_coordinate_.end());
  const RoundingGuard guard;
  for (const FieldMatrix& element : elements_) {
    const auto inverse = in_doubles<m>(in_big<m>(form_, form_.inverse_of(element)));
    ModelPoint<Interval, m> centre;
    for (std::size_t row = 0; row <= m; ++row) centre[row] = inverse[row][0];
    inverses_.push_back(with_centre(centre));
  }
}

template <int m>
ModelMatrix<BigInterval, m> ElementTable<m>::big_matrix(std::uint32_t number) const {
  if (BigInterval::working_precision().value <= stored_bits) return precise_[number];
  return in_big<m>(form_, elements_[number]);
}

template <int m>
ModelPoint<Interval, m> ElementTable<m>::centre(std::uint32_t number) const {
  ModelPoint<Interval, m> result;
  for (std::size_t row = 0; row <= m; ++row) result[row] = matrices_[number][row][0];
  return result;
}

template <int m>
std::uint32_t ElementTable<m>::number_of(const FieldMatrix& element) const {
  if (is_identity(element)) return 0;
  const auto found = std::lower_bound(elements_.begin() + 1, elements_.end(), element, Precedes{});
  if (found == elements_.end() || !(*found == element))
    throw std::out_of_range("the group element is not one of those that sightings name");
  return static_cast<std::uint32_t>(found - elements_.begin());
}

template <int m>
std::optional<std::uint32_t> ElementTable<m>::with_centre(const ModelPoint<Interval, m>& centre) const {
  const auto first = std::lower_bound(by_coordinate_.begin(), by_coordinate_.end(),
                                      std::pair(centre[1].lower() - window, std::uint32_t{0}));
  for (auto at = first; at != by_coordinate_.end() && at->first <= centre[1].upper() + window; ++at) {
    const Interval chord = squared_chord<Interval, m>(form_.curvature(), metric_, centre, this->centre(at->second));
    if (is_proved(less(chord, least_squared_chord_))) return at->second;
  }
  return std::nullopt;
}

template <int m>
std::uint32_t ElementTable<m>::product(std::uint32_t a, std::uint32_t b) const {
  if (a == 0 || b == 0) return a == 0 ? b : a;
  const RoundingGuard guard;
  const auto found = with_centre(applied(matrices_[a], centre(b)));
  if (!found) throw std::out_of_range("the product of group elements is not one of those that sightings name");
  return *found;
}

template <int m>
std::uint32_t ElementTable<m>::inverse(std::uint32_t a) const {
  if (!inverses_[a]) throw std::out_of_range("the inverse of a group element is not one of those that sightings name");
  return *inverses_[a];
}

template class ElementTable<2>;
template class ElementTable<3>;
template FrameMetric<2> chart_metric<2>(const InvariantForm&);
template FrameMetric<3> chart_metric<3>(const InvariantForm&);

}  // namespace delcert
