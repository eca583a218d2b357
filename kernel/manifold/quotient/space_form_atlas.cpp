#include "kernel/manifold/quotient/space_form_atlas.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>
#include <string>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/quotient/transition.hpp"

namespace delcert {

namespace {

/// How much farther than the radius of a patch the grid is complete, for the widening of queries.
constexpr double reach_slack = 0x1p-20;
/// Cells of this many sampling radii: most queries ask for two or three.
constexpr double cell_factor = 2;

/// Lists have the lifts within so many sampling radii: what perturbation and stars of usual nets ask for.
constexpr double listed_radii = 4.5 * (1 + 0x1p-20);
/// Of entries, in all: a gigabyte.
constexpr std::size_t most_listed = std::size_t{1} << 28U;

/// Another one for each atlas.
std::uint64_t next_number() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

template <class To, class From, std::size_t n>
std::array<To, n> converted(const std::array<From, n>& x) {
  std::array<To, n> result;
  for (std::size_t axis = 0; axis < n; ++axis) result[axis] = To::between(x[axis].lower(), x[axis].upper());
  return result;
}

template <int m>
std::vector<Frame<Interval, m>> frames_of(Curvature curvature, const PointSet<m>& centres) {
  const RoundingGuard guard;
  std::vector<Frame<Interval, m>> result;
  result.reserve(centres.size());
  for (std::uint32_t index = 0; index < centres.size(); ++index) {
    const Label label(index);
    if (curvature == Curvature::negative && detail::sum_of_squares(centres.exact(label)) >= Rational(4))
      throw InputError("label " + std::to_string(index) +
                       ": the conformal coordinates of a point of hyperbolic space are less than 2 from 0");
    result.emplace_back(curvature, centres.template coordinates<Interval>(label));
  }
  return result;
}

template <int m>
GroupLifts<m> lifts_of(const SpaceForm& form, const std::vector<Frame<Interval, m>>& frames, double reach) {
  std::vector<ModelPoint<Interval, m>> points;
  points.reserve(frames.size());
  for (const auto& frame : frames) points.push_back(frame.point());
  const LiftBounds bounds = [&] {
    const RoundingGuard guard;
    return lift_bounds<m>(form, points);
  }();
  return GroupLifts<m>(form, bounds, reach);
}

template <int m>
LiftGrid<m> empty_grid(const SpaceForm& form, const Rational& sampling_radius) {
  const RoundingGuard guard;
  return LiftGrid<m>(form.form().curvature(), chart_metric<m>(form.form()),
                     cell_factor * approximate_double(sampling_radius));
}

}  // namespace

template <int m>
SpaceFormAtlas<m>::SpaceFormAtlas(SpaceForm form, std::vector<Vector<Rational, m>> centres, Rational sampling_radius,
                                  int factor)
    : form_((require_small_patches(form, m, sampling_radius, factor), std::move(form))),
      metric_(chart_metric<m>(form_.form())),
      centres_(std::move(centres)),
      sampling_radius_(std::move(sampling_radius)),
      patch_radius_(Rational(factor) * sampling_radius_),
      frames_(frames_of<m>(curvature(), centres_)),
      lifts_(lifts_of<m>(form_, frames_, greatest_distance() * (1 + reach_slack))),
      grid_(empty_grid<m>(form_, sampling_radius_)),
      net_(std::vector<Vector<Rational, m>>(centres_.size())),
      number_(next_number()),
      listed_distance_([this] {
        const RoundingGuard guard;
        return grid_.measured(std::min(greatest_distance(), listed_radii * approximate_double(sampling_radius_)));
      }()),
      near_(std::make_unique<NearLists<NearNumbers>>(centres_.size(), most_listed)) {
  fill_grid();
}

template <int m>
double SpaceFormAtlas<m>::greatest_distance() const {
  return approximate_double(patch_radius_) * (1 + reach_slack);
}

template <int m>
void SpaceFormAtlas<m>::fill_grid() {
  const auto& table = lifts_.table();
  grid_.reserve(size());
  for (std::uint32_t label = 0; label < size(); ++label) {
    const RoundingGuard guard;
    first_lift_frame_.push_back(lift_frames_.size());
    grid_.insert({label, {}}, frames_[label].point());
    lifts_.for_each_lift(frames_[label].point(), [&](std::uint32_t number, const ModelPoint<Interval, m>& x) {
      grid_.insert({label, {}, number}, x);
      if (curvature() != Curvature::negative) return;
      const auto frame =
          model_frame<BigInterval, m>(curvature(), centres_.template coordinates<BigInterval>(Label(label)));
      lift_frames_.push_back({number, in_doubles<m>(delcert::product(table.big_matrix(number), frame))});
    });
  }
  first_lift_frame_.push_back(lift_frames_.size());
}

template <int m>
const ModelMatrix<Interval, m>* SpaceFormAtlas<m>::lift_frame(std::uint32_t label, std::uint32_t number) const {
  const auto first = lift_frames_.begin() + static_cast<std::ptrdiff_t>(first_lift_frame_[label]);
  const auto last = lift_frames_.begin() + static_cast<std::ptrdiff_t>(first_lift_frame_[label + 1]);
  const auto found = std::lower_bound(first, last, number,
                                      [](const LiftFrame& frame, std::uint32_t other) { return frame.number < other; });
  return found == last || found->number != number ? nullptr : &found->matrix;
}

/// What was computed last of some labels: charts that are looked at one after the other show much the same points.
template <int m>
struct SpaceFormAtlas<m>::Moved {
  std::uint64_t atlas = 0;
  std::uint32_t label = 0;
  Vector<Interval, m> home{};
  ModelPoint<Interval, m> about_origin{};  // exp_o(home)
  ModelPoint<Interval, m> in_place{};      // F_j of that

