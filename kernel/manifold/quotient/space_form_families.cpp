#include "kernel/manifold/quotient/space_form_families.hpp"

#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// cos kα and sin kα/sin α for the angle α with this double cosine.
struct Turn {
  FieldElement cosine;
  FieldElement sine_quotient;
};

Turn turn(const FieldElement& double_cosine, int k) {
  // cos (k+1)α = 2cos α·cos kα − cos (k−1)α, and so for the quotients of sines.
  Turn before{double_cosine / FieldElement(2), FieldElement(-1)};
  Turn now{FieldElement(1), FieldElement(0)};
  for (int step = 0; step < k; ++step) {
    Turn next{double_cosine * now.cosine - before.cosine, double_cosine * now.sine_quotient - before.sine_quotient};
    before = std::move(now);
    now = std::move(next);
  }
  return now;
}

/// Sets the rotation by kα in the basis (1, 0), (0, sin α) of the plane of coordinates `first`, `first` + 1.
void set_rotation(FieldMatrix& matrix, std::size_t first, const Turn& turn, const FieldElement& squared_sine) {
  matrix(first, first) = turn.cosine;
  matrix(first, first + 1) = -(turn.sine_quotient * squared_sine);
  matrix(first + 1, first) = turn.sine_quotient;
  matrix(first + 1, first + 1) = turn.cosine;
}

FieldElement squared_sine_of(const FieldElement& double_cosine) {
  return FieldElement(1) - double_cosine * double_cosine / FieldElement(4);
}

}  // namespace

SpaceFormDescription sphere(int dimension) {
  return {"sphere-" + std::to_string(dimension), InvariantForm::standard(Curvature::positive, dimension), {}, "0", 1};
}

SpaceFormDescription projective_space(int dimension) {
  SpaceFormDescription result = sphere(dimension);
  result.name = "projective-space-" + std::to_string(dimension);
  FieldMatrix antipodal(static_cast<std::size_t>(dimension) + 1);
  for (std::size_t k = 0; k < antipodal.order(); ++k) antipodal(k, k) = FieldElement(-1);
  result.generators.push_back(std::move(antipodal));
  result.first_homology = "Z/2";
  result.order = 2;
  return result;
}

SpaceFormDescription lens_space(int p, int q) {
  if (p < 3) throw InputError("lens space with p = " + std::to_string(p) + ", expected 3 or more");
  const auto field = real_cyclotomic_field(p);
  const FieldElement cosine = double_cosine(field, p);
  const FieldElement squared_sine = squared_sine_of(cosine);
  FieldMatrix gram = FieldMatrix::identity(3);
  gram(0, 0) = squared_sine;
  gram(2, 2) = squared_sine;
  FieldMatrix generator(4);
  set_rotation(generator, 0, turn(cosine, 1), squared_sine);
  set_rotation(generator, 2, turn(cosine, ((q % p) + p) % p), squared_sine);
  return {"lens-space-" + std::to_string(p) + "-" + std::to_string(q),
          InvariantForm(FieldElement(1), std::move(gram)),
          {std::move(generator)},
          "Z/" + std::to_string(p),
          static_cast<std::size_t>(p)};
}

SpaceFormDescription regular_polygon_surface(int genus) {
  if (genus < 2) throw InputError("regular polygon surface of genus " + std::to_string(genus) + ", expected 2 or more");
  const int sides = 4 * genus;
  const auto field = real_cyclotomic_field(sides);
  const FieldElement cosine = double_cosine(field, sides);
  const FieldElement squared_sine = squared_sine_of(cosine);
  // The translation that takes one side to the opposite one, by twice the inradius ρ with cosh ρ = cot π/4g. In the
  // basis that stretches o by sinh 2ρ it is rational in cosh 2ρ = 2(1 + c)/(1 − c) − 1, 2c = `cosine`.
  const FieldElement boost =
      FieldElement(2) * (FieldElement(2) + cosine) / (FieldElement(2) - cosine) - FieldElement(1);
  const FieldElement stretch = boost * boost - FieldElement(1);
  FieldMatrix translation = FieldMatrix::identity(3);
  translation(0, 0) = boost;
  translation(0, 1) = FieldElement(1);
  translation(1, 0) = stretch;
  translation(1, 1) = boost;
  FieldMatrix gram = FieldMatrix::identity(2);
  gram(1, 1) = squared_sine;
  SpaceFormDescription result{"regular-polygon-surface-" + std::to_string(genus),
                              InvariantForm(-stretch, std::move(gram)),
                              {},
                              "Z^" + std::to_string(2 * genus),
                              {}};
  for (int k = 0; k < sides / 2; ++k) {
    FieldMatrix forward = FieldMatrix::identity(3);
    FieldMatrix backward = forward;
    Turn angle = turn(cosine, k);
    set_rotation(forward, 1, angle, squared_sine);
    angle.sine_quotient = -angle.sine_quotient;
    set_rotation(backward, 1, angle, squared_sine);
    result.generators.push_back(forward * translation * backward);
  }
  return result;
}

SpaceFormDescription product_with_circle(const SpaceFormDescription& surface, const Rational& length) {
  if (surface.form.curvature() != Curvature::zero || surface.form.dimension() != 2)
    throw InputError("the product of " + surface.name + " with a circle: expected a flat surface");
  if (length <= Rational(0))
    throw InputError("a circle of the length " + exact_text(length) + ", expected more than 0");
  const auto extended = [](const FieldMatrix& a, const FieldElement& last) {
    FieldMatrix result = FieldMatrix::identity(a.order() + 1);
    for (std::size_t row = 0; row < a.order(); ++row) {
      for (std::size_t column = 0; column < a.order(); ++column) result(row, column) = a(row, column);
    }
    result(a.order(), a.order()) = last;
    return result;
  };
  SpaceFormDescription result{
      surface.name + "-times-circle",
      InvariantForm(FieldElement(0), extended(surface.form.gram(), FieldElement(square(length)))),
      {},
      {},
      {}};
  for (const FieldMatrix& generator : surface.generators)
    result.generators.push_back(extended(generator, FieldElement(1)));
  return result;
}

FieldElement::Field real_cyclotomic_field(int n) {
  if (n < 1) throw InputError("2cos 2π/n with n = " + std::to_string(n) + ", expected 1 or more");
  fmpz_poly_t minimal;
  fmpz_poly_init(minimal);
  fmpz_poly_cos_minpoly(minimal, static_cast<ulong>(n));
  std::vector<Rational> coefficients;
  for (slong k = 0; k < fmpz_poly_length(minimal); ++k) {
    Integer coefficient;
    fmpz_get_mpz(coefficient.backend().data(), fmpz_poly_get_coeff_ptr(minimal, k));
    coefficients.emplace_back(coefficient);
  }
  fmpz_poly_clear(minimal);
  if (coefficients.size() == 2) return nullptr;
  const BigInterval angle = (half_turn() + half_turn()) / BigInterval(n);
  const BigInterval value = cosine(angle) + cosine(angle);
  return std::make_shared<const NumberField>(coefficients, value.lower(), value.upper());
}

FieldElement double_cosine(const FieldElement::Field& field, int n) {
  if (field) return {field, {Rational(0), Rational(1)}};
  switch (n) {
    case 1:
      return FieldElement(2);
    case 2:
      return FieldElement(-2);
    case 3:
      return FieldElement(-1);
    case 4:
      return FieldElement(0);
    case 6:
      return FieldElement(1);
    default:
      throw InputError("2cos 2π/" + std::to_string(n) + " without its field");
  }
}

}  // namespace delcert
