#include "proofs/certificate/given_complex_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kernel/chart/model_space.hpp"
#include "kernel/manifold/quotient/element_table.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/inertia.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

/// Squared bounds of stretching that are tried, one after the other: 1 + s and 1 − s, s = 2^e, 2^e·5/4, 2^e·3/2,
/// 2^e·7/4, from 2^−30 on.
constexpr int steps_of_stretch = 150;
Rational squared_stretch(int step, bool above) {
  const Rational s = Rational(4 + step % 4) * Rational::power_of_two(step / 4 - 32);
  if (above) return Rational(1) + s;
  return s < Rational(1) ? Rational(1) - s : Rational::power_of_two(-step);
}

bool certainly_positive_definite(const SymmetricMatrix<BigInterval>& matrix) {
  const auto found = inertia(matrix);
  return found.has_value() && found->positive == matrix.order();
}

/// a·A − b·B.
SymmetricMatrix<BigInterval> combined(const BigInterval& a, const SymmetricMatrix<BigInterval>& A, const BigInterval& b,
                                      const SymmetricMatrix<BigInterval>& B) {
  SymmetricMatrix<BigInterval> result(A.order());
  for (std::size_t row = 0; row < A.order(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) result(row, column) = a * A(row, column) - b * B(row, column);
  }
  return result;
}

template <int m>
class GivenGeometry {
 public:
  using Point = ModelPoint<BigInterval, m>;

  GivenGeometry(const InvariantForm& form, const GivenComplex<m>& given)
      : curvature_(form.curvature()),
        metric_(chart_metric<m>(form).template on<BigInterval>()),
        simplices_(given.complex.simplices) {
    for (const auto& coordinates : given.points) {
      Vector<BigInterval, m> a;
      for (std::size_t axis = 0; axis < m; ++axis) a[axis] = BigInterval(coordinates[axis]);
      points_.push_back(model_point<BigInterval, m>(curvature_, a));
    }
    for (const FieldMatrix& element : given.elements) {
      motions_.push_back(in_standard_basis(form, element));
      inverses_.push_back(in_standard_basis(form, form.inverse_of(element)));
    }
    find_neighbours();
  }

  /// Edges, circumballs and, where all of these exist, flat simplices.
  void measure_simplices() {
    for (const auto& simplex : simplices_) measure(simplex);
  }

  /// Neighbours of the vertices of a simplex against its circumball, until one is not certainly outside.
  void measure_neighbours(const Progress& progress) {
    for (std::size_t at = 0; at < simplices_.size() && neighbour_inside.empty(); ++at) {
      if (at % 64 == 0) progress("measure circumballs", at, simplices_.size());
      measure_neighbours_of(at);
    }
  }

  BigInterval longest{0}, circumradius{0};
  std::optional<BigInterval> protection;
  std::size_t without_ball = 0;
  std::string neighbour_inside;  ///< by labels
  int above = 0, below = 0;
  std::map<std::array<std::uint32_t, 2>, BigInterval> cotangents;  ///< of surfaces, by edges

 private:
  struct Ball {
    Point centre;
    BigInterval radius;
  };

  static ModelMatrix<BigInterval, m> in_standard_basis(const InvariantForm& form, const FieldMatrix& element) {
    const auto rows = form.in_standard_basis(element);
    ModelMatrix<BigInterval, m> result;
    for (std::size_t row = 0; row <= m; ++row) std::copy(rows[row].begin(), rows[row].end(), result[row].begin());
    return result;
  }

  void find_neighbours() {
    neighbours_.resize(points_.size());
    for (const auto& simplex : simplices_) {
      for (std::size_t from = 0; from <= m; ++from) {
        for (std::size_t to = 0; to <= m; ++to) {
          if (to == from || neighbours_[simplex[from]].count(simplex[to]) > 0) continue;
          const Point there = applied(motions_[element_at<m>(simplex, to)], points_[simplex[to]]);
          neighbours_[simplex[from]][simplex[to]] = applied(inverses_[element_at<m>(simplex, from)], there);
        }
      }
    }
  }

  [[nodiscard]] BigInterval distance(const Point& x, const Point& y) const {
    return distance_of_chord(curvature_, squared_chord<BigInterval, m>(curvature_, metric_, x, y));
  }