  static constexpr std::size_t kept = 1U << 12U;
};

template <int m>
const typename SpaceFormAtlas<m>::Moved& SpaceFormAtlas<m>::moved(std::uint32_t label,
                                                                  const Vector<Interval, m>& home) const {
  thread_local std::vector<Moved> memory(Moved::kept);
  Moved& result = memory[label % Moved::kept];
  // The same bits, so the same enclosures as computed anew.
  if (result.atlas != number_ || result.label != label || std::memcmp(&result.home, &home, sizeof(home)) != 0) {
    result.about_origin = exponential<Interval, m>(curvature(), home);
    result.in_place = frames_[label].applied(result.about_origin);
    result.home = home;
    result.label = label;
    result.atlas = number_;
  }
  return result;
}

template <int m>
ModelPoint<Interval, m> SpaceFormAtlas<m>::enclosed_lift(const Sighting<m>& seen,
                                                         const Vector<Interval, m>& home) const {
  const std::uint32_t number = seen.element;
  const Moved& x = moved(seen.index, home);
  if (number == 0) return x.in_place;
  if (const auto* frame = lift_frame(seen.index, number)) return applied(*frame, x.about_origin);
  return applied(lifts_.table().matrix(number), x.in_place);
}

template <int m>
Vector<Interval, m> SpaceFormAtlas<m>::enclosed_in_chart(Label i, const ModelPoint<Interval, m>& x) const {
  const Frame<Interval, m>& frame = frames_[i.value];
  if (curvature() == Curvature::zero)
    return detail::spatial_part<Interval, static_cast<std::size_t>(m)>(frame.inverse_applied(x));
  return logarithm_of_conformal<Interval, m>(curvature(), frame.conformal_seen(x));
}

template <int m>
template <class S>
ModelPoint<S, m> SpaceFormAtlas<m>::lift(const Sighting<m>& seen, const Vector<S, m>& home) const {
  if constexpr (std::same_as<S, Filter>) {
    return converted<Filter>(enclosed_lift(seen, converted<Interval>(home)));
  } else {
    const auto x = exponential<S, m>(curvature(), home);
    const auto moved = Frame<S, m>(curvature(), centres_.template coordinates<S>(label_of<m>(seen))).applied(x);
    const std::uint32_t number = seen.element;
    return number == 0 ? moved : applied(lifts_.table().big_matrix(number), moved);
  }
}

template <int m>
template <class S>
Vector<S, m> SpaceFormAtlas<m>::in_chart(Label i, const ModelPoint<S, m>& x) const {
  if constexpr (std::same_as<S, Filter>) {
    return converted<Filter>(enclosed_in_chart(i, converted<Interval>(x)));
  } else {
    const Frame<S, m> frame(curvature(), centres_.template coordinates<S>(i));
    return logarithm_of_conformal<S, m>(curvature(), frame.conformal_seen(x));
  }
}

template <int m>
std::vector<Sighting<m>> SpaceFormAtlas<m>::neighbours(Label i) const {
  std::vector<Sighting<m>> result;
  sightings(i, approximate_double(patch_radius_) * (1 + 0x1p-50), result);
  return result;
}

template <int m>
void SpaceFormAtlas<m>::find_near(const ModelPoint<Interval, m>& x, double distance,
                                  std::vector<Sighting<m>>& out) const {
  if (!(distance <= greatest_distance()))
    throw std::out_of_range("sightings are asked for farther than patches are wide");
  const RoundingGuard guard;
  out.clear();
  grid_.near(x, distance, out);
  std::sort(out.begin(), out.end());
}

template <int m>
const typename SpaceFormAtlas<m>::NearNumbers* SpaceFormAtlas<m>::listed_about(Label i) const {
  return near_->of(i.value, [&] {
    const RoundingGuard guard;
    return grid_.list_near(frames_[i.value].point(), listed_distance_);
  });
}

template <int m>
void SpaceFormAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  const NearNumbers* list = distance <= listed_distance_.length ? listed_about(i) : nullptr;
  if (list == nullptr) {
    find_near(frames_[i.value].point(), distance, out);
    return;
  }
  const RoundingGuard guard;
  out.clear();
  grid_.near_in_list(frames_[i.value].point(), listed_distance_, *list, distance, out);
}

