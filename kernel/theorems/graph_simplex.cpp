#include "kernel/theorems/graph_simplex.hpp"

#include <algorithm>
#include <limits>

namespace delcert {

namespace {

constexpr std::size_t most_entries = 81;
// A little less than 1: what is claimed has room for readers whose enclosures are wider.
constexpr double greatest_contraction = 0.98;

Interval norm_of(std::span<const Interval> entries) {
  Interval squared(0);
  for (const Interval& entry : entries) squared += square(entry);
  return square_root(squared);
}

Interval norm_of_difference(const Interval* a, const Interval* b, std::size_t count) {
  Interval squared(0);
  for (std::size_t k = 0; k < count; ++k) squared += square(a[k] - b[k]);
  return square_root(squared);
}

double middle_of(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }

Interval point_in(const Interval& x) { return Interval::exactly(middle_of(x)); }

}  // namespace

const char* description_of(GraphCause cause) {
  switch (cause) {
    case GraphCause::undefined:
      return "the equations or their derivatives are not certainly defined around it";
    case GraphCause::outside:
      return "it is not certainly in the cylinders of its labels";
    case GraphCause::fibre:
      return "fibres across it are not certainly transversal to the manifold";
    case GraphCause::displacement:
      return "the manifold is not certainly within the displacement of it";
    case GraphCause::degenerate:
      return "it is not certainly a simplex in the chart of one of its labels";
    default:
      return "the map to the manifold is not certainly near the identity in the chart of one of its labels";
  }
}

template <int m>
GraphSimplexCheck<m>::GraphSimplexCheck(const GraphVertices& vertices)
    : vertices_(vertices),
      n_(vertices.zero_set.ambient()),
      q_(vertices.zero_set.codimension()),
      evaluation_(vertices.zero_set.map()),
      box_(n_),
      middle_(n_),
      f_(q_),
      at_middle_(q_ * n_),
      first_(q_ * n_),
      second_(q_ * n_ * n_),
      derivatives_((m + 1) * q_ * n_),
      fibres_((m + 1) * q_ * n_) {}

template <int m>
void GraphSimplexCheck<m>::fibre(std::uint32_t v, Interval* w) const {
  const EnclosedChart<Interval>& chart = vertices_.charts[v].enclosed();
  for (std::size_t axis = 0; axis < n_; ++axis) {
    for (std::size_t column = 0; column < q_; ++column) {
      Interval sum(0);
      for (std::size_t k = 0; k < q_; ++k) sum += chart.at(axis, m + k) * chart.preconditioner[k * q_ + column];
      w[axis * q_ + column] = sum;
    }
  }
}

template <int m>
double GraphSimplexCheck<m>::lateral(std::uint32_t i, std::uint32_t v) const {
  std::array<Interval, most_entries> w;
  fibre(v, w.data());
  const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
  Interval squared(0);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < q_; ++column) {
      Interval sum(0);
      for (std::size_t axis = 0; axis < n_; ++axis) sum += chart.at(axis, row) * w[axis * q_ + column];
      squared += square(sum);
    }
  }
  return square_root(squared).upper();
}

template <int m>
std::optional<typename GraphSimplexCheck<m>::Gradients> GraphSimplexCheck<m>::gradients(
    std::uint32_t i, const LabelSimplex<m>& simplex) const {
  const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
  std::array<Vector<Interval, m>, static_cast<std::size_t>(m)> edges;
  const Interval* origin = vertices_.position(simplex[0]);
  for (std::size_t k = 0; k < m; ++k) {
    const Interval* end = vertices_.position(simplex[k + 1]);
    for (std::size_t row = 0; row < m; ++row) {
      Interval sum(0);
      for (std::size_t axis = 0; axis < n_; ++axis) sum += chart.at(axis, row) * (end[axis] - origin[axis]);
      edges[k][row] = sum;
    }
  }
  Gradients result;
  for (std::size_t k = 0; k < m; ++k) {
    std::array<Vector<Interval, m>, static_cast<std::size_t>(m)> others = edges;
    std::rotate(others.begin() + static_cast<std::ptrdiff_t>(k), others.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                others.end());
    const Vector<Interval, m> normal = wedge<Interval, m>(others);
    const Interval height = pairing(normal, edges[k]);
    if (!is_refuted(is_zero(height))) return std::nullopt;
    for (std::size_t row = 0; row < m; ++row) {
      result[k + 1][row] = normal[row] / height;
      result[0][row] -= result[k + 1][row];
    }
  }
  return result;
}

