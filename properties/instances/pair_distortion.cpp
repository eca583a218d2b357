#include "properties/instances/pair_distortion.hpp"

#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/root_comparison.hpp"

namespace delcert {

namespace {

/// √a ≤ √b + √c, that is a − b − c ≤ 2√(bc).
template <class S>
Verdict is_at_most_sum(const S& a, const S& b, const S& c) {
  return is_at_most_twice_root(S(a - b - c), S(b * c));
}

template <class S>
Verdict differ_by_at_most(const S& a, const S& b, const S& bound) {
  return conjunction(is_at_most_sum(a, b, bound), is_at_most_sum(b, a, bound));
}

/// |a − b|/(√a + √b), on intervals without the cancellation; needs a − b exactly.
template <class S>
S difference_of_roots(const Rational& a, const Rational& b) {
  return scalar_from<S>(absolute(a - b)) / (square_root(scalar_from<S>(a)) + square_root(scalar_from<S>(b)));
}

template <class S>
S distortion(const SimplexObject& simplex, const SimplexObject& image) {
  const auto& before = simplex.exact_gram();
  const auto& after = image.exact_gram();
  S result(0);
  for (std::size_t i = 0; i < before.vertex_count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (before.squared_edge(i, j) == after.squared_edge(i, j)) continue;
      result = maximum(result, difference_of_roots<S>(before.squared_edge(i, j), after.squared_edge(i, j)));
    }
  }
  return result / square_root(scalar_from<S>(squared_longest_edge_of(simplex)));
}

}  // namespace

bool lengths_differ_by_at_most(const Rational& squared_a, const Rational& squared_b, const Rational& squared_bound) {
  return is_proved(decide([&]<class S>() {
    return differ_by_at_most(scalar_from<S>(squared_a), scalar_from<S>(squared_b), scalar_from<S>(squared_bound));
  }));
}

bool is_distortion_at_most(const SimplexObject& simplex, const SimplexObject& image, const Rational& xi) {
  const auto& before = simplex.exact_gram();
  const auto& after = image.exact_gram();
  const Rational bound = square(xi) * squared_longest_edge_of(simplex);
  for (std::size_t i = 0; i < before.vertex_count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!lengths_differ_by_at_most(before.squared_edge(i, j), after.squared_edge(i, j), bound)) return false;
    }
  }
  return true;
}

Rational measured_distortion(const SimplexObject& simplex, const SimplexObject& image) {
  {
    const RoundingGuard guard;
    const Interval measured = distortion<Interval>(simplex, image);
    // Far from underflow, a few roundings are all that is lost.
    if (measured.upper() == 0) return Rational(0);
    if (measured.lower() > 0x1p-900 && measured.upper() < 0x1p900 &&
        measured.upper() - measured.lower() <= 0x1p-41 * measured.lower()) {
      return Rational::exactly(measured.upper());
    }
  }
  const BigInterval::Precision precision(PrecisionBits{128});
  return distortion<BigInterval>(simplex, image).upper();
}

Rational squared_longest_edge_of(const SimplexObject& simplex) { return squared_longest_edge(simplex.exact_gram()); }

}  // namespace delcert
