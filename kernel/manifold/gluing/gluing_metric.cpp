#include "kernel/manifold/gluing/gluing_metric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delcert {

namespace {

template <std::size_t m>
std::array<std::array<double, m>, m> plain_inverse(const std::array<std::array<double, m>, m>& a) {
  std::array<std::array<double, m>, m> result;
  if constexpr (m == 2) {
    const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    result = {{{a[1][1] / determinant, -a[0][1] / determinant}, {-a[1][0] / determinant, a[0][0] / determinant}}};
  } else {
    static_assert(m == 3);
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        const std::size_t r1 = (column + 1) % m;
        const std::size_t r2 = (column + 2) % m;
        const std::size_t c1 = (row + 1) % m;
        const std::size_t c2 = (row + 2) % m;
        result[row][column] = a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1];
      }
    }
    const double determinant = a[0][0] * result[0][0] + a[0][1] * result[1][0] + a[0][2] * result[2][0];
    for (auto& row : result) {
      for (double& entry : row) entry /= determinant;
    }
  }
  return result;
}

}  // namespace

template <int m>
GluingMetric<m>::GluingMetric(const ChartGluing& gluing) : gluing_(gluing) {
  for (std::size_t t = 0; t < gluing.transitions().size(); ++t) {
    const ChartGluing::Transition& transition = gluing.transitions()[t];
    Link link{t, PiecewiseValues<double>(transition.pieces), {}, transition.pieces.front().positive().size()};
    for (const CellMap& piece : transition.pieces) {
      link.polynomials.emplace_back(piece.polynomials());
      values_.resize(std::max(values_.size(), piece.polynomials().function_count()));
    }
    links_.push_back(std::move(link));
  }
  for (std::size_t chart = 0; chart < gluing.chart_count(); ++chart) {
    Box box;
    for (std::size_t axis = 0; axis < m; ++axis) {
      box.lowest[axis] = approximate_double(gluing.chart(chart).domain[axis][0]);
      box.highest[axis] = approximate_double(gluing.chart(chart).domain[axis][1]);
    }
    boxes_.push_back(box);
  }
}

template <int m>
bool GluingMetric<m>::follow(Link& link, const Vector<double, m>& x, ChartPoint<m>& to) {
  if (link.conditions > 0) {
    FormulaEvaluation<double>& polynomials = link.polynomials[link.map.pieces_at(x.data()).front()];
    if (!polynomials.value(x.data(), values_.data())) return false;
    for (std::size_t k = 0; k < link.conditions; ++k) {
      if (!(values_[k] > 0)) return false;
    }
  }
  if (!link.map.value(x.data(), to.x.data())) return false;
  to.chart = gluing_.transitions()[link.transition].to;
  return weight(to) > 0;
}

template <int m>
double GluingMetric<m>::weight(const ChartPoint<m>& point) const {
  const Box& box = boxes_[point.chart];
  double result = 1;
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double half = (box.highest[axis] - box.lowest[axis]) / 2;
    const double t = (point.x[axis] - box.lowest[axis] - half) / half;
    if (!(t > -1 && t < 1)) return 0;
    result *= (1 - t * t) * (1 - t * t);
  }
  return result;
}

template <int m>
Matrix<double, m> GluingMetric<m>::inverse_at(const ChartPoint<m>& point) {
  double weights = weight(point);
  Matrix<double, m> result{};
  for (std::size_t axis = 0; axis < m; ++axis) result[axis][axis] = weights;
  for (Link& link : links_) {
    if (gluing_.transitions()[link.transition].from != point.chart) continue;
    ChartPoint<m> there;
    if (!follow(link, point.x, there)) continue;
    // D(τ⁻) at τ(x).
    Vector<double, m> back;
    std::array<double, static_cast<std::size_t>(m * m)> derivative;
    Link& opposite = links_[ChartGluing::opposite(link.transition)];
    if (!opposite.map.first(there.x.data(), back.data(), derivative.data())) continue;
    const double w = weight(there);
    weights += w;
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        for (std::size_t k = 0; k < m; ++k)
          result[row][column] += w * derivative[row * m + k] * derivative[column * m + k];
      }
    }
  }
  for (auto& row : result) {
    for (double& entry : row) entry /= weights;
  }
  return result;
}

template <int m>
Matrix<Interval, m> GluingMetric<m>::enclosed_at(const ChartPoint<m>& point) {
  const Matrix<double, m> gram = plain_inverse(inverse_at(point));
  Matrix<Interval, m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) result[row][column] = Interval::exactly(gram[row][column]);
  }
  return result;
}

template <int m>
std::vector<ChartPoint<m>> GluingMetric<m>::places_of(const ChartPoint<m>& point) {
  std::vector<ChartPoint<m>> result{point};
  for (Link& link : links_) {
    ChartPoint<m> there;
    if (gluing_.transitions()[link.transition].from == point.chart && follow(link, point.x, there))
      result.push_back(there);
  }
  return result;
}

template <int m>
double GluingMetric<m>::depth(const ChartPoint<m>& point) {
  const Matrix<double, m> inverse = inverse_at(point);
  const Box& box = boxes_[point.chart];
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double room = std::min(point.x[axis] - box.lowest[axis], box.highest[axis] - point.x[axis]);
    result = std::min(result, room / std::sqrt(inverse[axis][axis]));
  }
  return result;
}

template <int m>
ChartPoint<m> GluingMetric<m>::deepest_place_of(const ChartPoint<m>& point) {
  ChartPoint<m> best = point;
  double deepest = -1;
  for (const ChartPoint<m>& place : places_of(point)) {
    const double found = depth(place);
    if (found > deepest) best = place;
    deepest = std::max(deepest, found);
  }
  return best;
}

template class GluingMetric<2>;
template class GluingMetric<3>;

}  // namespace delcert