  void measure(const PlacedSimplex<m>& simplex) {
    std::array<Point, static_cast<std::size_t>(m) + 1> lifts;
    for (std::size_t k = 0; k <= m; ++k) lifts[k] = applied(motions_[element_at<m>(simplex, k)], points_[simplex[k]]);
    SymmetricMatrix<BigInterval> chords(m + 1), arcs(m + 1);
    for (std::size_t a = 1; a <= m; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        chords(a, b) = squared_chord<BigInterval, m>(curvature_, metric_, lifts[a], lifts[b]);
        const BigInterval length = distance_of_chord(curvature_, chords(a, b));
        longest = maximum(longest, length);
        arcs(a, b) = square(length);
      }
    }
    balls_.push_back(circumball(lifts, edge_gram_from_squared_edges(chords)));
    if (!balls_.back()) {
      ++without_ball;
      return;
    }
    circumradius = maximum(circumradius, balls_.back()->radius);
    const auto flat = edge_gram_from_squared_edges(arcs).gram();
    stretch(flat, edge_gram_from_squared_edges(chords).gram());
    if constexpr (m == 2) add_cotangents(simplex, arcs);
  }

  /// The ball with the centre on the ray of the circumcentre of the lifts in the linear model. None where it is not
  /// certain.
  std::optional<Ball> circumball(const std::array<Point, static_cast<std::size_t>(m) + 1>& lifts,
                                 const EdgeGram<BigInterval>& chords) {
    if (!certainly_positive_definite(chords.gram())) return std::nullopt;
    const auto sphere = circumsphere(chords);
    if (!sphere) return std::nullopt;
    // sin²ρ, ρ², sinh²ρ.
    const BigInterval squared_radius = sphere->squared_radius;
    squared_cosine_ = BigInterval(1) - detail::times(curvature_, squared_radius);
    if (!is_proved(less(BigInterval(0), squared_cosine_))) return std::nullopt;
    const BigInterval scale = square_root(squared_cosine_);
    Point centre = scaled(sphere->barycentric[0] / scale, lifts[0]);
    for (std::size_t k = 1; k <= m; ++k) centre = sum(centre, scaled(sphere->barycentric[k] / scale, lifts[k]));
    return Ball{centre, distance(centre, lifts[0])};
  }

  /// Theorem 6X: 6.bilipschitz. Uses the ball that was found last.
  void stretch(const SymmetricMatrix<BigInterval>& flat, const SymmetricMatrix<BigInterval>& straight) {
    const BigInterval k = curvature_ == Curvature::positive ? squared_cosine_ : BigInterval(1) / squared_cosine_;
    const BigInterval one(1);
    const auto fits_above = [&] {
      return certainly_positive_definite(combined(BigInterval(squared_stretch(above, true)) * k, flat, one, straight));
    };
    const auto fits_below = [&] {
      return certainly_positive_definite(combined(one, straight, BigInterval(squared_stretch(below, false)) / k, flat));
    };
    while (above < steps_of_stretch && !fits_above()) ++above;
    while (below < steps_of_stretch && !fits_below()) ++below;
  }

  /// Of the angle opposite to each edge.
  void add_cotangents(const PlacedSimplex<m>& simplex, const SymmetricMatrix<BigInterval>& arcs) {
    for (std::size_t apex = 0; apex <= 2; ++apex) {
      const std::size_t i = apex == 0 ? 1 : 0, j = apex == 2 ? 1 : 2;
      const BigInterval twice_product = arcs(apex, i) + arcs(apex, j) - arcs(i, j);
      const BigInterval squared = BigInterval(4) * arcs(apex, i) * arcs(apex, j) - square(twice_product);
      cotangents[{simplex[i], simplex[j]}] += twice_product / square_root(squared);
    }
  }

  void measure_neighbours_of(std::size_t at) {
    const PlacedSimplex<m>& simplex = simplices_[at];
    const auto end = simplex.begin() + m + 1;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      for (const auto& [label, there] : neighbours_[simplex[corner]]) {
        if (std::find(simplex.begin(), end, label) != end) continue;
        const Point lift = applied(motions_[element_at<m>(simplex, corner)], there);
        const BigInterval gap = distance(balls_[at]->centre, lift) - balls_[at]->radius;
        protection = protection ? minimum(*protection, gap) : gap;
        if (is_proved(less(BigInterval(0), gap))) continue;
        neighbour_inside = fmt::format("label {} is not certainly outside of the circumball of simplex {{{}}}", label,
                                       fmt::join(simplex.begin(), end, ", "));
        return;
      }
    }
  }

  Curvature curvature_;
  MetricOn<BigInterval, m> metric_;
  const std::vector<PlacedSimplex<m>>& simplices_;
  std::vector<Point> points_;
  std::vector<ModelMatrix<BigInterval, m>> motions_, inverses_;
  std::vector<std::map<std::uint32_t, Point>> neighbours_;  ///< of a label: its neighbours, beside it
  std::vector<std::optional<Ball>> balls_;
  BigInterval squared_cosine_;
};

}  // namespace

