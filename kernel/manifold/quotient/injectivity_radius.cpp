#include "kernel/manifold/quotient/injectivity_radius.hpp"

#include "kernel/manifold/quotient/tile_walk.hpp"

namespace delcert {

namespace {

constexpr long result_exponent = -40;

InjectivityRadius half_of(const BigInterval& displacement) {
  const Rational half = Rational::power_of_two(-1);
  return {rounded_down(displacement.lower() * half, result_exponent),
          rounded_up(displacement.upper() * half, result_exponent)};
}

/// Whether ⟨x, γx⟩ < c⟨x, x⟩ for all x ≠ 0.
bool moves_beyond(const InvariantForm& form, const FieldMatrix& element, const Rational& c) {
  const FieldMatrix lowered = form.matrix() * element;
  FieldMatrix rest(element.order());
  for (std::size_t row = 0; row < rest.order(); ++row) {
    for (std::size_t column = 0; column < rest.order(); ++column)
      rest(row, column) =
          FieldElement(c + c) * form.matrix()(row, column) - lowered(row, column) - lowered(column, row);
  }
  return is_positive_definite(rest);
}

}  // namespace

InjectivityRadius injectivity_radius(const InvariantForm& form, const FiniteGroup& group) {
  if (group.elements.size() == 1) return half_of(half_turn() + half_turn());
  constexpr int steps = 32;
  // Cosines of the least displacement: never below `lower` for some element, below `upper` for all so far.
  Rational lower(-1);
  Rational upper(-1);
  for (std::size_t at = 1; at < group.elements.size(); ++at) {
    const FieldMatrix& element = group.elements[at];
    if (moves_beyond(form, element, upper)) continue;
    Rational low = upper;
    Rational high(1);
    for (int step = 0; step < steps; ++step) {
      const Rational middle = (low + high) * Rational::power_of_two(-1);
      (moves_beyond(form, element, middle) ? high : low) = middle;
    }
    lower = low;
    upper = high;
  }
  return half_of(arccosine(BigInterval::between(lower, upper)));
}

InjectivityRadius injectivity_radius(const CrystallographicGroup& group) {
  return half_of(square_root(BigInterval(group.squared_displacement)));
}

InjectivityRadius injectivity_radius(const InvariantForm& form, const DirichletPolyhedron& polyhedron) {
  BigInterval shortest = translation_length(form, polyhedron.sides.front().element);
  for (const auto& side : polyhedron.sides) shortest = minimum(shortest, translation_length(form, side.element));
  const auto tiles = tiles_near_polyhedron(form, polyhedron, shortest);
  // Besides e^ℓ and e^−ℓ the eigenvalues add at most 2 to the trace.
  const BigInterval greatest_trace = hyperbolic_cosine(shortest) * BigInterval(2) + BigInterval(2);
  for (std::size_t at = 1; at < tiles.size(); ++at) {
    if (is_proved(less(greatest_trace, trace(tiles[at]).enclosure()))) continue;
    shortest = minimum(shortest, translation_length(form, tiles[at]));
  }
  return half_of(shortest);
}

BigInterval translation_length(const InvariantForm& form, const FieldMatrix& element) {
  // Eigenvalues exp(±ℓ), in dimension 2 the determinant, in dimension 3 exp(±iθ) or ±1 besides them.
  const FieldElement sum = trace(element);
  const bool preserves_orientation = determinant(element).sign() > 0;
  const BigInterval half(Rational::power_of_two(-1));
  if (form.dimension() == 2)
    return area_cosine((sum - FieldElement(preserves_orientation ? 1 : -1)).enclosure() * half);
  if (!preserves_orientation) return area_cosine(sum.enclosure() * half);
  // 2 cosh ℓ and 2 cos θ are the roots of u² − au + b − 2, from x⁴ − ax³ + bx² − ax + 1.
  FieldElement sum_of_squares(0);
  for (std::size_t row = 0; row < element.order(); ++row) {
    for (std::size_t column = 0; column < element.order(); ++column)
      sum_of_squares += element(row, column) * element(column, row);
  }
  // a² − 4(b − 2), b = (a² − Σ squares)/2.
  const FieldElement discriminant = FieldElement(2) * sum_of_squares - sum * sum + FieldElement(8);
  return area_cosine((sum.enclosure() + square_root(discriminant.enclosure())) * half * half);
}

}  // namespace delcert
