#include "properties/instances/configuration.hpp"

#include <utility>

#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/exact_simplex.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"
#include "properties/instances/configuration_geometry.hpp"

namespace delcert {

Rational Configuration::edge_bound() const {
  return Rational(5) / Rational(2) * (Rational(1) + delta0 * mu0 / Rational(2)) * epsilon;
}

Rational Configuration::hoop_bound() const { return Rational::power_of_two(13) * gamma0 / power(mu0, 3); }

Rational squared_separation(const SimplexObject::Points& points) {
  return squared_shortest_edge(edge_gram_from_points(points));
}

bool is_forbidden_configuration(const Configuration& configuration) {
  if (squared_separation(configuration.points) <
      square(configuration.perturbed_mu0 * configuration.perturbed_epsilon)) {
    return false;
  }
  const std::size_t m = configuration.points.front().size();
  const ForbiddenConfigurationParameters<> parameters{
      square(configuration.gamma0), square(configuration.perturbed_epsilon), square(configuration.protection())};
  return is_proved(decide_on(ExactSimplex::from_points(configuration.points), [&]<class S>(const EdgeGram<S>& simplex) {
    return is_forbidden_configuration(simplex, m, parameters.on<S>());
  }));
}

bool has_forbidden_properties(const Configuration& configuration) {
  const ForbiddenPropertiesParameters<> parameters{square(configuration.gamma0), square(configuration.hoop_bound()),
                                                   configuration.epsilon, configuration.edge_bound()};
  return is_proved(decide_on(ExactSimplex::from_points(configuration.points), [&]<class S>(const EdgeGram<S>& simplex) {
    return has_forbidden_properties(simplex, parameters.on<S>());
  }));
}

Configuration scaled(Configuration configuration, const Rational& factor) {
  configuration.points = scaled_points(std::move(configuration.points), factor);
  configuration.epsilon *= factor;
  configuration.perturbed_epsilon *= factor;
  return configuration;
}

}  // namespace delcert
