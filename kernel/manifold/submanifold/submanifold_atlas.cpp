#include "kernel/manifold/submanifold/submanifold_atlas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "kernel/chart/geometry.hpp"
#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

static_assert(Geometry<SubmanifoldAtlas<1>, 1> && Geometry<SubmanifoldAtlas<2>, 2> && Geometry<SubmanifoldAtlas<3>, 3>);

namespace {

template <std::size_t m>
bool is_same(const std::array<Interval, m>& a, const std::array<Interval, m>& b) {
  for (std::size_t axis = 0; axis < m; ++axis) {
    if (a[axis].lower() != b[axis].lower() || a[axis].upper() != b[axis].upper()) return false;
  }
  return true;
}

Interval whole_line() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return Interval::between(-infinity, infinity);
}

/// Whether coordinates and heights are certainly in the cylinder.
template <class S>
bool is_in_cylinder(const TangentChart& chart, const S* y, std::size_t m, const std::vector<S>& heights) {
  S squared = square(y[0]);
  for (std::size_t k = 1; k < m; ++k) squared += square(y[k]);
  Verdict inside = less(squared, scalar_from<S>(square(chart.data().radius)));
  for (const S& height : heights)
    inside = conjunction(inside, less(absolute(height), scalar_from<S>(chart.data().height)));
  return is_proved(inside);
}

}  // namespace

template <int m>
SubmanifoldAtlas<m>::SubmanifoldAtlas(std::shared_ptr<const EmbeddedManifold> manifold, FittedCharts charts,
                                      SamplingRadii radii, const Progress& progress)
    : manifold_(std::move(manifold)),
      charts_(std::move(charts)),
      radii_(std::move(radii)),
      net_(std::vector<Vector<Rational, m>>(charts_.charts.size())),
      grid_(manifold_->ambient(), 6 * approximate_double(radii_.greatest()) * middle_unit(radii_.units())),
      remembered_(charts_.charts.size()),
      locks_(std::make_unique<std::array<std::mutex, lock_count>>()) {
  if (charts_.charts.empty()) throw InputError("a net has at least one point");
  enclose_originals(progress);
  find_patches(progress);
}

template <int m>
void SubmanifoldAtlas<m>::enclose_originals(const Progress& progress) {
  const auto enclose = [&](std::size_t first, std::size_t last) {
    const RoundingGuard guard;
    std::vector<Interval> found;
    for (auto index = static_cast<std::uint32_t>(first); index < last; ++index) {
      const auto x = position<Interval>(Label(index), {});
      if (!x)
        throw Undecided(manifold_->name() + ": the point of the manifold at the centre of label " +
                        std::to_string(index) + " cannot be enclosed in doubles");
      found.insert(found.end(), x->begin(), x->end());
    }
    return found;
  };
  in_parts("enclose points", size(), progress, enclose, [&](const std::vector<Interval>& found) {
    originals_.insert(originals_.end(), found.begin(), found.end());
  });
  std::vector<double> x(manifold_->ambient());
  for (std::size_t index = 0; index < size(); ++index) {
    for (std::size_t axis = 0; axis < x.size(); ++axis) x[axis] = originals_[index * x.size() + axis].lower();
    grid_.insert(x.data());
  }
}

template <int m>
void SubmanifoldAtlas<m>::find_patches(const Progress& progress) {
  in_parts(
      "find patches", size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        std::vector<std::vector<Seen>> found;
        for (auto index = static_cast<std::uint32_t>(first); index < last; ++index)
          found.push_back(patch_of(Label(index)));
        return found;
      },
      [&](std::vector<std::vector<Seen>> found) {
        for (auto& patch : found) patches_.push_back(std::move(patch));
      });
}

