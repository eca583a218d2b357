#include "kernel/manifold/submanifold/mesh_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/submanifold/chord_bend.hpp"
#include "kernel/manifold/submanifold/shown_facet.hpp"
#include "kernel/number/elementary.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

BigInterval hull_of(const BigInterval& a, const BigInterval& b) { return hull(a, b); }
Interval hull_of(const Interval& a, const Interval& b) {
  return Interval::between(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
}
Rational hull_of(const Rational& a, const Rational&) { return a; }

Interval in_doubles_of(const Interval& x) { return x; }
Interval in_doubles_of(const BigInterval& x) { return in_doubles(x); }
Interval in_doubles_of(const Rational& x) { return scalar_from<Interval>(x); }

class MeshEvaluation final : public GraphEvaluation {
 public:
  explicit MeshEvaluation(const PolyhedralMesh& mesh) : mesh_(mesh) {}

  std::optional<std::vector<Interval>> heights(const TangentChart& chart, const Interval* y) override {
    return heights_in<Interval>(chart, chart.enclosed(), y);
  }
  std::optional<std::vector<BigInterval>> heights(const TangentChart& chart, const BigInterval* y) override {
    return heights_in<BigInterval>(chart, chart.on<BigInterval>(), y);
  }
  std::optional<std::vector<Rational>> heights(const TangentChart& chart, const Rational* y) override {
    return heights_in<Rational>(chart, chart.on<Rational>(), y);
  }

  bool enclose(const TangentChart& chart, std::span<const Interval* const> vertices, double displacement,
               DerivativeHull& hull) override {
    const EnclosedChart<Interval>& in = chart.enclosed();
    ShownSimplex simplex(in, vertices);
    std::array<Interval, 3> place;
    const Interval around = Interval::between(-displacement, displacement);
    for (std::size_t k = 0; k < 2; ++k) place[k] = simplex.side(k) + around;
    place[2] = closed_side(chart.data().height);
    hull.matrices.clear();
    hull.spread = Interval(0);
    double overlay = 0;
    bool is_transversal = true;
    visit_facets(mesh_, in, place.data(), [&](std::uint32_t facet) {
      const ShownFacet shown(mesh_, in, facet);
      if (!simplex.may_be_under(shown, displacement)) return;
      const Interval up = shown.normal[2] * in.preconditioner[0];
      if (!is_refuted(is_zero(up))) is_transversal = false;
      Dense<Interval>& matrix = hull.matrices.emplace_back(3);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = 0; k < 3; ++k) matrix[axis] += in.at(axis, k) * (shown.normal[k] / up);
      }
      if (simplex.may_be_under(shown, 0)) overlay = std::max(overlay, simplex.farthest(shown));
    });
    if (!is_transversal || hull.matrices.empty()) return false;
    overlay = (Interval::exactly(overlay) / absolute(in.preconditioner[0])).upper();
    hull.height = std::min(overlay, height_by_slopes(hull.matrices, vertices));
    return true;
  }

  /// Slopes of facets less what is affine in the place, by least squares over the facets.
  std::optional<SlopeChange> slope_change(const TangentChart& chart, const Interval* place, const Interval&) override {
    const EnclosedChart<Interval>& in = chart.enclosed();
    const std::array<Interval, 3> low{place[0], place[1], closed_side(chart.data().height)};
    std::vector<SlopedFacet> facets;
    bool is_transversal = true;
    visit_facets(mesh_, in, low.data(), [&](std::uint32_t facet) {
      const ShownFacet shown(mesh_, in, facet);
      if (is_beside(shown, low.data())) return;
      if (!is_refuted(is_zero(shown.normal[2]))) is_transversal = false;
      facets.push_back({shown.corners, {-(shown.normal[0] / shown.normal[2]), -(shown.normal[1] / shown.normal[2])}});
    });
    if (!is_transversal || facets.empty()) return std::nullopt;
    return change_about(facets, affine_fit(facets));
  }

  std::optional<ChordBend> chord_bend(const Interval*, const Interval*) override { return std::nullopt; }

 private:
  struct SlopedFacet {
    std::array<std::array<Interval, 3>, 3> corners;
    std::array<Interval, 2> slope;
  };
  /// s + Ay, A symmetric: s₀, s₁, A₀₀, A₀₁, A₁₁.
  using AffineSlope = std::array<double, 5>;

  /// Whether all of the facet is on one side of the box.
  static bool is_beside(const ShownFacet& facet, const Interval* place) {
    for (std::size_t k = 0; k < 3; ++k) {
      double least = std::numeric_limits<double>::infinity();
      double greatest = -least;
      for (const auto& corner : facet.corners) {
        least = std::min(least, corner[k].lower());
        greatest = std::max(greatest, corner[k].upper());
      }
      if (greatest < place[k].lower() || place[k].upper() < least) return true;
    }
    return false;
  }

  /// In doubles: of the slopes at the middles of facets, weighted by their areas. 0 where the system is singular.
  static AffineSlope affine_fit(const std::vector<SlopedFacet>& facets) {
    Dense<double> gram(25, 0);
    AffineSlope right{};
    for (const SlopedFacet& facet : facets) {
      const double x = (facet.corners[0][0].lower() + facet.corners[1][0].lower() + facet.corners[2][0].lower()) / 3;
      const double y = (facet.corners[0][1].lower() + facet.corners[1][1].lower() + facet.corners[2][1].lower()) / 3;
      const double weight = std::fabs(side_of(facet.corners, 0, facet.corners[2][0], facet.corners[2][1]).lower());
      const std::array<AffineSlope, 2> rows{{{1, 0, x, y, 0}, {0, 1, 0, x, y}}};
      for (std::size_t row = 0; row < 2; ++row) {
        for (std::size_t a = 0; a < 5; ++a) {
          right[a] += weight * rows[row][a] * facet.slope[row].lower();
          for (std::size_t b = 0; b < 5; ++b) gram[a * 5 + b] += weight * rows[row][a] * rows[row][b];
        }
      }
    }
    AffineSlope result{};
    const auto inverse = inverse_of(std::move(gram), 5);
    for (std::size_t a = 0; inverse && a < 5; ++a) {
      for (std::size_t b = 0; b < 5; ++b) result[a] += (*inverse)[a * 5 + b] * right[b];
    }
    return std::all_of(result.begin(), result.end(), [](double x) { return std::fabs(x) < 0x1p100; }) ? result
                                                                                                      : AffineSlope{};
  }

  /// The greatest |⟨e, Ae⟩|, and how far slopes are from s + Ay, which is farthest at a corner.
  static SlopeChange change_about(const std::vector<SlopedFacet>& facets, const AffineSlope& affine) {
    std::array<Interval, 5> a;
    std::transform(affine.begin(), affine.end(), a.begin(), [](double x) { return Interval::exactly(x); });
    Interval squared(0);
    for (const SlopedFacet& facet : facets) {
      for (const auto& corner : facet.corners) {
        squared = maximum(squared, square(facet.slope[0] - a[0] - a[2] * corner[0] - a[3] * corner[1]) +
                                       square(facet.slope[1] - a[1] - a[3] * corner[0] - a[4] * corner[1]));
      }
    }
    const Interval two(2);
    return {absolute(a[2] + a[4]) / two + square_root(square((a[2] - a[4]) / two) + square(a[3])),
            square_root(squared)};
  }

  /// The simplex at hand in a chart: barycentric coordinates b_v(y), affine in y, and its heights.
  class ShownSimplex {
   public:
    ShownSimplex(const EnclosedChart<Interval>& chart, std::span<const Interval* const> vertices) {
      for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t k = 0; k < 3; ++k) corners_[v][k] = chart.coordinate(vertices[v], k);
      }
      area_ = side_of(corners_, 0, corners_[2][0], corners_[2][1]);
      is_thick_ = is_refuted(is_zero(area_));
      is_positive_ = area_.lower() > 0;
      for (std::size_t edge = 0; edge < 3; ++edge)
        lengths_[edge] = square_root(square(corners_[(edge + 1) % 3][0] - corners_[edge][0]) +
                                     square(corners_[(edge + 1) % 3][1] - corners_[edge][1]));
    }
    [[nodiscard]] Interval side(std::size_t axis) const {
      return hull_of(hull_of(corners_[0][axis], corners_[1][axis]), corners_[2][axis]);
    }
    /// Whether the facet may be over a place that is within the distance of the simplex: false if it is beyond the line
    /// of one of the edges.
    [[nodiscard]] bool may_be_under(const ShownFacet& facet, double distance) const {
      if (!is_thick_) return true;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        bool is_beyond = true;
        for (const auto& corner : facet.corners) {
          const Interval side = side_of(corners_, edge, corner[0], corner[1]);
          is_beyond =
              is_beyond && is_proved(less(is_positive_ ? side : -side, -Interval::exactly(distance) * lengths_[edge]));
        }
        if (is_beyond) return false;
      }
      return true;
    }
    /// By how much the heights of the facet's vertices differ from those of the simplex's plane, at most.
    [[nodiscard]] double farthest(const ShownFacet& facet) const {
      if (!is_thick_) return std::numeric_limits<double>::infinity();
      double result = 0;
      for (const auto& corner : facet.corners) {
        Interval height(0);
        for (std::size_t edge = 0; edge < 3; ++edge)
          height += side_of(corners_, edge, corner[0], corner[1]) / area_ * corners_[(edge + 2) % 3][2];
        result = std::max(result, absolute(corner[2] - height).upper());
      }
      return result;
    }

   private:
    std::array<std::array<Interval, 3>, 3> corners_;
    Interval area_;
    std::array<Interval, 3> lengths_;
    bool is_thick_ = false;
    bool is_positive_ = false;
  };

  static Interval closed_side(const Rational& half) {
    const double most = scalar_from<Interval>(half).upper();
    return Interval::between(-most, most);
  }

  /// r·ℓ/√3, where all matrices are within r of their middle: the function is a mean of (J_v − J̄)(x − p_v).
  static double height_by_slopes(const std::vector<Dense<Interval>>& matrices,
                                 std::span<const Interval* const> vertices) {
    Dense<Interval> middle(3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Interval all = matrices[0][axis];
      for (const Dense<Interval>& matrix : matrices) all = hull_of(all, matrix[axis]);
      middle[axis] = Interval::exactly(all.lower() + (all.upper() - all.lower()) / 2);
    }
    double radius = 0;
    for (const Dense<Interval>& matrix : matrices) {
      Interval squared(0);
      for (std::size_t axis = 0; axis < 3; ++axis) squared += square(matrix[axis] - middle[axis]);
      radius = std::max(radius, square_root(squared).upper());
    }
    double longest = 0;
    for (std::size_t v = 0; v < 3; ++v) {
      Interval squared(0);
      for (std::size_t axis = 0; axis < 3; ++axis) squared += square(vertices[v][axis] - vertices[(v + 1) % 3][axis]);
      longest = std::max(longest, squared.upper());
    }
    return (Interval::exactly(radius) * square_root(Interval::exactly(longest) / Interval(3))).upper();
  }

  template <class S>
  std::optional<std::vector<S>> heights_in(const TangentChart& chart, const EnclosedChart<S>& in, const S* y) {
    std::vector<std::uint32_t> facets;
    {
      const RoundingGuard guard;
      const std::array<Interval, 3> place{in_doubles_of(y[0]), in_doubles_of(y[1]), closed_side(chart.data().height)};
      visit_facets(mesh_, chart.enclosed(), place.data(), [&](std::uint32_t facet) {
        const ShownFacet shown(mesh_, chart.enclosed(), facet);
        if (is_refuted(is_zero(shown.normal[2])) && !shown.is_certainly_not_over(place[0], place[1]))
          facets.push_back(facet);
      });
    }
    std::optional<S> result;
    for (const std::uint32_t facet : facets) {
      std::array<std::array<S, 3>, 3> corners;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh_.mesh().triangles[facet][corner];
        std::array<S, 3> x;
        for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = scalar_from<S>(mesh_.mesh().points[vertex][axis]);
        for (std::size_t k = 0; k < 3; ++k) corners[corner][k] = in.coordinate(x.data(), k);
      }
      const std::array<S, 3> normal = normal_of(corners);
      bool is_over = true;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        if (is_proved(less(side_of(corners, edge, y[0], y[1]) * normal[2], S(0)))) is_over = false;
      }
      if (!is_over) continue;
      const S height =
          corners[0][2] - (normal[0] * (y[0] - corners[0][0]) + normal[1] * (y[1] - corners[0][1])) / normal[2];
      result = result ? hull_of(*result, height) : height;
    }
    if (!result) return std::nullopt;
    return std::vector<S>{*result};
  }

  const PolyhedralMesh& mesh_;
};

}  // namespace

std::unique_ptr<GraphEvaluation> mesh_evaluation(const PolyhedralMesh& mesh) {
  return std::make_unique<MeshEvaluation>(mesh);
}

}  // namespace delcert
