#include "kernel/manifold/gluing/affine_atlas.hpp"

#include <algorithm>
#include <limits>

#include "support/error.hpp"

namespace delcert {

template <int m>
AffineAtlas<m>::AffineAtlas(std::vector<Vector<Rational, m>> centres, Rational sampling_radius)
    : centres_(std::move(centres)),
      net_(std::vector<Vector<Rational, m>>(centres_.size())),
      sampling_radius_(std::move(sampling_radius)) {
  if (sampling_radius_ <= Rational(0)) throw InputError("the sampling radius is above 0");
  if (centres_.size() == 0) throw InputError("a net has at least one point");
}

template <int m>
void AffineAtlas<m>::make_charts(const std::function<Matrix<Interval, m>(Label)>& gram_at) {
  for (std::uint32_t index = 0; index < size(); ++index) {
    charts_.push_back(rounded_chart<m>(gram_at(Label(index))));
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
bool AffineAtlas<m>::fit_patch_factor(const std::function<double(Label, std::size_t)>& room, Label& where) {
  double widest = 0;
  for (std::uint32_t index = 0; index < size(); ++index) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Interval stretch = Interval::exactly(enclosed_[index].stretch[axis]);
      const double wide = (stretch / Interval::exactly(room(Label(index), axis))).upper();
      if (wide > widest) where = Label(index);
      widest = std::max(widest, wide);
    }
  }
  if (widest == std::numeric_limits<double>::infinity()) return false;
  const Interval unit = scalar_from<Interval>(sampling_radius_) * Interval::exactly(widest);
  while (!is_proved(less(Interval(patch_factor_) * unit, Interval(1)))) {
    if (--patch_factor_ < least_patch_factor) return false;
  }
  widest_patch_factor_ = patch_factor_;
  return true;
}

template <int m>
std::vector<Sighting<m>> AffineAtlas<m>::neighbours(Label i) const {
  std::vector<Sighting<m>> result;
  this->sightings(i, approximate_double(patch_radius()) * (1 + 0x1p-50), result);
  return result;
}

template <int m>
Vector<Filter, m> AffineAtlas<m>::carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const {
  if (seen.index == i.value && seen.is_unmoved()) return home;
  return upper_applied(enclosed(i).matrix, offset(i, seen, upper_applied(enclosed_[seen.index].inverse, home)));
}

template <int m>
Vector<BigInterval, m> AffineAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const {
  const auto inverse = matrix_on<BigInterval>(charts_[seen.index].inverse());
  return upper_applied(matrix_on<BigInterval>(chart(i).matrix()), offset(i, seen, upper_applied(inverse, home)));
}

template <int m>
std::optional<Vector<Rational, m>> AffineAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const {
  return upper_applied(chart(i).matrix(), offset(i, seen, upper_applied(charts_[seen.index].inverse(), home)));
}

template class AffineAtlas<2>;
template class AffineAtlas<3>;

}  // namespace delcert