template <int m>
auto SubmanifoldAtlas<m>::patch_of(Label i) const -> std::vector<Seen> {
  const std::size_t n = manifold_->ambient();
  const TangentChart& chart = charts_.charts[i.value];
  // In a patch, |x − p| ≤ √(1 + L²)|φ(x) − φ(p)|, by the graph.
  const Rational farthest = (Rational(1) + distortion_of_slope(charts_.slope)) * chart.data().radius;
  const double reach = approximate_double(farthest) * (1 + 0x1p-20);
  const double radius = scalar_from<Interval>(chart.data().radius).upper();
  // No point of M is at a height between |z₀| + 9Lϱ/16 and ζ; heights in the middle tell for certain.
  const double between =
      (scalar_from<Interval>(chart.data().height) * (Interval(1) - Interval::exactly(0x1p-10))).lower();
  std::vector<Seen> result;
  grid_.visit(grid_[i.value], reach, [&](std::uint32_t index, double) {
    const Interval* x = &originals_[index * n];
    Interval squared(0);
    for (std::size_t k = 0; k < m; ++k) squared += square(chart.enclosed().coordinate(x, k));
    const double distance = square_root(squared).lower();
    if (distance > radius) return false;
    for (std::size_t b = m; b < n; ++b) {
      if (absolute(chart.enclosed().coordinate(x, b)).lower() > between) return false;
    }
    result.push_back({index, static_cast<float>(distance * (1 - 0x1p-22))});
    return false;
  });
  std::sort(result.begin(), result.end(), [](const Seen& a, const Seen& b) { return a.index < b.index; });
  return result;
}

template <int m>
template <class S>
std::optional<std::vector<S>> SubmanifoldAtlas<m>::position(Label i, const Vector<S, m>& home) const {
  const TangentChart& chart = charts_.charts[i.value];
  const auto heights = manifold_->evaluation()->heights(chart, home.data());
  const auto solve = [&](const EnclosedChart<S>& enclosed) -> std::optional<std::vector<S>> {
    if (!heights || !is_in_cylinder<S>(chart, home.data(), m, *heights)) return std::nullopt;
    std::vector<S> place(home.begin(), home.end());
    place.insert(place.end(), heights->begin(), heights->end());
    std::vector<S> x(manifold_->ambient());
    enclosed.position(place.data(), x.data());
    return x;
  };
  if constexpr (std::same_as<S, Interval>) {
    return solve(chart.enclosed());
  } else {
    return solve(chart.template on<S>());
  }
}

template <int m>
void SubmanifoldAtlas<m>::near(Label i, double distance, std::vector<Label>& out) const {
  const std::size_t first = out.size();
  grid_.visit(grid_[i.value], distance, [&](std::uint32_t index, double) {
    out.emplace_back(index);
    return false;
  });
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
}

template <int m>
std::vector<Sighting<m>> SubmanifoldAtlas<m>::neighbours(Label i) const {
  std::vector<Sighting<m>> result;
  for (const Seen& seen : patches_[i.value]) result.push_back({seen.index, {}});
  return result;
}

