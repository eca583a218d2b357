#include "kernel/sample/space_form_domain.hpp"

#include <cmath>

#include "kernel/chart/net_grid.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

/// A lift is taken for nearer if it is by more than what rounding may do.
constexpr double nearer = 0x1p-40;

Interval upper(const BigInterval& x) {
  const Interval enclosure = in_doubles(x);
  return Interval::exactly(enclosure.upper());
}

/// Where the nearest lifts are: in the polyhedron; within the half-sphere, if some γ ≠ 1 is there; within the half-sum
/// of the basis vectors' lengths, as ℤᵐ is in Γ.
LiftBounds domain_bounds(const SpaceForm& form) {
  switch (form.form().curvature()) {
    case Curvature::negative:
      return {upper(circumradius(form.form(), *form.polyhedron)).upper(), true};
    case Curvature::positive:
      return {upper(form.finite->elements.size() > 1 ? half_turn() / BigInterval(2) : half_turn()).upper(), false};
    default:
      break;
  }
  BigInterval sum(0);
  for (std::size_t axis = 0; axis < form.form().gram().order(); ++axis)
    sum += square_root(form.form().gram()(axis, axis).enclosure());
  return {upper(sum / BigInterval(2)).upper(), false};
}

double uniform_in(CounterRandom& random) { return 2 * random.next_unit() - 1; }

}  // namespace

template <int m>
SpaceFormDomain<m>::SpaceFormDomain(const SpaceForm& form, double reach)
    : curvature_(form.form().curvature()),
      metric_(chart_metric<m>(form.form()).template on<PlainDouble>()),
      bounds_(domain_bounds(form)),
      lifts_(form, bounds_, reach) {
  for (std::uint32_t number = 0; number < lifts_.table().size(); ++number) {
    ModelMatrix<PlainDouble, m> plain;
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column) {
        const Interval& entry = lifts_.table().matrix(number)[row][column];
        plain[row][column] = PlainDouble::between(entry.lower(), entry.upper());
      }
    }
    matrices_.push_back(plain);
  }
  if (curvature_ != Curvature::negative) return;
  // 2 tanh(D/2) = 2 sinh D/(1 + cosh D).
  const RoundingGuard guard;
  const Interval radius = Interval::exactly(bounds_.radius);
  const Interval sine = radius * sine_ratio(curvature_, square(radius));
  greatest_coordinate_ = (Interval(2) * sine / (Interval(1) + cosine_of_root(curvature_, square(radius)))).upper();
}

template <int m>
typename SpaceFormDomain<m>::Point SpaceFormDomain<m>::point(const Vector<double, m>& coordinates) const {
  Vector<PlainDouble, m> plain;
  for (std::size_t axis = 0; axis < m; ++axis) plain[axis] = PlainDouble::exactly(coordinates[axis]);
  return model_point<PlainDouble, m>(curvature_, plain);
}

template <int m>
double SpaceFormDomain<m>::remoteness(const Point& x) const {
  if (curvature_ == Curvature::zero)
    return metric_.squared_norm(detail::spatial_part<PlainDouble, static_cast<std::size_t>(m)>(x)).lower();
  return curvature_ == Curvature::positive ? -x[0].lower() : x[0].lower();
}

template <int m>
Vector<double, m> SpaceFormDomain<m>::reduced(Point x) const {
  // On a hyperbolic manifold one step need not lead into P: not all tiles are in the table.
  bool moved = true;
  while (moved) {
    double least = remoteness(x);
    Point nearest = x;
    moved = false;
    for (std::size_t number = 1; number < matrices_.size(); ++number) {
      if (curvature_ != Curvature::zero) {
        const double first = pairing(matrices_[number][0], x).lower();
        if ((curvature_ == Curvature::positive ? -first : first) >= least - nearer) continue;
      }
      const Point other = applied(matrices_[number], x);
      const double remote = remoteness(other);
      if (remote >= least - nearer) continue;
      least = remote;
      nearest = other;
      moved = true;
    }
    x = nearest;
  }
  const auto coordinates = conformal_coordinates<PlainDouble, m>(x);
  Vector<double, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) {
    result[axis] = on_net_grid(coordinates[axis].lower());
  }
  return result;
}

template <int m>
typename SpaceFormDomain<m>::Point SpaceFormDomain<m>::random_in_cover(CounterRandom& random) const {
  if (curvature_ == Curvature::zero) {
    Vector<double, m> x;
    for (double& coordinate : x) coordinate = uniform_in(random) / 2;
    return point(x);
  }
  if (curvature_ == Curvature::positive) {
    Vector<double, m + 1> x;
    double squared = 2;
    while (squared > 1 || squared < 0x1p-10) {
      for (double& coordinate : x) coordinate = uniform_in(random);
      squared = pairing(x, x);
    }
    const double length = std::sqrt(squared);
    Point result;
    for (std::size_t axis = 0; axis <= m; ++axis) result[axis] = PlainDouble::exactly(x[axis] / length);
    return result;
  }
  // Uniform in a Euclidean ball, and kept with a probability that is proportional to the hyperbolic volume there.
  while (true) {
    Vector<double, m> a;
    for (double& coordinate : a) coordinate = uniform_in(random) * greatest_coordinate_;
    const double squared = pairing(a, a);
    if (squared > greatest_coordinate_ * greatest_coordinate_) continue;
    const double stretch = (4 - greatest_coordinate_ * greatest_coordinate_) / (4 - squared);
    double kept = 1;
    for (int axis = 0; axis < m; ++axis) kept *= stretch;
    if (random.next_unit() < kept) return point(a);
  }
}

template <int m>
Vector<double, m> SpaceFormDomain<m>::random_point(CounterRandom& random) const {
  return reduced(random_in_cover(random));
}

template class SpaceFormDomain<2>;
template class SpaceFormDomain<3>;

}  // namespace delcert
