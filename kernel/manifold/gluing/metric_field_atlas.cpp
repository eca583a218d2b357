#include "kernel/manifold/gluing/metric_field_atlas.hpp"

#include <algorithm>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The half-widths of cells over √(B⁻¹)_kk·ε: most queries ask for two or three sampling radii.
constexpr double cell_factor = 1.5;

template <class S, std::size_t m>
std::array<S, m> vector_on(const std::array<Rational, m>& x) {
  std::array<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(x[axis]);
  return result;
}

}  // namespace

template <int m>
MetricFieldAtlas<m>::MetricFieldAtlas(MetricField<m> field, std::vector<Vector<Rational, m>> centres,
                                      Rational sampling_radius)
    : field_(std::move(field)),
      centres_(std::move(centres)),
      net_(std::vector<Vector<Rational, m>>(centres_.size())),
      sampling_radius_(std::move(sampling_radius)),
      cells_([] {
        Vector<double, m> whole;
        whole.fill(1);
        return whole;
      }()) {
  require_points();
  make_charts();
  choose_patches();
  fill_cells();
}

template <int m>
void MetricFieldAtlas<m>::require_points() const {
  if (sampling_radius_ <= Rational(0)) throw InputError("the sampling radius is above 0");
  if (centres_.size() == 0) throw InputError("a net has at least one point");
  for (std::uint32_t index = 0; index < centres_.size(); ++index) {
    for (const Rational& coordinate : centres_.exact(Label(index))) {
      if (coordinate < Rational(0) || coordinate >= Rational(1))
        throw InputError("label " + std::to_string(index) + " has the coordinate " + exact_text(coordinate) +
                         ": points of the torus have coordinates in [0, 1)");
    }
  }
}

template <int m>
void MetricFieldAtlas<m>::make_charts() {
  for (std::uint32_t index = 0; index < centres_.size(); ++index) {
    const Matrix<Interval, m> gram = [&] {
      const RoundingGuard guard;
      return field_.template at<Interval>(centre(Label(index)));
    }();
    charts_.push_back(rounded_chart<m>(gram));
    const AffineChart<m>& chart = charts_.back();
    const RoundingGuard guard;
    Enclosed enclosed{matrix_on<Interval>(chart.matrix()),
                      matrix_on<Interval>(chart.inverse()),
                      matrix_on<Interval>(chart.gram()),
                      {}};
    for (std::size_t axis = 0; axis < m; ++axis)
      enclosed.stretch[axis] = square_root(scalar_from<Interval>(chart.squared_stretch(axis))).upper();
    enclosed_.push_back(enclosed);
  }
}

template <int m>
void MetricFieldAtlas<m>::choose_patches() {
  const RoundingGuard guard;
  double widest = 0;
  std::uint32_t where = 0;
  for (std::uint32_t index = 0; index < size(); ++index) {
    for (const double stretch : enclosed_[index].stretch) {
      if (stretch > widest) where = index;
      widest = std::max(widest, stretch);
    }
  }
  const Interval unit = Interval(3) * scalar_from<Interval>(sampling_radius_) * Interval::exactly(widest);
  while (!is_proved(less(Interval(patch_factor_) * unit, Interval(1)))) {
    if (--patch_factor_ < least_patch_factor)
      throw Rejection(field_.description().name + ": the sampling radius " + exact_text(sampling_radius_) +
                      " is too large for patches: 12 of it times " + std::to_string(widest) + ", at label " +
                      std::to_string(where) + ", is not below 1: take a sampling radius of at most " +
                      exact_text(fitting_sampling_radius(field_.eigenvalue_bounds())));
  }
}

template <int m>
void MetricFieldAtlas<m>::fill_cells() {
  Vector<double, m> widths{};
  for (const Enclosed& enclosed : enclosed_) widths = sum(widths, enclosed.stretch);
  const double factor = cell_factor * approximate_double(sampling_radius_) / static_cast<double>(size());
  cells_ = TorusCells<m>(scaled(factor, widths));
  for (std::uint32_t index = 0; index < size(); ++index) cells_.insert(index, centres_.approximate(Label(index)));
}

template <int m>
std::vector<Sighting<m>> MetricFieldAtlas<m>::neighbours(Label i) const {
  std::vector<Sighting<m>> result;
  sightings(i, approximate_double(patch_radius()) * (1 + 0x1p-50), result);
  return result;
}

template <int m>
void MetricFieldAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  out.clear();
  const Enclosed& at = enclosed_[i.value];
  Vector<double, m> half_widths = scaled(distance, at.stretch);
  const RoundingGuard guard;
  const Vector<Filter, m>& centre = centres_.enclosure(i);
  const double most = distance * distance;  // rounded upwards
  cells_.visit(centres_.approximate(i), half_widths, [&](const Lift<m>& lift) {
    const Vector<Filter, m>& other = centres_.enclosure(Label(lift.index));
    Vector<Interval, m> offset;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Filter along = other[axis] - centre[axis] + Filter(lift.shift[axis]);
      offset[axis] = Interval::between(along.lower(), along.upper());
    }
    const Vector<Interval, m> seen = applied_triangle(at.matrix, offset);
    Interval squared = square(seen[0]);
    for (std::size_t axis = 1; axis < m; ++axis) squared += square(seen[axis]);
    if (squared.lower() <= most) out.push_back(lift);
    return false;
  });
  std::sort(out.begin(), out.end());
}

template <int m>
template <class S>
Vector<S, m> MetricFieldAtlas<m>::carried(Label i, const Sighting<m>& seen, const Vector<S, m>& home,
                                          const Matrix<S, m>& matrix, const Matrix<S, m>& inverse) const {
  const Vector<S, m> moved = applied_triangle(inverse, home);
  const Vector<S, m> from = centres_.template coordinates<S>(i);
  const Vector<S, m> to = centres_.template coordinates<S>(label_of<m>(seen));
  Vector<S, m> offset;
  for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = to[axis] - from[axis] + S(seen.shift[axis]) + moved[axis];
  return applied_triangle(matrix, offset);
}

template <int m>
Vector<Filter, m> MetricFieldAtlas<m>::carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const {
  if (seen.index == i.value && seen.shift == Shift<m>{}) return home;
  if constexpr (filter_is_rigorous) {
    return carried<Filter>(i, seen, home, enclosed_[i.value].matrix, enclosed_[seen.index].inverse);
  } else {
    return carried<Filter>(i, seen, home, matrix_on<Filter>(chart(i).matrix()),
                           matrix_on<Filter>(charts_[seen.index].inverse()));
  }
}

template <int m>
Vector<BigInterval, m> MetricFieldAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                  const Vector<BigInterval, m>& home) const {
  return carried<BigInterval>(i, seen, home, matrix_on<BigInterval>(chart(i).matrix()),
                              matrix_on<BigInterval>(charts_[seen.index].inverse()));
}

template <int m>
std::optional<Vector<Rational, m>> MetricFieldAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                              const Vector<Rational, m>& home) const {
  return carried<Rational>(i, seen, home, chart(i).matrix(), charts_[seen.index].inverse());
}

template class MetricFieldAtlas<2>;
template class MetricFieldAtlas<3>;

}  // namespace delcert