/// J at each vertex p′_v, Df(x̄) + D²f·(p′_v − x̄): on the simplex J is a convex combination of such.
template <int m>
bool GraphSimplexCheck<m>::enclose_derivatives(const LabelSimplex<m>& simplex, double displacement) {
  const Interval around = Interval::between(-displacement, displacement);
  for (std::size_t axis = 0; axis < n_; ++axis) {
    Interval hull = vertices_.position(simplex[0])[axis];
    for (std::size_t v = 1; v <= m; ++v) {
      const Interval& x = vertices_.position(simplex[v])[axis];
      hull = Interval::between(std::min(hull.lower(), x.lower()), std::max(hull.upper(), x.upper()));
    }
    middle_[axis] = point_in(hull);
    box_[axis] = hull + around;
  }
  if (!evaluation_.first(middle_.data(), f_.data(), at_middle_.data())) return false;
  if (!evaluation_.second(box_.data(), f_.data(), first_.data(), second_.data())) return false;
  for (std::size_t v = 0; v <= m; ++v) {
    const Interval* x = vertices_.position(simplex[v]);
    fibre(simplex[v], &fibres_[v * n_ * q_]);
    for (std::size_t row = 0; row < q_ * n_; ++row) {
      Interval sum = at_middle_[row];
      for (std::size_t axis = 0; axis < n_; ++axis) sum += second_[row * n_ + axis] * (x[axis] - middle_[axis]);
      derivatives_[v * q_ * n_ + row] = sum;
    }
  }
  spread_ = norm_of(second_) * Interval::exactly(displacement);
  return true;
}

/// ‖1 − J_v·W_w‖ with all that J may be nearby.
template <int m>
double GraphSimplexCheck<m>::defect(std::size_t v, std::size_t w) const {
  const Interval* j = &derivatives_[v * q_ * n_];
  const Interval* fibre = &fibres_[w * n_ * q_];
  Interval squared(0);
  for (std::size_t row = 0; row < q_; ++row) {
    for (std::size_t column = 0; column < q_; ++column) {
      Interval sum(row == column ? 1 : 0);
      for (std::size_t axis = 0; axis < n_; ++axis) sum -= j[row * n_ + axis] * fibre[axis * q_ + column];
      squared += square(sum);
    }
  }
  return (square_root(squared) + spread_ * norm_of({fibre, n_ * q_})).upper();
}

/// s_σ: sup|f| on σ over 1 − θ. f is at most m/(4(m + 1))·(max |Ā[e,e]| + ‖rad A‖·ℓ²) where it is 0 at the vertices, A
/// = D²f.
template <int m>
Interval GraphSimplexCheck<m>::shift_of(const LabelSimplex<m>& simplex, const Interval& edge_squared,
                                        const Interval& theta) const {
  Interval deviation_squared(0);
  for (const Interval& entry : second_) deviation_squared += square(entry - point_in(entry));
  double bent = 0;
  for (std::size_t v = 0; v <= m; ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      std::array<Interval, 9> edge;
      for (std::size_t axis = 0; axis < n_; ++axis)
        edge[axis] = vertices_.position(simplex[v])[axis] - vertices_.position(simplex[w])[axis];
      Interval squared(0);
      for (std::size_t k = 0; k < q_; ++k) {
        Interval value(0);
        for (std::size_t row = 0; row < n_; ++row) {
          Interval sum(0);
          for (std::size_t axis = 0; axis < n_; ++axis)
            sum += point_in(second_[(k * n_ + row) * n_ + axis]) * edge[axis];
          value += edge[row] * sum;
        }
        squared += square(value);
      }
      bent = std::max(bent, square_root(squared).upper());
    }
  }
  double residual = 0;
  for (const std::uint32_t label : simplex) residual = std::max(residual, vertices_.residual(label));
  const Interval curved = Interval::exactly(bent) + square_root(deviation_squared) * edge_squared;
  return (curved * Interval(m) / Interval(4 * (m + 1)) + Interval::exactly(residual)) / (Interval(1) - theta);
}

