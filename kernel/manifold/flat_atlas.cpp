#include "kernel/manifold/flat_atlas.hpp"

#include <algorithm>
#include <cstdint>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// Cells of this many sampling radii: most queries ask for 2.5 to 4.5.
constexpr double cell_factor = 2;
/// Lists are kept of what is within so many, give or take what stages widen their questions by: colours have to tell
/// apart what all that follows looks at. Separations are of less, patches of more.
constexpr double most_listed_radii = 4.5 * (1 + 0x1p-20);
/// How many entries lists have in all, about: 256 MiB.
constexpr std::size_t most_entries = std::size_t{1} << 25;

template <class S, int m>
Vector<S, m> translated(const Vector<S, m>& x, const Shift<m>& shift) {
  Vector<S, m> result = x;
  for (std::size_t axis = 0; axis < m; ++axis) {
    if (shift[axis] != 0) result[axis] += S(shift[axis]);
  }
  return result;
}

/// |p_i| + 8ε ≤ r, on squares: 8ε ≤ r and |p_i|² ≤ (r − 8ε)².
template <int m>
bool is_interior_point(const FlatSpace<m>& space, const Vector<Rational, m>& point, const Rational& sampling_radius) {
  if (space.is_torus()) return true;
  const Rational room = *space.ball_radius - Rational(8) * sampling_radius;
  if (room < Rational(0)) return false;
  return space.metric.template on<Rational>().squared_norm(point) <= square(room);
}

}  // namespace

template <int m>
FlatAtlas<m>::FlatAtlas(FlatSpace<m> space, PointSet<m> net, SamplingRadii radii, Rational radius_variation)
    : space_(std::move(space)),
      net_(std::move(net)),
      radii_(std::move(radii)),
      radius_variation_(std::move(radius_variation)),
      grid_(space_.metric, space_.box_radius(),
            cell_factor * approximate_double(sampling_radius()) * middle_unit(radii_.units()), net_.size()),
      near_(std::make_unique<NearLists<NearShifts>>(net_.size(), most_entries)),
      most_listed_(most_listed_radii * approximate_double(sampling_radius())) {
  for (const auto& point : net_.approximate_all()) grid_.insert(point);
  interior_.reserve(net_.size());
  for (std::uint32_t index = 0; index < net_.size(); ++index) {
    interior_.push_back(is_interior_point(space_, net_.exact(Label(index)), sampling_radius()));
  }
}

template <int m>
std::vector<Sighting<m>> FlatAtlas<m>::neighbours(Label i) const {
  std::vector<Sighting<m>> result;
  sightings(i, approximate_double(patch_factor() * sampling_radius(i)), result);
  return result;
}

namespace {

/// Sorts them. Nearly all have different labels, and with their places these fit into one number, which is compared in
/// a fraction of the time.
template <int m>
void sort_sightings(std::vector<Sighting<m>>& sightings) {
  thread_local std::vector<std::uint64_t> keys;
  thread_local std::vector<Sighting<m>> unsorted;
  keys.clear();
  for (std::size_t at = 0; at < sightings.size(); ++at) {
    keys.push_back(std::uint64_t{sightings[at].index} << 32U | at);
  }
  std::sort(keys.begin(), keys.end());
  unsorted.swap(sightings);
  sightings.resize(unsorted.size());
  bool is_sorted = true;
  for (std::size_t at = 0; at < keys.size(); ++at) {
    sightings[at] = unsorted[static_cast<std::uint32_t>(keys[at])];
    is_sorted = is_sorted && (at == 0 || sightings[at - 1].index != sightings[at].index);
  }
  if (!is_sorted) std::sort(sightings.begin(), sightings.end());
}

}  // namespace

template <int m>
void FlatAtlas<m>::find_near(Label i, double distance, std::vector<Sighting<m>>& out) const {
  out.clear();
  grid_.near(net_.approximate(i), distance, out);
  sort_sightings<m>(out);
}

template <int m>
typename FlatAtlas<m>::NearShifts FlatAtlas<m>::listed(const std::vector<Sighting<m>>& seen, double distance) {
  using Small = std::int8_t;
  NearShifts result{distance, {}};
  result.entries.reserve(seen.size());
  for (const Sighting<m>& sighting : seen) {
    auto& entry = result.entries.emplace_back();
    entry.index = sighting.index;
    for (std::size_t axis = 0; axis < m; ++axis) {
      entry.shift[axis] = static_cast<Small>(sighting.shift[axis]);
      if (entry.shift[axis] != sighting.shift[axis]) return {};
    }
  }
  return result;
}

template <int m>
void FlatAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  if (!(distance >= most_listed_ / 2 && distance <= most_listed_)) return find_near(i, distance, out);
  // The first to ask is the one who asks for most.
  bool is_found = false;
  const NearShifts* list = near_->of(i.value, [&] {
    find_near(i, distance, out);
    is_found = true;
    return listed(out, distance);
  });
  if (is_found) return;
  if (list == nullptr || !(distance <= list->distance)) return find_near(i, distance, out);
  const Vector<double, m>& centre = net_.approximate(i);
  const double most = grid_.most_squared(centre, distance);
  // About half of them are near, which no processor predicts: all are written, and what is not near is written over.
  out.resize(list->entries.size());
  std::size_t count = 0;
  for (const auto& entry : list->entries) {
    Vector<double, m> shift;
    Sighting<m>& sighting = out[count];
    sighting.index = entry.index;
    for (std::size_t axis = 0; axis < m; ++axis) {
      shift[axis] = entry.shift[axis];
      sighting.shift[axis] = entry.shift[axis];
    }
    sighting.element = 0;
    count += static_cast<std::size_t>(grid_.squared_distance(centre, entry.index, shift) <= most);
  }
  out.resize(count);
}

template <int m>
Vector<Filter, m> FlatAtlas<m>::carry(Label, const Sighting<m>& seen, const Vector<Filter, m>& home) const {
  return translated<Filter, m>(home, seen.shift);
}

template <int m>
Vector<BigInterval, m> FlatAtlas<m>::carry(Label, const Sighting<m>& seen, const Vector<BigInterval, m>& home) const {
  return translated<BigInterval, m>(home, seen.shift);
}

template <int m>
std::optional<Vector<Rational, m>> FlatAtlas<m>::carry(Label, const Sighting<m>& seen,
                                                       const Vector<Rational, m>& home) const {
  return translated<Rational, m>(home, seen.shift);
}

#define DELCERT_INSTANTIATE(m) template class FlatAtlas<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
