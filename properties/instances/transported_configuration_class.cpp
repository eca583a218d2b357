#include "properties/instances/transported_configuration_class.hpp"

#include <Eigen/Dense>

#include "properties/instances/configuration_draw.hpp"
#include "properties/instances/configuration_finite_map.hpp"
#include "properties/instances/configuration_geometry.hpp"
#include "properties/instances/configuration_map.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The hypotheses of lem:prop.forbid.cfg besides those of the claim: with them a forbidden configuration has P1 … P4.
class LemmaLimits : public Limits {
 public:
  explicit LemmaLimits(const Limits& given) : given_(given) {}
  std::optional<Rational> most(const std::string& name, const Bindings& bound, bool exact) const override {
    const auto given = given_.most(name, bound, exact);
    std::optional<Rational> own;
    if (name == "mu0") own = Rational(1);
    if (name == "rho0") own = number_in(bound, "mu0") / Rational(4);
    if (name == "gamma0") own = Rational(2) * square(number_in(bound, "mu0")) / Rational(75);
    if (name == "delta0") own = power(number_in(bound, "gamma0"), std::get<long>(bound.at("m")) + 1);
    return given && own ? minimum(*given, *own) : given ? given : own;
  }

 private:
  const Limits& given_;
};

std::vector<Rational> short_vector(std::size_t size, Choices& choices) {
  std::vector<Rational> result;
  for (std::size_t axis = 0; axis < size; ++axis) result.emplace_back(choices.between(-3, 3));
  return result;
}

/// A symmetric matrix of norm 1: H diag(d) H for a reflection H, with entries of d in [−1, 1] and one of them ±1.
std::vector<std::vector<Rational>> unit_stretching(std::size_t m, Choices& choices) {
  std::vector<Rational> diagonal;
  for (std::size_t axis = 0; axis < m; ++axis) diagonal.push_back(choices.symmetric(3));
  const auto extreme = static_cast<std::size_t>(choices.between(0, static_cast<long>(m) - 1));
  diagonal[extreme] = Rational(choices.happens(0.5) ? 1 : -1);
  SimplexObject::Points axes(m, std::vector<Rational>(m, Rational(0)));
  for (std::size_t axis = 0; axis < m; ++axis) axes[axis][axis] = Rational(1);
  if (choices.happens(0.7)) axes = mirrored_points(std::move(axes), short_vector(m, choices));
  std::vector<std::vector<Rational>> result;
  for (std::size_t row = 0; row < m; ++row) {
    result.emplace_back(row + 1, Rational(0));
    for (std::size_t column = 0; column <= row; ++column) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        result[row][column] += diagonal[axis] * axes[axis][row] * axes[axis][column];
      }
    }
  }
  return result;
}

