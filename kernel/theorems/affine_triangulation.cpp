#include "kernel/theorems/affine_triangulation.hpp"

#include <algorithm>
#include <limits>

namespace delcert {

namespace {

/// The simplex as star(j) would list it, j one of its others: seen from there.
template <int m>
ChartSimplex<m> seen_from(Label i, const ChartSimplex<m>& others, std::size_t j) {
  ChartSimplex<m> result = others;
  for (std::size_t at = 0; at < m; ++at) {
    const Shift<m> here = at == j ? Shift<m>{} : others[at].shift;
    result[at] = {at == j ? i.value : others[at].index, difference_of<m>(here, others[j].shift)};
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The edges from the first label, in coordinates of the torus.
template <int m>
Matrix<Interval, m> edges_from(const std::vector<Vector<Interval, m>>& positions, Label i,
                               const ChartSimplex<m>& others) {
  Matrix<Interval, m> edges;
  for (std::size_t at = 0; at < m; ++at) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      edges[at][axis] = positions[others[at].index][axis] - positions[i.value][axis] + Interval(others[at].shift[axis]);
    }
  }
  return edges;
}

/// A lower bound of the square of the longest edge, in the form of a chart.
template <int m>
double longest_squared(const Matrix<Interval, m>& edges, const Matrix<Interval, m>& gram) {
  double longest = 0;
  const auto look_at = [&](const Vector<Interval, m>& edge) {
    Interval squared(0);
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) squared += gram[row][column] * edge[row] * edge[column];
    }
    longest = std::max(longest, squared.lower());
  };
  for (std::size_t at = 0; at < m; ++at) {
    look_at(edges[at]);
    for (std::size_t other = 0; other < at; ++other) look_at(difference(edges[at], edges[other]));
  }
  return longest;
}

/// |det|.
template <int m>
Interval volume(const Matrix<Interval, m>& edges) {
  if constexpr (m == 2) {
    return absolute(edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]);
  } else {
    Matrix<Interval, m> rest = edges;
    std::rotate(rest.begin(), rest.begin() + 1, rest.end());
    return absolute(pairing(wedge<Interval, m>(rest), edges[0]));
  }
}

}  // namespace

template <int m>
AffineTriangulationReport check_affine_triangulation(const MetricFieldAtlas<m>& atlas, const PointSet<m>& points,
                                                     const ChartComplex<m>& complex) {
  AffineTriangulationReport result;
  std::vector<Vector<Interval, m>> positions(atlas.size());
  const RoundingGuard guard;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    const Vector<Rational, m> x = atlas.position(i, points.exact(i));
    for (std::size_t axis = 0; axis < m; ++axis) positions[index][axis] = scalar_from<Interval>(x[axis]);
  }
  Interval total(0);
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    for (const ChartSimplex<m>& others : complex.chart_star(i).simplices) {
      ++result.listed;
      const Matrix<Interval, m> edges = edges_from<m>(positions, i, others);
      least = std::min(least, longest_squared<m>(edges, atlas.enclosed_gram(i)));
      for (std::size_t at = 0; at < m; ++at) {
        const auto& star = complex.chart_star(label_of<m>(others[at])).simplices;
        if (std::binary_search(star.begin(), star.end(), seen_from<m>(i, others, at))) continue;
        ++result.other_lifts;
        break;
      }
      const bool is_first = std::all_of(others.begin(), others.end(), [&](const auto& o) { return o.index > index; });
      if (is_first) total += volume<m>(edges);
    }
  }
  const Interval sheets = total / Interval(m == 2 ? 2 : 6);
  result.least_sheets = sheets.lower();
  result.most_sheets = sheets.upper();
  if (result.listed > 0) result.edge = square_root(Interval::exactly(least)).lower();
  return result;
}

template AffineTriangulationReport check_affine_triangulation<2>(const MetricFieldAtlas<2>&, const PointSet<2>&,
                                                                 const ChartComplex<2>&);
template AffineTriangulationReport check_affine_triangulation<3>(const MetricFieldAtlas<3>&, const PointSet<3>&,
                                                                 const ChartComplex<3>&);

}  // namespace delcert