template <int m>
GivenComplexClaims claims_of(const InvariantForm& form, const GivenComplex<m>& given, const LevelSelection& selection,
                             const Progress& progress) {
  GivenComplexClaims result;
  std::vector<std::uint32_t> labels;
  for (const auto& simplex : given.complex.simplices)
    labels.insert(labels.end(), simplex.begin(), simplex.begin() + m + 1);
  result.levels.manifold = manifold_claim(PureComplex(Dimension(m), labels), given.complex.simplices.size(), true);
  if (selects(selection, "5") || selects(selection, "6"))
    result.levels.triangulation = TriangulationClaim{"space-form", {}};

  GivenGeometry<m> geometry(form, given);
  geometry.measure_simplices();
  result.longest_edge = stated_above(geometry.longest.upper());
  const auto refuse = [&](const char* level, const std::string& why) {
    if (selects(selection, level)) result.not_reached.push_back(fmt::format("level {}: {}", level, why));
  };
  if (geometry.without_ball > 0) {
    const std::string why = fmt::format("of {} simplices no circumball is certain", geometry.without_ball);
    refuse("4", why);
    refuse("6", why);
    return result;
  }
  if (selects(selection, "4")) {
    geometry.measure_neighbours(progress);
    const Rational radius = stated_above(geometry.circumradius.upper());
    // On the sphere twice the radius and the protection are below a right angle (form.ranges).
    const Rational most = half_turn().lower() / Rational(2) - Rational(2) * radius;
    if (!geometry.neighbour_inside.empty()) {
      refuse("4", geometry.neighbour_inside);
    } else if (form.curvature() == Curvature::positive && !(most > Rational(0))) {
      refuse("4", "a circumball is no smaller than a quarter of a great circle");
    } else {
      Rational margin = geometry.protection ? stated_below(geometry.protection->lower()) : radius;
      if (form.curvature() == Curvature::positive && margin >= most) margin = stated_below(most);
      result.levels.delaunay = DelaunayClaim{DelaunayClaim::Balls{margin, radius}, {}};
    }
  }
  if (selects(selection, "6")) {
    if (geometry.above == steps_of_stretch || geometry.below == steps_of_stretch) {
      refuse("6", "a simplex is stretched too much");
      return result;
    }
    const auto root = [](int step, bool above) { return square_root(BigInterval(squared_stretch(step, above))); };
    MetricClaim metric;
    metric.least_stretch = stated_below(root(geometry.below, false).lower(), digits_of_stretches);
    metric.greatest_stretch = stated_above(root(geometry.above, true).upper(), digits_of_stretches);
    if (m == 2 && !geometry.cotangents.empty()) {
      Rational least = geometry.cotangents.begin()->second.lower();
      for (const auto& [edge, sum] : geometry.cotangents) least = std::min(least, sum.lower());
      metric.self_delaunay = least > Rational(0);
      if (metric.self_delaunay) metric.weight = stated_below(least);
    }
    result.levels.metric = metric;
  }
  return result;
}

template <int m>
void write_given_complex(const std::filesystem::path& path, const ComplexDescription& description,
                         const GivenComplex<m>& given, const GivenComplexClaims& claims, const Origin& origin,
                         const Progress& progress) {
  const SpaceForm form{
      {description.name, description.form, description.generators, {}, {}}, true, {}, {}, {}, {}, {}, {}};
  RunParameters parameters;
  parameters.origin = origin;
  parameters.mode = RunMode::none;
  parameters.algorithm.separation = Rational::power_of_two(-10);
  parameters.squared_flake_parameter = Rational::power_of_two(-120);
  write_certificate<m>(path,
                       {manifold_object(form), parameters, claims.longest_edge, claims.levels, given.points.size(),
                        [&](Label label) {
                          const Vector<Rational, m>& point = given.points[label.value];
                          return std::vector<Rational>(point.begin(), point.end());
                        },
                        [](Label) { return std::vector<Rational>(static_cast<std::size_t>(m)); }, given.complex},
                       progress);
}

#define DELCERT_INSTANTIATE(m)                                                                                  \
  template GivenComplexClaims claims_of<m>(const InvariantForm&, const GivenComplex<m>&, const LevelSelection&, \
                                           const Progress&);                                                    \
  template void write_given_complex<m>(const std::filesystem::path&, const ComplexDescription&,                 \
                                       const GivenComplex<m>&, const GivenComplexClaims&, const Origin&,        \
                                       const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
