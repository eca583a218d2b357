#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "kernel/manifold/submanifold/chord_bend.hpp"
#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "kernel/number/elementary.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Place = std::array<double, 3>;

std::string facet_text(const TriangleMesh& mesh, std::uint32_t facet) {
  const auto& [a, b, c] = mesh.triangles[facet];
  return "facet " + std::to_string(facet) + " (vertices " + std::to_string(a) + " " + std::to_string(b) + " " +
         std::to_string(c) + ")";
}

bool has_area(const TriangleMesh& mesh, std::uint32_t facet) {
  std::array<std::vector<Rational>, 2> edges;
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      edges[k].push_back(mesh.points[mesh.triangles[facet][k + 1]][axis] - mesh.points[mesh.triangles[facet][0]][axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    if (edges[0][axis] * edges[1][next] != edges[0][next] * edges[1][axis]) return true;
  }
  return false;
}

/// Rule mesh.closed; gives neighbours.
std::vector<std::array<std::uint32_t, 3>> closed(const std::string& name, const TriangleMesh& mesh) {
  const auto refuse = [&](const std::string& reason) { throw Rejection(name + ": " + reason); };
  struct Side {
    std::uint32_t facet;
    std::size_t edge;
    bool is_forward;
  };
  std::map<std::array<std::uint32_t, 2>, std::vector<Side>> sides;
  for (std::uint32_t facet = 0; facet < mesh.triangles.size(); ++facet) {
    if (!has_area(mesh, facet))
      refuse(facet_text(mesh, facet) + " has no area: collapse one of its edges, or flip the longest");
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t from = mesh.triangles[facet][edge];
      const std::uint32_t to = mesh.triangles[facet][(edge + 1) % 3];
      sides[{std::min(from, to), std::max(from, to)}].push_back({facet, edge, from < to});
    }
  }
  std::vector<std::array<std::uint32_t, 3>> result(mesh.triangles.size());
  for (const auto& [ends, facets] : sides) {
    const std::string edge = "the edge of vertices " + std::to_string(ends[0]) + " and " + std::to_string(ends[1]);
    if (facets.size() == 1) {
      refuse(edge + " is in " + facet_text(mesh, facets[0].facet) +
             " only: close the boundary, or, if it is a crack, merge the vertices along it");
    }
    if (facets.size() > 2)
      refuse(edge + " is in " + std::to_string(facets.size()) +
             " facets, where there should be two: " + facet_text(mesh, facets[0].facet) + ", " +
             facet_text(mesh, facets[1].facet) + ", " + facet_text(mesh, facets[2].facet));
    if (facets[0].is_forward == facets[1].is_forward)
      refuse(edge + " has the same direction in " + facet_text(mesh, facets[0].facet) + " and " +
             facet_text(mesh, facets[1].facet) + ": reverse one of them, so that all facets show the same side");
    result[facets[0].facet].at(facets[0].edge) = facets[1].facet;
    result[facets[1].facet].at(facets[1].edge) = facets[0].facet;
  }
  return result;
}

std::vector<Interval> enclosed_points(const TriangleMesh& mesh) {
  const RoundingGuard guard;
  std::vector<Interval> result;
  for (const auto& point : mesh.points) {
    for (const Rational& x : point) result.push_back(scalar_from<Interval>(x));
  }
  return result;
}

std::vector<SpaceBox> boxes_of(const TriangleMesh& mesh, const std::vector<Interval>& places) {
  std::vector<SpaceBox> result;
  for (const auto& triangle : mesh.triangles) {
    SpaceBox& box = result.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::numeric_limits<double>::infinity();
      box.upper[axis] = -box.lower[axis];
      for (const std::uint32_t vertex : triangle) {
        const Interval& x = places[3 * std::size_t{vertex} + axis];
        box.lower[axis] = std::min(box.lower[axis], x.lower());
        box.upper[axis] = std::max(box.upper[axis], x.upper());
      }
    }
  }
  return result;
}

std::vector<std::array<Rational, 2>> box_around(const TriangleMesh& mesh) {
  std::vector<std::array<Rational, 2>> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rational least = mesh.points[0][axis];
    Rational greatest = least;
    for (const auto& point : mesh.points) {
      least = std::min(least, point[axis]);
      greatest = std::max(greatest, point[axis]);
    }
    const Rational room = (greatest - least) * Rational::power_of_two(-4) + Rational::power_of_two(-20);
    result.push_back({least - room, greatest + room});
  }
  return result;
}

