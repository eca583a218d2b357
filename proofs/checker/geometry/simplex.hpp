#pragma once

#include <vector>

#include "proofs/checker/geometry/metric.hpp"

namespace delcert::checker {

/// A simplex of dimension 0 to m in R^m, built vertex by vertex: its circumcentre and an orthogonal basis of its
/// directions. All vectors are relative to the first vertex.
template <class N>
class Simplex {
 public:
  explicit Simplex(const Metric& metric) : metric_(&metric) {}
  /// Precondition: the vertices are not degenerate, or the filter does not know; `complete` tells which.
  Simplex(const Metric& metric, const std::vector<Vector<N>>& vertices) : metric_(&metric) {
    for (std::size_t k = 1; k < vertices.size() && complete == Verdict::proved; ++k)
      complete = add_vertex(vertices[k] - vertices[0]);
  }
  /// The enclosure of an exact simplex.
  explicit Simplex(const Simplex<Rational>& exact) requires std::is_same_v<N, Interval>
      : centre(enclosure(exact.centre)),
        radius_squared(enclosure(exact.radius_squared)),
        metric_(exact.metric_),
        edges_(exact.edges_) {
    for (std::size_t k = 0; k < edges_; ++k) {
      direction_[k] = enclosure(exact.direction_[k]);
      covector_[k] = enclosure(exact.covector_[k]);
    }
  }

  Verdict complete = Verdict::proved;  // refuted: the vertices given to the constructor are degenerate
  Vector<N> centre{};                  // the circumcentre
  N radius_squared{0};

  std::size_t dimension() const { return edges_; }

  /// x minus its projection to the directions of the simplex.
  Vector<N> perpendicular(const Vector<N>& x) const {
    Vector<N> u = x;
    for (std::size_t k = 0; k < edges_; ++k) u = add(u, -dot(x, covector_[k], m()), direction_[k]);
    return u;
  }

  /// |x - c|^2 - R^2 = |x|^2 - 2 <x, c>.
  N power(const Vector<N>& x) const { return metric_->squared_length(x) - N(2) * metric_->product(x, centre); }

  /// Adds the vertex at x, whose power is P: c' = c + s u with u = perpendicular(x) and 2 s |u|^2 = P, since c' is as
  /// far from x as from the first vertex. Refuted if x is in the affine hull; then, and if undecided, nothing changes.
  Verdict add_vertex(const Vector<N>& x) { return add_vertex(x, power(x)); }
  Verdict add_vertex(const Vector<N>& x, const N& power_of_x) {
    const Vector<N> u = perpendicular(x);
    const N height = metric_->squared_length(u);
    const Verdict positive = less(N(0), height);
    if (positive != Verdict::proved) return positive;
    const N inverse = N(1) / height, step = power_of_x * inverse / N(2);
    centre = add(centre, step, u);
    radius_squared = radius_squared + step * power_of_x / N(2);
    direction_[edges_] = u;
    covector_[edges_++] = add(Vector<N>{}, inverse, metric_->covector(u));
    return Verdict::proved;
  }

 private:
  friend class Simplex<Interval>;
  static Vector<Interval> enclosure(const Vector<Rational>& x) {
    using checker::enclosure;
    return {enclosure(x[0]), enclosure(x[1]), enclosure(x[2]), enclosure(x[3])};
  }
  static Interval enclosure(const Rational& x) { return checker::enclosure(x); }
  std::size_t m() const { return static_cast<std::size_t>(metric_->dimension()); }

  const Metric* metric_;
  std::size_t edges_ = 0;
  std::array<Vector<N>, 4> direction_{}, covector_{};  // u_k and G u_k / |u_k|^2
};

/// |q - C| > R + delta for the point at x from the first vertex: with P = |q - C|^2 - R^2 this is
/// P - delta^2 > sqrt(4 R^2 delta^2).
template <class N>
Verdict is_clear(const Simplex<N>& simplex, const Vector<N>& x, const N& delta) {
  return negation(at_most_root(simplex.power(x) - square(delta), N(4) * simplex.radius_squared * square(delta)));
}

/// |C| + R <= a.
template <class N>
Verdict is_ball_within(const N& centre_squared, const N& radius_squared, const N& a) {
  const N rest = square(a) - centre_squared - radius_squared;
  return conjunction(less_equal(N(0), rest), less_equal(N(4) * centre_squared * radius_squared, square(rest)));
}

/// thickness >= sqrt(threshold_squared): the least altitude / (dimension · longest edge), which is 1 for an edge.
/// Precondition: at least two vertices, which are not degenerate.
template <class N>
Verdict is_thick(const Metric& metric, std::vector<Vector<N>> vertices, const N& threshold_squared) {
  N longest(0);
  for (const Vector<N>& x : vertices) {
    for (const Vector<N>& y : vertices) longest = maximum(longest, metric.squared_length(x - y));
  }
  const int k = static_cast<int>(vertices.size()) - 1;
  const N least = threshold_squared * N(k * k) * longest;
  Verdict result = Verdict::proved;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector<N> apex = vertices[i];
    std::vector<Vector<N>> facet = vertices;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
    const Simplex<N> opposite(metric, facet);
    if (opposite.complete != Verdict::proved) return Verdict::undecided;
    result = conjunction(result, less_equal(least, metric.squared_length(opposite.perpendicular(apex - facet[0]))));
  }
  return result;
}

}  // namespace delcert::checker
