#include "proofs/checker/certificate/space_form.hpp"

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker {
namespace {

std::vector<Rational> parse_coefficients(Cursor& cursor) {
  std::vector<Rational> result;
  cursor.array([&] { result.push_back(exact_value(cursor.number())); });
  return result;
}

FieldMatrix parse_matrix(Cursor& cursor, const NumberField& field, std::size_t order) {
  FieldMatrix result(order);
  std::size_t i = 0;
  cursor.row(static_cast<int>(order), [&] {
    std::size_t k = 0;
    cursor.row(static_cast<int>(order), [&] { result(i, k++) = parse_element(cursor, field); });
    ++i;
  });
  return result;
}

}  // namespace

FieldElement parse_element(Cursor& cursor, const NumberField& field) {
  const std::vector<Rational> coefficients = parse_coefficients(cursor);
  if (coefficients.empty() || std::ssize(coefficients) > field.degree())
    cursor.fail("form.types", "as many coefficients as the degree of the field, or fewer, before this");
  return {field, coefficients};
}

SpaceForm::SpaceForm(int curvature, int dimension, Cursor& cursor)
    : K(curvature), m(static_cast<std::size_t>(dimension)) {
  cursor.expect(",\"field\":");
  const std::vector<Rational> polynomial = parse_coefficients(cursor);
  cursor.expect(",\"root\":");
  std::vector<Rational> ends;
  cursor.row(2, [&] { ends.push_back(exact_value(cursor.number())); });
  std::size_t bits = 0;
  for (const Rational& c : polynomial) bits += fmpz_bits(fmpq_numref(c.raw())) + fmpz_bits(fmpq_denref(c.raw()));
  if (polynomial.size() > 65 || bits > 65536) throw Undecided("the polynomial of the field is too large to factor");
  field = std::make_unique<NumberField>(polynomial, ends[0], ends[1]);
  cursor.expect(",\"time\":");
  time = parse_element(cursor, *field);
  cursor.expect(",\"gram\":");
  gram = parse_matrix(cursor, *field, m);
  cursor.expect(",\"generators\":");
  cursor.array([&] { generators.push_back(parse_matrix(cursor, *field, m + 1)); });
  cursor.expect(",\"injectivity_radius\":");
  injectivity_radius = Quantity(exact_value(cursor.number()));
  Report::require("form.ranges", time.sign() == K, "time has not the sign of the curvature");
  Report::require("form.ranges", injectivity_radius.exact.sign() >= 0, "injectivity_radius is negative");
  // Without these there is no basis to compute in.
  if (!(gram == gram.transposed())) throw Malformed("form.gram", "the gram matrix is not symmetric");
  if (is_positive_definite(gram) != Verdict::proved)
    throw Malformed("form.gram", "the gram matrix is not positive definite");
}

FieldMatrix SpaceForm::form() const {
  FieldMatrix result(m + 1);
  result(0, 0) = time;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) result(i + 1, k + 1) = gram(i, k);
  }
  return result;
}

SquareMatrix<Ball> SpaceForm::basis() const {
  SquareMatrix<Ball> T(m + 1);
  T(0, 0) = K == 0 ? Ball(1) : square_root(Ball(K) * time.enclosure());
  for (std::size_t i = 1; i <= m; ++i) {
    for (std::size_t k = i; k <= m; ++k) {
      Ball rest = gram(i - 1, k - 1).enclosure();
      for (std::size_t j = 1; j < i; ++j) rest = rest - T(j, i) * T(j, k);
      T(i, k) = i == k ? square_root(rest) : rest / T(i, i);
    }
  }
  return T;
}

SquareMatrix<Ball> SpaceForm::inverse_basis() const {
  const SquareMatrix<Ball> T = basis();
  SquareMatrix<Ball> result(m + 1);
  for (std::size_t k = 0; k <= m; ++k) {
    for (std::size_t i = k + 1; i-- > 0;) {
      Ball rest(i == k ? 1 : 0);
      for (std::size_t j = i + 1; j <= k; ++j) rest = rest - T(i, j) * result(j, k);
      result(i, k) = rest / T(i, i);
    }
  }
  return result;
}

SquareMatrix<Ball> SpaceForm::in_standard_basis(const FieldMatrix& a) const {
  SquareMatrix<Ball> enclosed(m + 1);
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t k = 0; k <= m; ++k) enclosed(i, k) = a(i, k).enclosure();
  }
  return basis() * enclosed * inverse_basis();
}

}  // namespace delcert::checker