template <int m>
void SpaceFormAtlas<m>::sightings_near(const ModelPoint<Filter, m>& x, double distance,
                                       std::vector<Sighting<m>>& out) const {
  find_near(converted<Interval>(x), distance, out);
}

template <int m>
Vector<Filter, m> SpaceFormAtlas<m>::carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const {
  return in_chart<Filter>(i, lift<Filter>(seen, home));
}

template <int m>
Vector<BigInterval, m> SpaceFormAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                const Vector<BigInterval, m>& home) const {
  return in_chart<BigInterval>(i, lift<BigInterval>(seen, home));
}

template <int m>
Vector<Rational, m> SpaceFormAtlas<m>::exactly_carried(Label i, const Sighting<m>& seen,
                                                       const Vector<Rational, m>& home) const {
  const FieldMatrix& element = elements()[seen.element];
  const auto x = sum(centre(label_of<m>(seen)), home);
  const auto centre_here = centre(i);
  Vector<Rational, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    result[row] = element(row + 1, 0).rational() - centre_here[row];
    for (std::size_t column = 0; column < m; ++column)
      result[row] += element(row + 1, column + 1).rational() * x[column];
  }
  return result;
}

template <int m>
std::optional<Vector<Rational, m>> SpaceFormAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                            const Vector<Rational, m>& home) const {
  if (!has_exact_transitions()) return std::nullopt;
  return exactly_carried(i, seen, home);
}

#define DELCERT_INSTANTIATE(m)                                                                                   \
  template class SpaceFormAtlas<m>;                                                                              \
  template ModelPoint<Filter, m> SpaceFormAtlas<m>::lift(const Sighting<m>&, const Vector<Filter, m>&) const;    \
  template ModelPoint<BigInterval, m> SpaceFormAtlas<m>::lift(const Sighting<m>&, const Vector<BigInterval, m>&) \
      const;                                                                                                     \
  template Vector<Filter, m> SpaceFormAtlas<m>::in_chart(Label, const ModelPoint<Filter, m>&) const;             \
  template Vector<BigInterval, m> SpaceFormAtlas<m>::in_chart(Label, const ModelPoint<BigInterval, m>&) const;
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