template <int m>
std::array<bool, 2> GraphSimplexCheck<m>::lies_inside(const LabelSimplex<m>& simplex, double displacement) const {
  std::array<bool, 2> result{true, true};
  const Interval around = Interval::exactly(displacement);
  for (const std::uint32_t i : simplex) {
    const ChartData& chart = vertices_.charts[i].data();
    const Interval radius = scalar_from<Interval>(chart.radius);
    const Interval height = scalar_from<Interval>(chart.height);
    for (const std::uint32_t v : simplex) {
      Interval squared(0);
      for (std::size_t column = 0; column < m; ++column) squared += square(coordinate(i, v, column));
      if (!is_proved(less(square_root(squared) + around, radius))) result[0] = false;
      for (std::size_t column = m; column < n_; ++column) {
        const Interval size = absolute(coordinate(i, v, column));
        if (!is_proved(less(size + around, height))) result[0] = false;
        if (!is_proved(less(size + Interval(3) * around, height))) result[1] = false;
      }
    }
  }
  return result;
}

/// sup ‖(J·N)⁻¹·J·E‖ ≤ ‖Y·J·E‖/(1 − ‖1 − Y·J·N‖).
template <int m>
double GraphSimplexCheck<m>::steepness(std::uint32_t i) const {
  const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
  const Interval spread = spread_ * norm_of({chart.preconditioner.data(), q_ * q_});
  double result = 0;
  for (std::size_t v = 0; v <= m; ++v) {
    const Interval* j = &derivatives_[v * q_ * n_];
    Interval along(0);
    Interval defect(0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < n_; ++column) {
        Interval entry(column >= m && column - m == row ? -1 : 0);
        for (std::size_t b = 0; b < q_; ++b) {
          Interval sum(0);
          for (std::size_t axis = 0; axis < n_; ++axis) sum += j[b * n_ + axis] * chart.at(axis, column);
          entry += chart.preconditioner[row * q_ + b] * sum;
        }
        (column < m ? along : defect) += square(entry);
      }
    }
    const Interval rest = Interval(1) - square_root(defect) - spread;
    if (!is_proved(less(Interval(0), rest))) return std::numeric_limits<double>::infinity();
    result = std::max(result, ((square_root(along) + spread) / rest).upper());
  }
  return result;
}

