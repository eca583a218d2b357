#include "properties/instances/configuration_point_class.hpp"

#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/realisability.hpp"
#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Point = std::vector<Rational>;
using Points = SimplexObject::Points;

/// a + factor·(b − a)
Point between(const Point& a, const Point& b, const Rational& factor) {
  Point result = a;
  for (std::size_t axis = 0; axis < a.size(); ++axis) result[axis] += factor * (b[axis] - a[axis]);
  return result;
}

Rational reach(const Points& points) {
  Rational result(0);
  for (const Point& point : points) {
    for (std::size_t axis = 0; axis < point.size(); ++axis) {
      result = maximum(result, absolute(point[axis] - points[0][axis]));
    }
  }
  return result;
}

/// Anywhere near the simplex; or almost on the ray from the circumcentre through a vertex; or on the diametric sphere
/// of an edge, at the foot of an altitude: where its planes through the two ends are orthogonal.
Point draw_point(const Points& points, Choices& choices) {
  const double kind = choices.unit();
  Point any = points[0];
  for (Rational& coordinate : any) coordinate += choices.symmetric(8) * Rational(2) * reach(points);
  if (kind < 0.4) return any;
  if (kind < 0.7) {
    const auto sphere = circumsphere(edge_gram_from_points(points));
    const Point near = between(points.back(), circumcentre(*sphere, points), choices.symmetric(6));
    return between(near, any, Rational::power_of_two(-12));
  }
  // The foot of the altitude from points[0] on the line through points[1] and any point (Thales).
  Rational product(0);
  Rational squared(0);
  for (std::size_t axis = 0; axis < any.size(); ++axis) {
    product += (points[0][axis] - points[1][axis]) * (any[axis] - points[1][axis]);
    squared += square(any[axis] - points[1][axis]);
  }
  return squared == Rational(0) ? any : between(points[1], any, product / squared);
}

class PointAndSimplexClass : public InstanceClass {
 public:
  std::string name() const override { return "point-and-simplex"; }
  std::string meaning() const override { return "a non-degenerate m-simplex s in R^m, m >= 2, and a point x of R^m"; }
  Signature signature() const override { return {{"s", types::simplex}, {"x", types::point}, {"m", types::integer}}; }
  std::vector<Shape> shapes() const override { return {{2, 2}, {3, 3}, {4, 4}}; }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits&,
                               Choices& choices) const override {
    auto points = random_simplex({shape.m, shape.m}, choices);
    if (!points) return std::nullopt;
    const auto x = std::make_shared<PointObject>(draw_point(*points, choices));
    const auto simplex = std::make_shared<SimplexObject>(std::move(*points));
    Instance instance{given, traits_of(*simplex)};
    instance.bindings["m"] = static_cast<long>(shape.m);
    instance.bindings["s"] = ObjectPointer(simplex);
    instance.bindings["x"] = ObjectPointer(x);
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    const auto& simplex = object_in<SimplexObject>(bindings, "s");
    const auto& x = object_in<PointObject>(bindings, "x");
    Points all = simplex.points();
    all.push_back(x.coordinates());
    std::vector<Bindings> result;
    for (auto& points : simpler_points(all, all.size(), all.front().size())) {
      const auto point = std::make_shared<PointObject>(points.back());
      points.pop_back();
      const auto candidate = std::make_shared<SimplexObject>(std::move(points));
      if (!is_proved(is_non_degenerate(candidate->exact_gram()))) continue;
      result.push_back(bindings);
      result.back()["s"] = ObjectPointer(candidate);
      result.back()["x"] = ObjectPointer(point);
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto& simplex = object_in<SimplexObject>(bindings, "s");
    const auto& x = object_in<PointObject>(bindings, "x");
    const std::size_t m = simplex.ambient_dimension();
    if (!simplex.has_coordinates() || simplex.dimension() != m || m < 2 ||
        !is_proved(is_non_degenerate(simplex.exact_gram()))) {
      throw InputError(name() + ": s is not a non-degenerate m-simplex in R^m, m >= 2");
    }
    if (x.coordinates().size() != m || std::get<long>(bindings.at("m")) != static_cast<long>(m)) {
      throw InputError(name() + ": m is not the dimension of s and x");
    }
  }
};

}  // namespace

const InstanceClass& configuration_point_class() {
  static const PointAndSimplexClass result;
  return result;
}

}  // namespace delcert