BigInterval hull_of(const BigInterval& a, const BigInterval& b) { return hull(a, b); }
Interval hull_of(const Interval& a, const Interval& b) {
  return Interval::between(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
}
Rational hull_of(const Rational& a, const Rational&) { return a; }

Interval in_doubles_of(const Interval& x) { return x; }
Interval in_doubles_of(const BigInterval& x) { return in_doubles(x); }
Interval in_doubles_of(const Rational& x) { return scalar_from<Interval>(x); }

/// Minors of two edges.
template <class S>
std::array<S, 3> normal_of(const std::array<std::array<S, 3>, 3>& corners) {
  std::array<S, 3> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t one = (axis + 1) % 3;
    const std::size_t other = (axis + 2) % 3;
    result[axis] = (corners[1][one] - corners[0][one]) * (corners[2][other] - corners[0][other]) -
                   (corners[1][other] - corners[0][other]) * (corners[2][one] - corners[0][one]);
  }
  return result;
}

template <class S>
S side_of(const std::array<std::array<S, 3>, 3>& corners, std::size_t edge, const S& x, const S& y) {
  const auto& from = corners[edge];
  const auto& to = corners[(edge + 1) % 3];
  return (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]);
}

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

Place middle_place(const Interval* x) {
  return {x[0].lower() / 2 + x[0].upper() / 2, x[1].lower() / 2 + x[1].upper() / 2,
          x[2].lower() / 2 + x[2].upper() / 2};
}
Place difference_of(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double product_of(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double cosine_between(const PolyhedralMesh& mesh, std::uint32_t one, std::uint32_t other) {
  const auto normal = [&](std::uint32_t facet) {
    std::array<std::array<double, 3>, 2> edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 2; ++k)
        edge[k][axis] = mesh.point(facet, k + 1)[axis].lower() - mesh.point(facet, 0)[axis].lower();
    }
    return std::array{edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1],
                      edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2],
                      edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]};
  };
  const auto a = normal(one);
  const auto b = normal(other);
  const auto product = [](const auto& x, const auto& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  return product(a, b) / std::sqrt(product(a, a) * product(b, b));
}

class MeshSampler final : public ManifoldSampler {
 public:
  MeshSampler(const PolyhedralMesh& mesh, double radius) : mesh_(mesh), radius_(radius) {
    double sum = 0;
    for (std::uint32_t facet = 0; facet < mesh.mesh().triangles.size(); ++facet) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        corners_[corner].push_back(middle_place(mesh.point(facet, corner)));
      const Place normal = normal_at(facet);
      sum += std::sqrt(product_of(normal, normal));
      areas_.push_back(sum);
    }
  }

  std::vector<double> dart(CounterRandom& random) override {
    const double share = random.next_unit() * areas_.back();
    const auto found = std::upper_bound(areas_.begin(), areas_.end(), share);
    const auto facet = static_cast<std::size_t>(std::min(found, areas_.end() - 1) - areas_.begin());
    double a = random.next_unit();
    double b = random.next_unit();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    std::vector<double> x;
    for (std::size_t axis = 0; axis < 3; ++axis)
      x.push_back((1 - a - b) * corners_[0][facet][axis] + a * corners_[1][facet][axis] + b * corners_[2][facet][axis]);
    return x;
  }

  /// Along the normal column to the nearest place; without a frame x is on M.
  bool project(std::vector<double>& x, const Dense<double>* frame) override {
    if (frame == nullptr) return true;
    const Place origin{x[0], x[1], x[2]};
    const Place along{(*frame)[2], (*frame)[5], (*frame)[8]};
    double nearest = std::numeric_limits<double>::infinity();
    mesh_.tree().visit(
        [&](const SpaceBox& box) { return distance_squared(box, origin) <= 16 * radius_ * radius_; },
        [&](std::uint32_t facet) {
          const Place normal = normal_at(facet);
          const double rise = product_of(normal, along);
          if (rise == 0) return;
          const double t = product_of(normal, difference_of(corners_[0][facet], origin)) / rise;
          if (!(std::fabs(t) < std::fabs(nearest))) return;
          const Place at{origin[0] + t * along[0], origin[1] + t * along[1], origin[2] + t * along[2]};
          for (std::size_t edge = 0; edge < 3; ++edge) {
            const Place& from = corners_[edge][facet];
            const Place side = difference_of(corners_[(edge + 1) % 3][facet], from);
            if (product_of(cross(side, difference_of(at, from)), normal) < -0x1p-40 * product_of(normal, normal))
              return;
          }
          nearest = t;
        });
    if (!std::isfinite(nearest)) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += nearest * along[axis];
    return true;
  }

  std::string advice(const std::vector<double>& point) override {
    const Place x{point[0], point[1], point[2]};
    std::uint32_t nearest = 0;
    for (std::uint32_t facet = 1; facet < areas_.size(); ++facet) {
      if (distance_to(facet, x) < distance_to(nearest, x)) nearest = facet;
    }
    return mesh_.crease_near(nearest);
  }

  /// The mean normal of what is near, as far as it shows the same side as the nearest facet.
  std::optional<Dense<double>> normals(const std::vector<double>& point) override {
    const Place x{point[0], point[1], point[2]};
    std::vector<std::uint32_t> near;
    double reach = radius_ / 2;
    for (int round = 0; near.empty() && round < 60; ++round, reach *= 2) {
      mesh_.tree().visit([&](const SpaceBox& box) { return distance_squared(box, x) <= reach * reach; },
                         [&](std::uint32_t facet) { near.push_back(facet); });
    }
    std::sort(near.begin(), near.end());
    double least = std::numeric_limits<double>::infinity();
    Place first{};
    for (const std::uint32_t facet : near) {
      const double distance = distance_to(facet, x);
      if (distance < least) {
        least = distance;
        first = normal_at(facet);
      }
    }
    Dense<double> result(3, 0);
    for (const std::uint32_t facet : near) {
      const Place normal = normal_at(facet);
      const double cosine =
          product_of(normal, first) / std::sqrt(product_of(normal, normal) * product_of(first, first));
      if (!(cosine > 0.5)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) result[axis] += normal[axis];
    }
    const double length = std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    for (double& entry : result) entry /= length;
    return result;
  }

 private:
  static Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[nodiscard]] Place normal_at(std::uint32_t facet) const {
    return cross(difference_of(corners_[1][facet], corners_[0][facet]),
                 difference_of(corners_[2][facet], corners_[0][facet]));
  }
  static double distance_squared(const SpaceBox& box, const Place& x) {
    double result = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = std::max({box.lower[axis] - x[axis], x[axis] - box.upper[axis], 0.0});
      result += away * away;
    }
    return result;
  }
  /// Squared, of x to the facet.
  [[nodiscard]] double distance_to(std::uint32_t facet, const Place& x) const {
    const Place normal = normal_at(facet);
    bool is_over = true;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const Place& from = corners_[edge][facet];
      const Place side = difference_of(corners_[(edge + 1) % 3][facet], from);
      const Place offset = difference_of(x, from);
      if (product_of(cross(side, offset), normal) < 0) is_over = false;
      const double t = std::clamp(product_of(offset, side) / product_of(side, side), 0.0, 1.0);
      const Place rest{offset[0] - t * side[0], offset[1] - t * side[1], offset[2] - t * side[2]};
      least = std::min(least, product_of(rest, rest));
    }
    if (!is_over) return least;
    const double height = product_of(difference_of(x, corners_[0][facet]), normal);
    return height * height / product_of(normal, normal);
  }

  const PolyhedralMesh& mesh_;
  double radius_;
  std::array<std::vector<Place>, 3> corners_;
  std::vector<double> areas_;  // sums
};

}  // namespace

