#pragma once

#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {

/// A mesh M in space, q = 1, as tangent charts show it. Its rules are decided exactly.
class Polyhedron {
 public:
  explicit Polyhedron(const TangentCharts& charts);

  /// mesh.closed.
  void check_closed(Report& report) const;
  /// sub.graph. Precondition of what follows: it holds for label i.
  void check_graph(Label i, Report& report);
  /// sub.cover; gives the number of parts.
  std::size_t check_cover(Report& report) const;

  /// No point of M over the disc is as high as this, or has a height between it and that of the patch.
  double lid(Label i) const { return lid_[i]; }
  /// The height of M over the home coordinates of label i, in its chart.
  template <class N>
  N home_height(Label i, const TangentChart<N>& chart) const {
    return height_in(placed_in(home_[i], chart), chart.home[0], chart.home[1]);
  }
  /// The height of M over a place, enclosed, where it is known to be within `reach` of a guess.
  Interval height_over(Label i, const Matrix<Interval>& place, const Interval& guess, double reach) const;

  /// How slopes of M change along segments of chart i, over the places as near to that of a point of M as this: by a
  /// function with the Lipschitz constant `rate` and one that is nowhere greater than `size`.
  struct Change {
    double rate = 0, size = 0;
  };
  Change slope_change(Label i, const Matrix<Interval>& point, double wide) const;

  /// What rules 5.* ask of the function of chart i, the height above M over Y_i, near a simplex.
  struct Hull {
    std::vector<Matrix<Interval>> slopes;  // its differences are convex combinations of these
    double height = 0;                     // what it is at most on the simplex
  };
  Hull hull(Label i, std::size_t s, double displacement) const;

 private:
  template <class N>
  using Corners = std::array<std::array<N, 3>, 3>;  // coordinates in the chart, the last the height

  template <class N>
  static std::array<N, 3> normal_of(const Corners<N>& a) {
    std::array<N, 3> result{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, j = (k + 2) % 3;
      result[k] = (a[1][l] - a[0][l]) * (a[2][j] - a[0][j]) - (a[1][j] - a[0][j]) * (a[2][l] - a[0][l]);
    }
    return result;
  }
  /// Twice the area of an edge of the projection and a place.
  template <class N>
  static N side_of(const Corners<N>& a, std::size_t edge, const N& x, const N& y) {
    const std::array<N, 3>&from = a[edge], &to = a[(edge + 1) % 3];
    return (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]);
  }
  template <class N>
  static N height_in(const Corners<N>& a, const N& x, const N& y) {
    const std::array<N, 3> normal = normal_of(a);
    return a[0][2] - (normal[0] * (x - a[0][0]) + normal[1] * (y - a[0][1])) / normal[2];
  }
  template <class N>
  Corners<N> placed_in(std::uint32_t facet, const TangentChart<N>& chart) const {
    Corners<N> result{};
    for (std::size_t v = 0; v < 3; ++v) {
      const std::uint32_t vertex = M_.facets[facet][v];
      Matrix<N> offset;
      if constexpr (std::is_same_v<N, Interval>) {
        offset = vertices_[vertex] - chart.centre;
      } else {
        offset = as_numbers<N>(M_.vertices[vertex]) - chart.centre;
      }
      const Matrix<N> along = transposed_times(chart.tangent, offset), up = transposed_times(chart.normal, offset);
      result[v] = {along[0], along[1], up[0]};
    }
    return result;
  }
  /// A facet in chart i, with what intervals know of it.
  struct Placed {
    std::uint32_t facet;
    Corners<Interval> filter;
  };
  template <class N>
  Corners<N> corners(Label i, const Placed& placed) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return placed.filter;
    } else {
      return placed_in(placed.facet, exact_chart(i));
    }
  }
  const TangentChart<Rational>& exact_chart(Label i) const;
  bool misses_disc(Label i, const Placed& placed) const;
  bool is_beyond_lid(Label i, const Placed& placed) const;
  bool is_below_lid(Label i, const Placed& placed) const;
  /// 1, -1, or 0 if the facet is vertical.
  int sign(Label i, const Placed& placed) const;
  bool is_flat(Label i, const Placed& placed) const;
  enum class Position { inside, rim, outside };
  Position position(Label i, const Placed& placed, const Quantity& x, const Quantity& y) const;
  void find_place(Label i, const std::vector<Placed>& sheet, Report& report) const;
  bool is_in(Label i, const Matrix<Interval>& x, Verdict& all) const;

  const TangentCharts& charts_;
  const Submanifold& M_;
  std::vector<Matrix<Interval>> vertices_;
  NearPoints near_facets_;
  double facet_radius_ = 0;  // of a ball about the barycentre
  std::vector<double> lid_;
  std::vector<std::uint32_t> home_;
  mutable Label exact_label_ = 0;
  mutable std::unique_ptr<TangentChart<Rational>> exact_;
};

}  // namespace delcert::checker
