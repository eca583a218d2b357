#include "properties/instances/curved_configuration_class.hpp"

#include <algorithm>

#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/exponential_transition.hpp"
#include "properties/instances/random_simplex.hpp"
#include "properties/instances/transported_configuration_class.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// As far as the vertices of a forbidden configuration are from p_j, and as p_i, in units of ε_j.
constexpr long farthest_vertex = 4;
constexpr long farthest_centre = 6;

void bind_transition(Bindings& bindings, std::shared_ptr<const SpaceObject> space, ConfigurationMap::Finite map) {
  const auto& vertices = object_in<SimplexObject>(bindings, "t").points();
  const auto transition = std::make_shared<ConfigurationMap>(std::move(map));
  bindings["u"] = ObjectPointer(std::make_shared<SimplexObject>(transition->image(vertices)));
  bindings["f"] = ObjectPointer(transition);
  bindings["x"] = ObjectPointer(std::move(space));
}

class CurvedConfigurationClass : public InstanceClass {
 public:
  std::string name() const override { return "curved-configuration"; }
  std::string meaning() const override {
    return "as transported-configuration, with the exponential charts at points j = 0, the origin, and i = 1 of x in a "
           "sphere or a hyperbolic space for patches: f is the transition between them on the vertices and the "
           "circumcentres of the facets, rounded by less than 2^-40*xi of the least distance between these";
  }
  Signature signature() const override {
    Signature result = transported_configuration_class().signature();
    result["x"] = types::space_points;
    return result;
  }
  std::vector<Shape> shapes() const override { return {{2, 2}, {2, 3}, {3, 3}}; }
  /// Those listed, and no others: points of spaces have dimension 2 or 3.
  bool has(const Shape& shape) const override {
    const std::vector<Shape> listed = shapes();
    return std::find(listed.begin(), listed.end(), shape) != listed.end();
  }
  std::uint64_t cost(const Shape&) const override { return 10; }
  bool has_structure(const Shape&) const override { return true; }

  std::string manifold(const Bindings& bindings) const override {
    return object_in<SpaceObject>(bindings, "x").curvature() == Curvature::positive ? "sphere" : "hyperbolic space";
  }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    return on_a_manifold(transported_configuration_class().draw(shape, given, limits, choices), choices);
  }

  std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given, const Limits& limits,
                                          Choices& choices) const override {
    return on_a_manifold(transported_configuration_class().draw_structured(shape, given, limits, choices), choices);
  }

  /// With points of rounder coordinates for i.
  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const auto& space = object_in<SpaceObject>(bindings, "x");
    const auto& map = object_in<ConfigurationMap>(bindings, "f").finite();
    for (const auto& points : simpler_points(space.points(), 2, space.points().front().size())) {
      if (points[0] != space.points()[0]) continue;
      Bindings candidate = bindings;
      try {
        auto other = std::make_shared<const SpaceObject>(space.curvature(), space.unit(), points);
        auto transition = rounded_transition(*other, map.points, number_in(bindings, "xi"));
        if (!transition) continue;
        bind_transition(candidate, std::move(other), *std::move(transition));
        require(candidate);
      } catch (const InputError&) {
        continue;
      }
      result.push_back(std::move(candidate));
    }
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    Bindings transported = bindings;
    transported.erase("x");
    transported_configuration_class().require(transported);
    const auto refuse = [this](const std::string& why) { throw InputError(name() + ": " + why); };
    const auto& space = object_in<SpaceObject>(bindings, "x");
    const auto& map = object_in<ConfigurationMap>(bindings, "f");
    if (space.size() != 2 || space.points()[0] != ExactPoint(space.points()[0].size(), Rational(0))) {
      refuse("x has not two points, the first the origin");
    }
    if (space.dimension() != static_cast<int>(map.dimension())) refuse("f has not the dimension of x");
    if (!map.is_finite()) refuse("f is not a map of finitely many points");
    if (map.distortion() <= Rational(0) || !is_transition_of(space, map.finite())) {
      refuse("f is not the transition of x");
    }
  }

 private:
  /// The configuration of another instance, somewhere in the exponential chart at j, and a transition for its map.
  static std::optional<Instance> on_a_manifold(std::optional<Instance> instance, Choices& choices) {
    if (!instance) return std::nullopt;
    Bindings& bindings = instance->bindings;
    const Rational& epsilon = number_in(bindings, "epsilon_j");
    SimplexObject::Points vertices = object_in<SimplexObject>(bindings, "t").points();
    constexpr unsigned bits = 6;
    std::vector<double> towards;
    for (std::size_t axis = 0; axis < vertices.front().size(); ++axis) towards.push_back(choices.unit() - 0.5);
    const Rational distance = Rational(farthest_vertex) * choices.fraction(bits) * epsilon;
    const ExactPoint place = rational_direction(towards, bits);
    for (ExactPoint& vertex : vertices) vertex = combined(vertex, distance, place);
    auto transition =
        exponential_transition(vertices, number_in(bindings, "xi"), Rational(farthest_centre) * epsilon, choices);
    if (!transition) return std::nullopt;
    bindings["t"] = ObjectPointer(std::make_shared<SimplexObject>(std::move(vertices)));
    bind_transition(bindings, std::move(transition->space), std::move(transition->map));
    return instance;
  }
};

}  // namespace

const InstanceClass& curved_configuration_class() {
  static const CurvedConfigurationClass result;
  return result;
}

}  // namespace delcert
