#include "properties/instances/space_star.hpp"

#include <algorithm>

#include "kernel/chart/model_space.hpp"
#include "kernel/number/ladder.hpp"
#include "kernel/simplex/sphere_stack.hpp"
#include "kernel/simplex/thickness.hpp"
#include "properties/instances/net_sample.hpp"

namespace delcert {

namespace {

bool are_within(const SpaceObject& space, const Rational& length) {
  return std::all_of(space.points().begin(), space.points().end(),
                     [&](const ExactPoint& point) { return pairing(point, point) <= square(length); });
}

Rational squared_step(const ExactPoint& a, const ExactPoint& b) {
  const ExactPoint step = combined(a, Rational(-1), b);
  return pairing(step, step);
}

Rational squared_distance_of_nearest(const std::vector<ExactPoint>& points) {
  Rational result = squared_step(points.at(1), points[0]);
  for (std::size_t at = 2; at < points.size(); ++at) result = minimum(result, squared_step(points[at], points[0]));
  return result;
}

/// The points whose coordinates are at most `reach` from those of the first, by number, and whether these are all.
struct NearPoints {
  std::vector<std::uint32_t> numbers;
  Rational reach;
  bool is_all = false;
};

/// Grows the neighbourhood until `star_of` finds a star, or says that more points would not help, or all points are in
/// it. `star_of(neighbourhood, is_hopeless)` returns nothing unless it can tell that farther points have no part in it.
template <class StarOf>
auto in_a_neighbourhood(const SpaceObject& space, const StarOf& star_of)
    -> decltype(star_of(NearPoints{}, std::declval<bool&>())) {
  if (space.size() < static_cast<std::size_t>(space.dimension()) + 2 || !are_within(space, Rational(1)))
    return std::nullopt;
  constexpr long first = 6;
  constexpr unsigned bits = 20;
  NearPoints here;
  here.reach = Rational(first) * square_root_upper(squared_distance_of_nearest(space.points()), bits);
  bool is_hopeless = false;
  while (!here.is_all && !is_hopeless) {
    here.numbers.clear();
    for (std::uint32_t at = 0; at < space.size(); ++at) {
      if (squared_step(space.points()[at], space.points()[0]) <= square(here.reach)) here.numbers.push_back(at);
    }
    here.is_all = here.numbers.size() == space.size();
    if (auto star = star_of(here, is_hopeless)) return star;
    here.reach *= Rational(3) / Rational(2);
  }
  return std::nullopt;
}

/// By the numbers of all points.
StarCells renumbered(StarCells cells, const std::vector<std::uint32_t>& numbers) {
  for (auto& cell : cells) {
    for (std::uint32_t& at : cell) at = numbers[at];
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

template <int m>
Vector<Rational, m> exact_vector_of(const ExactPoint& point) {
  Vector<Rational, m> result;
  std::copy(point.begin(), point.end(), result.begin());
  return result;
}

/// Where to begin to look for a star.
template <int m>
Rational first_distance(const NetPoints<m>& points) {
  Rational nearest = pairing(difference(points.at(1), points[0]), difference(points[1], points[0]));
  for (const auto& point : points) {
    const auto edge = difference(point, points[0]);
    const Rational squared = pairing(edge, edge);
    if (squared > Rational(0)) nearest = minimum(nearest, squared);
  }
  constexpr unsigned bits = 20;
  return Rational(2) * square_root_upper(nearest, bits);
}

/// With |x| ≤ 1 for all coordinates, the coordinates of a point about another one are at least 4/5 of the difference
/// of theirs: |x − y|² is divided by 1 + K⟨x, y⟩/2 + |x|²|y|²/16 ≤ (5/4)².
template <int m>
std::optional<StarCells> star_in_space_of(const SpaceObject& space, const NearPoints& here) {
  NetPoints<m> points;
  for (const std::uint32_t at : here.numbers) {
    const auto seen = seen_by(space.curvature(), space.points()[0], space.points()[at]);
    if (!seen) return std::nullopt;
    points.push_back(exact_vector_of<m>(*seen));
  }
  if (points.size() < static_cast<std::size_t>(m) + 2) return std::nullopt;
  auto cells = star_cells<m>(points, first_distance<m>(points));
  if (!cells) return std::nullopt;
  for (const auto& cell : *cells) {
    const auto centre = centre_of<m>(points, cell);
    const Rational squared = pairing(centre, centre);
    if (squared > Rational(1) / Rational(4)) return std::nullopt;
    if (!here.is_all && Rational(4) * squared > square(Rational(4) / Rational(5) * here.reach)) return std::nullopt;
  }
  return renumbered(*std::move(cells), here.numbers);
}

/// The points of a chart, relative to the first.
template <int m>
class PointsOfChart {
 public:
  PointsOfChart(const SpaceObject& space, const ExactPoint& centre, const NearPoints& here)
      : space_(space), here_(here), farther_(farther(space, centre)) {
    Vector<BigInterval, m> origin;
    for (const std::uint32_t at : here.numbers) {
      const auto seen = seen_by(space.curvature(), centre, space.points()[at]);
      if (!seen) {
        is_seen_ = false;
        return;
      }
      Vector<BigInterval, m> conformal;
      for (std::size_t axis = 0; axis < m; ++axis) conformal[axis] = BigInterval((*seen)[axis]);
      const auto point = logarithm_of_conformal<BigInterval, m>(space.curvature(), conformal);
      if (edges_.empty()) origin = point;
      edges_.push_back(edges_.empty() ? Vector<BigInterval, m>{} : difference(point, origin));
      squared_.push_back(detail::sum_of_squares(edges_.back()));
    }
  }

  /// Nothing without a star; `is_hopeless` if enclosures cannot certify the one that there seems to be.
  [[nodiscard]] std::optional<SeenStar> star(bool& is_hopeless) const {
    if (!is_seen_ || edges_.size() < static_cast<std::size_t>(m) + 2) return std::nullopt;
    const auto approximation = approximated();
    if (!approximation) return std::nullopt;
    auto cells = star_cells<m>(*approximation, first_distance<m>(*approximation));
    if (!cells || cells->empty()) return std::nullopt;
    std::optional<SeenStar> result;
    for (const auto& cell : *cells) {
      const auto measured = measure(cell, is_hopeless);
      if (!measured) return std::nullopt;
      if (!result) {
        result = measured;
      } else {
        result->thickness = minimum(result->thickness, measured->thickness);
        result->protection = minimum(result->protection, measured->protection);
      }
    }
    result->cells = renumbered(*std::move(cells), here_.numbers);
    result->protection *= BigInterval(space_.unit());
    return result;
  }

 private:
  /// Midpoints with some 50 digits.
  [[nodiscard]] std::optional<NetPoints<m>> approximated() const {
    constexpr long bits = 50;
    const long unit = binary_exponent(here_.reach) - bits;
    NetPoints<m> result(edges_.size());
    for (std::size_t at = 0; at < edges_.size(); ++at) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        const BigInterval& x = edges_[at][axis];
        if (!x.is_bounded()) return std::nullopt;
        result[at][axis] = rounded_down((x.lower() + x.upper()) / Rational(2), unit);
      }
    }
    return result;
  }

  /// Thickness and protection of a simplex with an empty sphere; nothing unless it certainly is one.
  [[nodiscard]] std::optional<SeenStar> measure(const std::vector<std::uint32_t>& cell, bool& is_hopeless) const {
    is_hopeless = true;
    if (cell.size() != static_cast<std::size_t>(m) + 1) return std::nullopt;
    const auto metric = FrameMetric<m>::cartesian().template on<BigInterval>();
    SphereStack<BigInterval, m> sphere(metric);
    for (std::size_t at = 1; at < cell.size(); ++at) {
      if (!is_proved(sphere.push(edges_[cell[at]], squared_[cell[at]]))) return std::nullopt;
    }
    const BigInterval& squared_radius = sphere.squared_radius();
    const BigInterval radius = square_root(squared_radius);
    is_hopeless = false;
    // What is not in the neighbourhood is farther from the first point than 4R, so outside by more than 2R.
    if (!here_.is_all && !is_proved(less(BigInterval(4) * radius, BigInterval(here_.reach * farther_)))) {
      return std::nullopt;
    }
    SeenStar result;
    BigInterval protection = twice(radius);
    for (std::size_t other = 0; other < edges_.size(); ++other) {
      if (std::find(cell.begin(), cell.end(), other) != cell.end()) continue;
      const BigInterval power = sphere.power(edges_[other], squared_[other]);
      is_hopeless = !is_proved(less(BigInterval(0), power));
      if (is_hopeless) return std::nullopt;
      // |q − C| − R, from |q − C|² − R².
      protection = minimum(protection, power / (square_root(power + squared_radius) + radius));
    }
    // Else what is left out might be nearer.
    if (!is_proved(less(protection, twice(radius)))) return std::nullopt;
    result.protection = protection;
    SymmetricMatrix<BigInterval> squared(cell.size());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        squared(i, j) = detail::sum_of_squares(difference(edges_[cell[i]], edges_[cell[j]]));
      }
    }
    const auto thick = thickness(edge_gram_from_squared_edges(std::move(squared)));
    if (!thick) return std::nullopt;
    result.thickness = *thick;
    return result;
  }