/// γ, and how distances and planes change.
template <int m>
std::optional<double> GraphSimplexCheck<m>::contraction(std::size_t at, const LabelSimplex<m>& simplex,
                                                        const Gradients& gradients, const Interval& theta,
                                                        GraphSimplex<m>& measured) const {
  const Interval shift = Interval::exactly(measured.shift);
  double side = 0;
  for (const std::uint32_t v : simplex) side = std::max(side, lateral(simplex[at], v));
  // D·Y⁻¹, N×m.
  std::array<Interval, most_entries> lift;
  for (std::size_t axis = 0; axis < n_; ++axis) {
    for (std::size_t column = 0; column < m; ++column) {
      Interval sum(0);
      for (std::size_t k = 1; k <= m; ++k)
        sum += (vertices_.position(simplex[k])[axis] - vertices_.position(simplex[0])[axis]) * gradients[k][column];
      lift[axis * m + column] = sum;
    }
  }
  double slope = 0;
  double size = 0;
  for (std::size_t v = 0; v <= m; ++v) {
    const Interval* j = &derivatives_[v * q_ * n_];
    Interval squared(0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < m; ++column) {
        Interval sum(0);
        for (std::size_t axis = 0; axis < n_; ++axis) sum += j[row * n_ + axis] * lift[axis * m + column];
        squared += square(sum);
      }
    }
    slope = std::max(slope, square_root(squared).upper());
    size = std::max(size, norm_of({j, q_ * n_}).upper());
  }
  // The derivative of W along the chart, one N×q matrix for each of its axes.
  Interval turn_squared(0);
  for (std::size_t entry = 0; entry < n_ * q_; ++entry) {
    for (std::size_t column = 0; column < m; ++column) {
      Interval sum(0);
      for (std::size_t k = 1; k <= m; ++k)
        sum += (fibres_[k * n_ * q_ + entry] - fibres_[entry]) * gradients[k][column];
      turn_squared += square(sum);
    }
  }
  const Interval rest = Interval(1) - theta;
  const Interval sideways = Interval::exactly(side);
  const Interval stretch = norm_of({lift.data(), n_ * m});
  const Interval along = Interval::exactly(slope) + spread_ * stretch;
  const Interval across = Interval(1) + sideways * (Interval::exactly(size) + spread_) / rest;
  const double result = (sideways * along / rest + across * square_root(turn_squared) * shift).upper();
  if (!(result < greatest_contraction)) return std::nullopt;
  const Interval moved = Interval::exactly(result);
  // ‖D·Q⁻¹‖, of which the part in the plane of the chart is the identity.
  const Interval lifted = square_root(maximum(Interval(1), square(stretch) - Interval(m - 1)));
  measured.least_stretch = std::max(measured.least_stretch, ((Interval(1) - moved) / lifted).lower());
  const double steepest = steepness(simplex[at]);
  const Interval longer = (Interval(1) + moved) * square_root(Interval(1) + square(Interval::exactly(steepest)));
  measured.greatest_stretch = std::min(measured.greatest_stretch, longer.upper());
  double narrowest = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v <= m; ++v)
    narrowest = std::min(narrowest, norm_of({&fibres_[v * n_ * q_], n_ * q_}).upper());
  measured.normal = std::min(measured.normal, (Interval::exactly(narrowest) * along / rest).upper());
  return result;
}

template <int m>
GraphSimplex<m> GraphSimplexCheck<m>::measure(const LabelSimplex<m>& simplex, double displacement) {
  GraphSimplex<m> result;
  const auto fail = [&result](GraphCause cause) {
    if (!result.cause) result.cause = cause;
  };
  double edge = 0;
  for (std::size_t v = 0; v <= m; ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      const Interval length = norm_of_difference(vertices_.position(simplex[v]), vertices_.position(simplex[w]), n_);
      edge = std::max(edge, length.upper());
    }
  }
  result.edge = edge;
  if (!enclose_derivatives(simplex, displacement)) {
    fail(GraphCause::undefined);
    return result;
  }
  double most_defect = 0;
  double widest = 0;
  for (std::size_t w = 0; w <= m; ++w) {
    for (std::size_t v = 0; v <= m; ++v) most_defect = std::max(most_defect, defect(v, w));
    widest = std::max(widest, norm_of({&fibres_[w * n_ * q_], n_ * q_}).upper());
  }
  if (!(most_defect < 1)) {
    fail(GraphCause::fibre);
    return result;
  }
  const Interval theta = Interval::exactly(most_defect);
  const Interval shift = Interval::exactly(shift_of(simplex, square(Interval::exactly(edge)), theta).upper());
  result.shift = shift.upper();
  result.displacement = (Interval::exactly(widest) * shift).upper();
  const auto [is_inside, is_under_lid] = lies_inside(simplex, displacement);
  result.is_under_lid = is_under_lid;
  result.greatest_stretch = result.normal = std::numeric_limits<double>::infinity();
  if (!is_inside) fail(GraphCause::outside);
  if (!(result.displacement <= displacement)) fail(GraphCause::displacement);
  for (std::size_t at = 0; at <= m; ++at) {
    const auto gradient = gradients(simplex[at], simplex);
    if (!gradient) {
      fail(GraphCause::degenerate);
      continue;
    }
    result.altitudes[at] = (Interval(1) / norm_of((*gradient)[at])).lower();
    const auto found = contraction(at, simplex, *gradient, theta, result);
    if (found) {
      result.contraction = std::max(result.contraction, *found);
    } else {
      fail(GraphCause::contraction);
    }
  }
  return result;
}

template class GraphSimplexCheck<1>;
template class GraphSimplexCheck<2>;
template class GraphSimplexCheck<3>;

}  // namespace delcert