template <int m>
void SubmanifoldAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  out.clear();
  for (const Seen& seen : patches_[i.value]) {
    if (seen.distance <= distance) out.push_back({seen.index, {}});
  }
  if (distance <= approximate_double(charts_.charts[i.value].data().radius) * (1 + 0x1p-20)) return;
  grid_.visit(grid_[i.value], distance, [&](std::uint32_t index, double) {
    out.push_back({index, {}});
    return false;
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

template <int m>
void SubmanifoldAtlas<m>::filtered_position(Label i, const Vector<Interval, m>& home, Interval* x) const {
  const std::size_t n = manifold_->ambient();
  if (is_same(home, {})) {
    std::copy_n(&originals_[i.value * n], n, x);
    return;
  }
  std::mutex& lock = (*locks_)[i.value % lock_count];
  {
    const std::lock_guard hold(lock);
    const Remembered& last = remembered_[i.value];
    if (!last.position.empty() && is_same(last.home, home)) {
      std::copy(last.position.begin(), last.position.end(), x);
      return;
    }
  }
  const auto found = position<Interval>(i, home);
  const std::vector<Interval> result = found ? *found : std::vector<Interval>(n, whole_line());
  std::copy(result.begin(), result.end(), x);
  const std::lock_guard hold(lock);
  remembered_[i.value] = {home, result};
}

template <int m>
Vector<Filter, m> SubmanifoldAtlas<m>::carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const {
  if (seen.index == i.value) return home;
  const RoundingGuard guard;
  Vector<Interval, m> enclosed;
  for (std::size_t k = 0; k < m; ++k) enclosed[k] = Interval::between(home[k].lower(), home[k].upper());
  std::array<Interval, most_ambient_dimensions> x;
  filtered_position(label_of<m>(seen), enclosed, x.data());
  Vector<Filter, m> result;
  for (std::size_t k = 0; k < m; ++k) {
    const Interval along = charts_.charts[i.value].enclosed().coordinate(x.data(), k);
    result[k] = Filter::between(along.lower(), along.upper());
  }
  return result;
}

template <int m>
Vector<BigInterval, m> SubmanifoldAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                  const Vector<BigInterval, m>& home) const {
  if (seen.index == i.value) return home;
  const auto x = position<BigInterval>(label_of<m>(seen), home);
  Vector<BigInterval, m> result;
  if (!x) {
    result.fill(BigInterval(1) / BigInterval(0));
    return result;
  }
  const auto enclosed = charts_.charts[i.value].template on<BigInterval>();
  for (std::size_t k = 0; k < m; ++k) result[k] = enclosed.coordinate(x->data(), k);
  return result;
}

template <int m>
std::optional<Vector<Rational, m>> SubmanifoldAtlas<m>::carry(Label i, const Sighting<m>& seen,
                                                              const Vector<Rational, m>& home) const {
  if (seen.index == i.value) return home;
  const auto x = position<Rational>(label_of<m>(seen), home);
  if (!x) return std::nullopt;
  const auto chart = charts_.charts[i.value].template on<Rational>();
  Vector<Rational, m> result;
  for (std::size_t k = 0; k < m; ++k) result[k] = chart.coordinate(x->data(), k);
  return result;
}

Rational radius_variation(const std::vector<TangentChart>& charts, const SamplingRadii& radii) {
  if (!radii.vary()) return Rational(0);
  const double greatest = approximate_double(radii.greatest());
  AmbientGrid grid(charts.front().ambient(), 6 * greatest * middle_unit(radii.units()));
  for (const TangentChart& chart : charts) {
    std::vector<double> centre;
    for (const Rational& coordinate : chart.data().centre) centre.push_back(approximate_double(coordinate));
    grid.insert(centre.data());
  }
  double most = 0;
  for (std::uint32_t i = 0; i < charts.size(); ++i) {
    const double own = radii.units()[i];
    grid.visit(grid[i], 6 * greatest * own * (1 + 0x1p-20), [&](std::uint32_t j, double) {
      const double other = radii.units()[j];
      most = std::max(most, std::fabs(own - other) / std::min(own, other));
      return false;
    });
  }
  const Rational wider = Rational::exactly(most) * (Rational(1) + Rational::power_of_two(-20));
  return most == 0 ? Rational::power_of_two(-20) : rounded_up(wider, binary_exponent(wider) - 10);
}

#define DELCERT_INSTANTIATE(m)                                                                                         \
  template class SubmanifoldAtlas<m>;                                                                                  \
  template std::optional<std::vector<Interval>> SubmanifoldAtlas<m>::position(Label, const Vector<Interval, m>&)       \
      const;                                                                                                           \
  template std::optional<std::vector<BigInterval>> SubmanifoldAtlas<m>::position(Label, const Vector<BigInterval, m>&) \
      const;                                                                                                           \
  template std::optional<std::vector<Rational>> SubmanifoldAtlas<m>::position(Label, const Vector<Rational, m>&) const;
DELCERT_INSTANTIATE(1)
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
