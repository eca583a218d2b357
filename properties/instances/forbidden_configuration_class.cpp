#include "properties/instances/forbidden_configuration_class.hpp"

#include "kernel/simplex/edges.hpp"
#include "proofs/formula/configuration_vocabulary.hpp"
#include "properties/instances/configuration_draw.hpp"
#include "properties/instances/random_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

const SimplexObject& configuration_of(const Bindings& bindings) { return object_in<SimplexObject>(bindings, "t"); }

Configuration read_configuration(const Bindings& bindings) {
  return {configuration_of(bindings).points(),
          number_in(bindings, "gamma0"),
          number_in(bindings, "delta0"),
          number_in(bindings, "mu0"),
          number_in(bindings, "rho0"),
          number_in(bindings, "epsilon"),
          number_in(bindings, "perturbed_mu0"),
          number_in(bindings, "perturbed_epsilon"),
          false};
}

class ForbiddenConfigurationClass : public InstanceClass {
 public:
  std::string name() const override { return "forbidden-configuration"; }
  std::string meaning() const override {
    return "a forbidden configuration t of dimension k + 1 in R^m, k >= 2, with vertices "
           "perturbed_mu0*perturbed_epsilon "
           "apart, for the flake parameter gamma0, the protection delta0*perturbed_mu0*perturbed_epsilon and the "
           "radius "
           "perturbed_epsilon <= (1 + rho0)*epsilon";
  }
  Signature signature() const override {
    return {{"t", types::simplex},
            {"k", types::integer},
            {"m", types::integer},
            {"gamma0", types::number},
            {"delta0", types::number},
            {"mu0", types::number},
            {"rho0", types::number},
            {"epsilon", types::number},
            {"perturbed_mu0", types::number},
            {"perturbed_epsilon", types::number}};
  }
  void extend(Vocabulary& vocabulary) const override { add_configuration_quantities(vocabulary); }

  std::vector<Shape> shapes() const override { return {{2, 2}, {2, 3}, {3, 3}, {2, 4}, {3, 4}, {4, 4}}; }

  std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                               Choices& choices) const override {
    Bindings bound = given;
    bound["k"] = static_cast<long>(shape.k);
    bound["m"] = static_cast<long>(shape.m);
    auto configuration = draw_forbidden_configuration(shape, bound, limits, choices);
    if (!configuration) return std::nullopt;
    Instance instance{std::move(bound), {Trait::cospherical}};
    if (configuration->at_boundary) instance.traits.insert(Trait::boundary);
    if (configuration->gamma0 < Rational::power_of_two(-10)) instance.traits.insert(Trait::nearly_degenerate);
    bind(instance.bindings, std::move(*configuration));
    return instance;
  }

  std::vector<Bindings> simpler(const Bindings& bindings) const override {
    std::vector<Bindings> result;
    const Configuration configuration = read_configuration(bindings);
    const auto keep = [&](Configuration candidate) {
      if (!fault(candidate).empty()) return;
      result.push_back(bindings);
      bind(result.back(), std::move(candidate));
    };
    for (auto& points : simpler_points(configuration.points, configuration.points.size(), 2)) {
      if (points.size() > points.front().size() + 2) continue;
      Configuration candidate = configuration;
      candidate.points = std::move(points);
      keep(std::move(candidate));
    }
    const auto vary = [&](Rational Configuration::*member) {
      for (const Rational& simple : simpler_numbers(configuration.*member)) {
        Configuration candidate = configuration;
        candidate.*member = simple;
        candidate.perturbed_epsilon = (Rational(1) + candidate.rho0) * candidate.epsilon;
        candidate.perturbed_mu0 = (candidate.mu0 - Rational(2) * candidate.rho0) / (Rational(1) + candidate.rho0);
        keep(std::move(candidate));
      }
    };
    vary(&Configuration::gamma0);
    vary(&Configuration::delta0);
    vary(&Configuration::mu0);
    vary(&Configuration::rho0);
    return result;
  }

  void require(const Bindings& bindings) const override {
    require_signature(*this, bindings);
    const SimplexObject& simplex = configuration_of(bindings);
    if (!simplex.has_coordinates()) throw InputError(name() + ": t has no coordinates");
    if (std::get<long>(bindings.at("k")) + 1 != static_cast<long>(simplex.dimension()) ||
        std::get<long>(bindings.at("m")) != static_cast<long>(simplex.ambient_dimension())) {
      throw InputError(name() + ": k + 1 and m are not the dimensions of t");
    }
    const std::string why = fault(read_configuration(bindings));
    if (!why.empty()) throw InputError(name() + ": " + why);
  }

 private:
  /// Why this is no instance; empty if it is one.
  static std::string fault(const Configuration& c) {
    const Rational zero(0);
    if (c.gamma0 <= zero || Rational(1) < c.gamma0) return "gamma0 is not in (0, 1]";
    if (c.delta0 < zero || c.rho0 < zero) return "delta0 or rho0 is negative";
    if (c.mu0 <= zero || c.epsilon <= zero) return "mu0 or epsilon is not positive";
    if (c.perturbed_epsilon <= zero || (Rational(1) + c.rho0) * c.epsilon < c.perturbed_epsilon) {
      return "perturbed_epsilon is not in (0, (1 + rho0)*epsilon]";
    }
    if (c.perturbed_mu0 <= zero || c.perturbed_mu0 * c.perturbed_epsilon < (c.mu0 - Rational(2) * c.rho0) * c.epsilon) {
      return "perturbed_mu0*perturbed_epsilon is less than (mu0 - 2*rho0)*epsilon";
    }
    if (c.points.size() < 4) return "t is a triangle or less";
    if (!is_forbidden_configuration(c)) {
      return "t is not a forbidden configuration with vertices perturbed_mu0*perturbed_epsilon apart";
    }
    return "";
  }

  static void bind(Bindings& bindings, Configuration configuration) {
    bindings["k"] = static_cast<long>(configuration.points.size()) - 2;
    bindings["m"] = static_cast<long>(configuration.points.front().size());
    bindings["t"] = ObjectPointer(std::make_shared<SimplexObject>(std::move(configuration.points)));
    bindings["gamma0"] = configuration.gamma0;
    bindings["delta0"] = configuration.delta0;
    bindings["mu0"] = configuration.mu0;
    bindings["rho0"] = configuration.rho0;
    bindings["epsilon"] = configuration.epsilon;
    bindings["perturbed_mu0"] = configuration.perturbed_mu0;
    bindings["perturbed_epsilon"] = configuration.perturbed_epsilon;
  }
};

}  // namespace

const InstanceClass& forbidden_configuration_class() {
  static const ForbiddenConfigurationClass result;
  return result;
}

}  // namespace delcert