/// About the direction in which the thinnest facet is thin; without error bounds.
std::vector<double> thin_direction(const SimplexObject::Points& points) {
  const auto m = static_cast<Eigen::Index>(points.front().size());
  const auto k = static_cast<Eigen::Index>(points.size()) - 2;
  std::vector<double> result(points.front().size(), 0);
  double least = 2;
  for (std::size_t left_out = 0; left_out < points.size(); ++left_out) {
    const std::size_t base = left_out == 0 ? 1 : 0;
    Eigen::MatrixXd edges(m, k);
    Eigen::Index column = 0;
    for (std::size_t i = base + 1; i < points.size(); ++i) {
      if (i == left_out) continue;
      for (Eigen::Index axis = 0; axis < m; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        edges(axis, column) = approximate_double(points[i][at] - points[base][at]);
      }
      ++column;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> values(edges, Eigen::ComputeThinU);
    const double thinness = values.singularValues()(k - 1) / values.singularValues()(0);
    if (!(thinness < least)) continue;
    least = thinness;
    for (Eigen::Index axis = 0; axis < m; ++axis)
      result[static_cast<std::size_t>(axis)] = values.matrixU()(axis, k - 1);
  }
  return result;
}

/// A symmetric matrix of norm 1: −1 along the direction in which a facet is thin, one number of [−1, 1] across it.
std::vector<std::vector<Rational>> unit_squashing(const SimplexObject::Points& points, Choices& choices) {
  constexpr unsigned bits = 8;
  const std::vector<Rational> thin = rational_direction(thin_direction(points), bits);
  const Rational across = choices.happens(0.5) ? Rational(1) : choices.symmetric(3);
  std::vector<std::vector<Rational>> result;
  for (std::size_t row = 0; row < thin.size(); ++row) {
    result.emplace_back();
    for (std::size_t column = 0; column <= row; ++column) {
      result[row].push_back(Rational(row == column ? 1 : 0) * across -
                            (Rational(1) + across) * thin[row] * thin[column]);
    }
  }
  return result;
}

ConfigurationMap random_map(std::size_t m, const Rational& distortion, const SimplexObject::Points& points,
                            Choices& choices) {
  ConfigurationMap::Data data;
  const bool has_fold = choices.happens(0.4);
  const Rational share = has_fold ? choices.fraction(3) : Rational(1);
  data.stretch = distortion * share;
  data.fold = distortion - data.stretch;
  data.stretching = choices.happens(0.2) ? unit_squashing(points, choices) : unit_stretching(m, choices);
  for (auto& row : data.stretching) {
    for (Rational& entry : row) entry *= data.stretch;
  }
  // A fold through the middle of two vertices, of the full Lipschitz constant.
  std::vector<double> direction;
  std::vector<double> normal;
  for (std::size_t axis = 0; axis < m; ++axis) {
    direction.push_back(choices.unit() - 0.5);
    normal.push_back(choices.unit() - 0.5);
  }
  data.fold_direction = rational_direction(direction, 5);
  for (Rational& entry : data.fold_direction) entry *= data.fold;
  data.fold_normal = rational_direction(normal, 5);
  for (std::size_t axis = 0; axis < m; ++axis) {
    data.fold_offset += data.fold_normal[axis] * (points[0][axis] + points[1][axis]) / Rational(2);
  }
  data.mirror = choices.happens(0.5) ? short_vector(m, choices) : std::vector<Rational>(m, Rational(0));
  return ConfigurationMap(std::move(data));
}

class TransportedConfigurationClass : public InstanceClass {
 public:
  std::string name() const override { return "transported-configuration"; }
  std::string meaning() const override {
    return "a simplex t of dimension k + 1 in R^m, k >= 2, with the properties P1 ... P4 of forbidden configurations "
           "for gamma0, delta0, mu0 and the radius epsilon_j, and its image u under the map f of distortion xi, which "
           "is "
           "defined on all of R^m or on the vertices and the circumcentres of the facets; epsilon_i <= (1 + "
           "epsilon0)*epsilon_j";
  }
  Signature signature() const override {
    return {{"t", types::simplex},       {"u", types::simplex},        {"f", types::configuration_map},
            {"k", types::integer},       {"m", types::integer},        {"gamma0", types::number},
            {"delta0", types::number},   {"mu0", types::number},       {"xi", types::number},
            {"epsilon0", types::number}, {"epsilon_i", types::number}, {"epsilon_j", types::number}};
  }
  void extend(Vocabulary& vocabulary) const override {
    vocabulary.add_kind("configuration-map", ConfigurationMap::read);
  }

  std::vector<Shape> shapes() const override { return {{2, 2}, {2, 3}, {3, 3}, {2, 4}, {3, 4}, {4, 4}}; }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    Instance instance = begun(shape, given);
    const bool by_definition = choices.happens(0.3);
    const LemmaLimits within(limits);
    auto configuration = by_definition ? draw_forbidden_configuration(shape, instance.bindings, within, choices)
                                       : draw_forbidden_properties(shape, instance.bindings, within, choices);
    if (!configuration || (by_definition && !has_forbidden_properties(*configuration))) return std::nullopt;
    return transported(std::move(instance), *std::move(configuration), shape, limits, choices);
  }

  bool has_structure(const Shape&) const override { return true; }

  /// Those at two of the bounds, where the least distortion leads beyond.
  std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given, const Limits& limits,
                                          Choices& choices) const override {
    Instance instance = begun(shape, given);
    auto configuration = draw_tight_properties(shape, instance.bindings, LemmaLimits(limits), choices);
    if (!configuration) return std::nullopt;
    return transported(std::move(instance), *std::move(configuration), shape, limits, choices);
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const auto& map = object_in<ConfigurationMap>(bindings, "f");
    const auto keep = [&](const SimplexObject::Points& points, ConfigurationMap::Data data) {
      Bindings candidate = bindings;
      candidate["t"] = ObjectPointer(std::make_shared<SimplexObject>(points));
      data.stretch = minimum(data.stretch, number_in(bindings, "xi"));
      try {
        const auto changed = std::make_shared<ConfigurationMap>(std::move(data));
        candidate["u"] = ObjectPointer(std::make_shared<SimplexObject>(changed->image(points)));
        candidate["f"] = ObjectPointer(changed);
        require(candidate);
      } catch (const InputError&) {
        return;
      }
      result.push_back(std::move(candidate));
    };
    const auto& points = object_in<SimplexObject>(bindings, "t").points();
    const std::size_t m = map.dimension();
    if (map.is_finite()) return simpler_images(bindings, map.finite());
    const std::vector<Rational> zero(m, Rational(0));
    if (map.data().mirror != zero) {
      ConfigurationMap::Data data = map.data();
      data.mirror = zero;
      keep(points, std::move(data));
    }
    if (map.data().fold_direction != zero) {
      ConfigurationMap::Data data = map.data();
      data.fold_direction = zero;
      data.fold = Rational(0);
      keep(points, std::move(data));
    }
    ConfigurationMap::Data rounder = map.data();
    for (std::size_t row = 0; row < m; ++row) {
      for (std::size_t column = 0; column <= row; ++column) {
        rounder.stretching[row][column] = row == column ? rounder.stretch : Rational(0);
      }
    }
    if (rounder.stretching != map.data().stretching) keep(points, std::move(rounder));
    for (const auto& candidate : simpler_points(points, points.size(), m)) keep(candidate, map.data());
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const auto refuse = [this](const std::string& why) { throw InputError(name() + ": " + why); };
    const auto& t = object_in<SimplexObject>(bindings, "t");
    const auto& u = object_in<SimplexObject>(bindings, "u");
    const auto& map = object_in<ConfigurationMap>(bindings, "f");
    if (!t.has_coordinates() || !u.has_coordinates()) refuse("t or u has no coordinates");
    const std::size_t m = t.ambient_dimension();
    if (t.dimension() < 3 || std::get<long>(bindings.at("k")) + 1 != static_cast<long>(t.dimension()) ||
        std::get<long>(bindings.at("m")) != static_cast<long>(m) || t.dimension() > m + 1 || map.dimension() != m) {
      refuse("k + 1 and m are not the dimensions of t and f");
    }
    for (const char* positive : {"gamma0", "mu0", "epsilon_i", "epsilon_j"}) {
      if (number_in(bindings, positive) <= Rational(0)) refuse(std::string(positive) + " is not positive");
    }
    if (Rational(1) < number_in(bindings, "gamma0")) refuse("gamma0 is above 1");
    if (number_in(bindings, "epsilon0") < Rational(0) || number_in(bindings, "delta0") < Rational(0)) {
      refuse("epsilon0 or delta0 is negative");
    }
    if ((Rational(1) + number_in(bindings, "epsilon0")) * number_in(bindings, "epsilon_j") <
        number_in(bindings, "epsilon_i")) {
      refuse("epsilon_i is above (1 + epsilon0)*epsilon_j");
    }
    if (number_in(bindings, "xi") < map.distortion()) refuse("f has a distortion above xi");
    if (!map.is_defined_on(t.points()) || map.image(t.points()) != u.points()) {
      refuse("u is not the image of t under f");
    }
    Configuration configuration;
    configuration.points = t.points();
    configuration.gamma0 = number_in(bindings, "gamma0");
    configuration.delta0 = number_in(bindings, "delta0");
    configuration.mu0 = number_in(bindings, "mu0");
    configuration.epsilon = number_in(bindings, "epsilon_j");
    if (!has_forbidden_properties(configuration)) refuse("t has not the properties P1 ... P4");
    if (map.is_finite() && !map.is_defined_on(circumcentres_of_facets(t.points()))) {
      refuse("f is not defined on the circumcentre of a facet");
    }
  }

 private:
  /// Images with rounder coordinates.
  std::vector<Bindings> simpler_images(const Bindings& bindings, const ConfigurationMap::Finite& map) const {
    std::vector<Bindings> result;
    for (auto& images : simpler_points(map.images, map.images.size(), map.images.front().size())) {
      Bindings candidate = bindings;
      try {
        const auto changed =
            std::make_shared<ConfigurationMap>(ConfigurationMap::Finite{map.points, std::move(images), map.distortion});
        candidate["u"] = ObjectPointer(
            std::make_shared<SimplexObject>(changed->image(object_in<SimplexObject>(bindings, "t").points())));
        candidate["f"] = ObjectPointer(changed);
        require(candidate);
      } catch (const InputError&) {
        continue;
      }
      result.push_back(std::move(candidate));
    }
    return result;
  }

  static Instance begun(const Shape& shape, const Bindings& given) {
    Instance result{given, {Trait::cospherical}};
    result.bindings["k"] = static_cast<long>(shape.k);
    result.bindings["m"] = static_cast<long>(shape.m);
    return result;
  }

  /// With radii, a map, and the image.
  static std::optional<Instance> transported(Instance instance, Configuration configuration, const Shape& shape,
                                             const Limits& limits, Choices& choices) {
    Bindings& bound = instance.bindings;
    bound["gamma0"] = configuration.gamma0;
    bound["delta0"] = configuration.delta0;
    bound["mu0"] = configuration.mu0;
    bool at_boundary = configuration.at_boundary;
    bound["xi"] = draw_distortion(shape, limits, bound, choices, at_boundary);
    draw_radii(limits, bound, choices, at_boundary);
    configuration = scaled(std::move(configuration), number_in(bound, "epsilon_j") / configuration.epsilon);
    auto map = std::make_shared<ConfigurationMap>(
        random_map(static_cast<std::size_t>(shape.m), number_in(bound, "xi"), configuration.points, choices));
    if (choices.happens(0.3)) {
      auto finite = finite_configuration_map(configuration.points, number_in(bound, "xi"), choices);
      if (finite) map = std::make_shared<ConfigurationMap>(*std::move(finite));
    }
    bound["f"] = ObjectPointer(map);
    bound["u"] = ObjectPointer(std::make_shared<SimplexObject>(map->image(configuration.points)));
    bound["t"] = ObjectPointer(std::make_shared<SimplexObject>(std::move(configuration.points)));
    if (at_boundary) instance.traits.insert(Trait::boundary);
    if (configuration.gamma0 < Rational::power_of_two(-10)) instance.traits.insert(Trait::nearly_degenerate);
    return instance;
  }

  static Rational draw_distortion(const Shape& shape, const Limits& limits, const Bindings& bound, Choices& choices,
                                  bool& at_boundary) {
    constexpr long lowest_exponent = 60;
    const Rational own = Rational(15) / Rational(16);
    Rational most = minimum(own, limits.most("xi", bound, true).value_or(own));
    const double kind = choices.unit();
    if (kind < 0.4) {
      at_boundary = at_boundary || limits.most("xi", bound, true).has_value();
      return most;
    }
    const Rational share = Rational(1) - choices.fraction(6) / Rational(2);
    if (kind < 0.7) {
      return shortened_down(most * share * Rational::power_of_two(-choices.between(0, lowest_exponent)), 8);
    }
    // So small that it hardly matters: what is left is the hoop itself.
    return shortened_down(minimum(most, power(number_in(bound, "gamma0"), 4L * shape.k + 2)) * share, 8);
  }

  static void draw_radii(const Limits& limits, Bindings& bound, Choices& choices, bool& at_boundary) {
    const Rational own_variation(64);
    const auto given = limits.most("epsilon0", bound, true);
    const Rational most = given ? minimum(*given, own_variation) : own_variation;
    const double kind = choices.unit();
    at_boundary = at_boundary || (given && kind < 0.5);
    bound["epsilon0"] = kind < 0.5 ? most : shortened_down(most * choices.fraction(6), 8);
    const Rational i = choices.happens(0.8) ? Rational(1) : Rational::power_of_two(choices.between(-30, 30));
    bound["epsilon_i"] = i;
    const Rational widest = (Rational(1) + number_in(bound, "epsilon0")) * i;
    const Rational narrowest = i / (Rational(1) + number_in(bound, "epsilon0"));
    const Rational largest = limits.most("epsilon_j", bound, true).value_or(Rational(64) * widest);
    const double where = choices.unit();
    bound["epsilon_j"] = where < 0.6   ? largest
                         : where < 0.7 ? narrowest
                                       : narrowest + shortened_down((largest - narrowest) * choices.fraction(6), 8);
  }
};

}  // namespace

const InstanceClass& transported_configuration_class() {
  static const TransportedConfigurationClass result;
  return result;
}

}  // namespace delcert
