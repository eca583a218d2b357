#include "kernel/simplex/simplex_decisions.hpp"

#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/realisability.hpp"
#include "kernel/simplex/singular_values.hpp"

namespace delcert {

namespace {

/// The verdict of `test` on a value, or, for want of one, on its existence.
template <class T, class Test>
Verdict verdict_on(const Partial<T>& value, const Test& test) {
  return value ? test(*value) : value.exists();
}

}  // namespace

Verdict decide_non_degenerate(const ExactSimplex& simplex) {
  return decide_on(simplex, []<class S>(const EdgeGram<S>& on_rung) { return is_non_degenerate(on_rung); });
}

Verdict decide_altitude_at_least(const ExactSimplex& simplex, std::size_t p, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return verdict_on(squared_altitude(on_rung, p),
                      [&](const S& altitude) { return less_equal(scalar_from<S>(squared_bound), altitude); });
  });
}

Verdict decide_thickness_at_least(const ExactSimplex& simplex, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_thickness_at_least(on_rung, scalar_from<S>(squared_bound));
  });
}

Verdict decide_circumradius_below(const ExactSimplex& simplex, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return verdict_on(squared_circumradius(on_rung),
                      [&](const S& radius) { return less(radius, scalar_from<S>(squared_bound)); });
  });
}

Verdict decide_smallest_singular_value_at_least(const ExactSimplex& simplex, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_smallest_singular_value_at_least(on_rung, scalar_from<S>(squared_bound));
  });
}

Verdict decide_largest_singular_value_at_most(const ExactSimplex& simplex, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_largest_singular_value_at_most(on_rung, scalar_from<S>(squared_bound));
  });
}

Verdict decide_circumsphere_within(const ExactSimplex& simplex, std::size_t p, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return verdict_on(sphere_offset(on_rung, p), [&](const SphereOffset<S>& offset) {
      return is_circumsphere_within(offset, scalar_from<S>(squared_bound));
    });
  });
}

Verdict decide_diametric_sphere_within(const ExactSimplex& simplex, std::size_t p, const Rational& squared_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return verdict_on(sphere_offset(on_rung, p), [&](const SphereOffset<S>& offset) {
      return is_diametric_sphere_within(offset, scalar_from<S>(squared_bound));
    });
  });
}

Verdict decide_good(const ExactSimplex& simplex, const Rational& squared_flake_parameter) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_good(on_rung, scalar_from<S>(squared_flake_parameter));
  });
}

Verdict decide_flake(const ExactSimplex& simplex, const Rational& squared_flake_parameter) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_flake(on_rung, scalar_from<S>(squared_flake_parameter));
  });
}

Verdict decide_hoop_property(const ExactSimplex& simplex, const Rational& squared_hoop_bound) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return has_hoop_property(on_rung, scalar_from<S>(squared_hoop_bound));
  });
}

Verdict decide_forbidden_configuration(const ExactSimplex& simplex, std::size_t ambient_dimension,
                                       const ForbiddenConfigurationParameters<Rational>& parameters) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return is_forbidden_configuration(on_rung, ambient_dimension, parameters.on<S>());
  });
}

Verdict decide_forbidden_properties(const ExactSimplex& simplex,
                                    const ForbiddenPropertiesParameters<Rational>& parameters) {
  return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
    return has_forbidden_properties(on_rung, parameters.on<S>());
  });
}

}  // namespace delcert
