#include "kernel/manifold/gluing/metric_field_atlas.hpp"

#include <algorithm>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The half-widths of cells over √(B⁻¹)_kk·ε: most queries ask for two or three sampling radii.
constexpr double cell_factor = 1.5;

}  // namespace

template <int m>
MetricFieldAtlas<m>::MetricFieldAtlas(MetricField<m> field, std::vector<Vector<Rational, m>> centres,
                                      Rational sampling_radius)
    : AffineAtlas<m>(std::move(centres), std::move(sampling_radius)), field_(std::move(field)), cells_([] {
        Vector<double, m> whole;
        whole.fill(1);
        return whole;
      }()) {
  require_points();
  this->make_charts([&](Label i) {
    const RoundingGuard guard;
    return field_.template at<Interval>(this->centre(i));
  });
  choose_patches();
  fill_cells();
}

template <int m>
void MetricFieldAtlas<m>::require_points() const {
  for (std::uint32_t index = 0; index < this->size(); ++index) {
    for (const Rational& coordinate : this->centre(Label(index))) {
      if (coordinate < Rational(0) || coordinate >= Rational(1))
        throw InputError("label " + std::to_string(index) + " has the coordinate " + exact_text(coordinate) +
                         ": points of the torus have coordinates in [0, 1)");
    }
  }
}

template <int m>
void MetricFieldAtlas<m>::choose_patches() {
  Label where{0};
  const bool fits = [&] {
    const RoundingGuard guard;
    const double room = (Interval(1) / Interval(3)).lower();
    return this->fit_patch_factor([room](Label, std::size_t) { return room; }, where);
  }();
  if (fits) return;
  throw Rejection(field_.description().name + ": the sampling radius " + exact_text(this->sampling_radius()) +
                  " is too large for patches: 12 of it, at label " + std::to_string(where.value) +
                  ", are more than a chart has room for: take a sampling radius of at most " +
                  exact_text(fitting_sampling_radius(field_.eigenvalue_bounds())));
}

template <int m>
void MetricFieldAtlas<m>::fill_cells() {
  Vector<double, m> widths{};
  for (std::uint32_t index = 0; index < this->size(); ++index)
    widths = sum(widths, this->enclosed(Label(index)).stretch);
  const double factor = cell_factor * approximate_double(this->sampling_radius()) / static_cast<double>(this->size());
  cells_ = TorusCells<m>(scaled(factor, widths));
  for (std::uint32_t index = 0; index < this->size(); ++index)
    cells_.insert(index, this->centres().approximate(Label(index)));
}

template <int m>
void MetricFieldAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  out.clear();
  const Vector<double, m> half_widths = scaled(distance, this->enclosed(i).stretch);
  const RoundingGuard guard;
  const PointSet<m>& centres = this->centres();
  const Vector<Filter, m>& centre = centres.enclosure(i);
  const double most = distance * distance;  // rounded upwards
  cells_.visit(centres.approximate(i), half_widths, [&](const Lift<m>& lift) {
    const Vector<Filter, m>& other = centres.enclosure(Label(lift.index));
    Vector<Interval, m> offset;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Filter along = other[axis] - centre[axis] + Filter(lift.shift[axis]);
      offset[axis] = Interval::between(along.lower(), along.upper());
    }
    if (this->may_be_within(i, offset, most)) out.push_back(lift);
    return false;
  });
  std::sort(out.begin(), out.end());
}

template <int m>
template <class S>
Vector<S, m> MetricFieldAtlas<m>::offset_on(Label i, const Sighting<m>& seen, const Vector<S, m>& moved) const {
  const Vector<S, m> from = this->centres().template coordinates<S>(i);
  const Vector<S, m> to = this->centres().template coordinates<S>(label_of<m>(seen));
  Vector<S, m> offset;
  for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = to[axis] - from[axis] + S(seen.shift[axis]) + moved[axis];
  return offset;
}

template <int m>
Vector<Filter, m> MetricFieldAtlas<m>::offset(Label i, const Sighting<m>& seen, const Vector<Filter, m>& moved) const {
  return offset_on<Filter>(i, seen, moved);
}
template <int m>
Vector<BigInterval, m> MetricFieldAtlas<m>::offset(Label i, const Sighting<m>& seen,
                                                   const Vector<BigInterval, m>& moved) const {
  return offset_on<BigInterval>(i, seen, moved);
}
template <int m>
Vector<Rational, m> MetricFieldAtlas<m>::offset(Label i, const Sighting<m>& seen,
                                                const Vector<Rational, m>& moved) const {
  return offset_on<Rational>(i, seen, moved);
}

template class MetricFieldAtlas<2>;
template class MetricFieldAtlas<3>;

}  // namespace delcert