  /// A point whose coordinates differ from those of the first by `reach` or more is at least this part of `reach` from
  /// it in the chart. If all coordinates are of length at most λ, reach ≤ 2λ, those of the point about the first are of
  /// a length t ≥ reach/(1 + λ²/4), and its distance in the space is 2 arctan(t/2) or 2 artanh(t/2) ≥ t. Charts of
  /// spheres do not shorten; those of hyperbolic spaces shorten by sinh r/r at most, r ≤ 4 artanh(λ/2) the greatest
  /// distance from the centre. So for λ = 1/2 it is 0.87 reach and 0.79 reach, for λ = 1 0.67 reach and 0.35 reach.
  [[nodiscard]] static Rational farther(const SpaceObject& space, const ExactPoint& centre) {
    const Rational half = Rational(1) / Rational(2);
    const bool is_close = are_within(space, half) && pairing(centre, centre) <= square(half);
    return is_close ? Rational(3) / Rational(4) : Rational(1) / Rational(3);
  }

  const SpaceObject& space_;
  const NearPoints& here_;
  Rational farther_;
  bool is_seen_ = true;
  std::vector<Vector<BigInterval, m>> edges_;
  std::vector<BigInterval> squared_;
};

}  // namespace

std::optional<SeenStar> star_in_chart(const SpaceObject& points, const ExactPoint& centre) {
  if (pairing(centre, centre) > Rational(1)) return std::nullopt;
  // What is not clear with so many digits is a tie.
  constexpr unsigned enough_bits = 256;
  const BigInterval::Precision precision(PrecisionBits{std::min(BigInterval::working_precision().value, enough_bits)});
  return with_net_dimension(points.dimension(), [&]<int m>() {
    return in_a_neighbourhood(points, [&](const NearPoints& here, bool& is_hopeless) -> std::optional<SeenStar> {
      return PointsOfChart<m>(points, centre, here).star(is_hopeless);
    });
  });
}

std::optional<StarCells> star_in_space(const SpaceObject& points) {
  return with_net_dimension(points.dimension(), [&]<int m>() {
    return in_a_neighbourhood(points, [&](const NearPoints& here, bool&) -> std::optional<StarCells> {
      return star_in_space_of<m>(points, here);
    });
  });
}

}  // namespace delcert