PolyhedralMesh::PolyhedralMesh(std::string name, TriangleMesh mesh, std::vector<std::string> homology)
    : name_(std::move(name)),
      mesh_(std::move(mesh)),
      homology_(std::move(homology)),
      neighbours_(closed(name_, mesh_)),
      places_(enclosed_points(mesh_)),
      box_(box_around(mesh_)),
      tree_(boxes_of(mesh_, places_)) {}

std::unique_ptr<GraphEvaluation> PolyhedralMesh::evaluation() const { return std::make_unique<MeshEvaluation>(*this); }

std::unique_ptr<ManifoldSampler> PolyhedralMesh::sampler(double radius) const {
  return std::make_unique<MeshSampler>(*this, radius);
}

std::string PolyhedralMesh::crease_near(std::uint32_t facet) const {
  constexpr std::size_t most_looked_at = 200;
  std::vector<std::uint32_t> around{facet};
  double least = 1;
  std::array<std::uint32_t, 2> sharpest{};
  for (std::size_t at = 0; at < around.size() && around.size() < most_looked_at; ++at) {
    for (const std::uint32_t other : neighbours(around[at])) {
      const double cosine = cosine_between(*this, around[at], other);
      if (cosine < least) {
        least = cosine;
        sharpest = {around[at], other};
      }
      if (std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
    }
  }
  char cosine[32];
  std::snprintf(cosine, sizeof cosine, "%.3f", least);
  return "the sharpest crease near by is between the facets " + std::to_string(std::min(sharpest[0], sharpest[1])) +
         " and " + std::to_string(std::max(sharpest[0], sharpest[1])) + ", whose normals have the cosine " + cosine +
         ": smooth the mesh there, or, if it is only curved, take a smaller sampling radius";
}

ShownFacet::ShownFacet(const PolyhedralMesh& mesh, const EnclosedChart<Interval>& chart, std::uint32_t facet) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t k = 0; k < 3; ++k) corners[corner][k] = chart.coordinate(mesh.point(facet, corner), k);
  }
  normal = normal_of(corners);
}

Interval ShownFacet::side(std::size_t edge, const Interval& x, const Interval& y) const {
  return side_of(corners, edge, x, y);
}

bool ShownFacet::is_certainly_not_over(const Interval& x, const Interval& y) const {
  const bool is_up = is_proved(less(Interval(0), normal[2]));
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Interval beyond = side(edge, x, y);
    if (is_up ? is_proved(less(beyond, Interval(0))) : is_proved(less(Interval(0), beyond))) return true;
  }
  return false;
}

}  // namespace delcert
