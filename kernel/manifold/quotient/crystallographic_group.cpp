#include "kernel/manifold/quotient/crystallographic_group.hpp"

#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>

#include <algorithm>
#include <map>
#include <string>

#include "kernel/manifold/quotient/lattice_points.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_linear_parts = 48;  // of a finite subgroup of GL(3, ℤ)

FieldMatrix linear_part(const FieldMatrix& a) {
  FieldMatrix result = a;
  for (std::size_t row = 1; row < a.order(); ++row) result(row, 0) = FieldElement(0);
  return result;
}

RationalVector translation_of(const FieldMatrix& a) {
  RationalVector result;
  for (std::size_t row = 1; row < a.order(); ++row) result.push_back(a(row, 0).rational());
  return result;
}

/// The same element, its translation taken into [0, 1)ᵐ.
FieldMatrix reduced(const FieldMatrix& a) {
  FieldMatrix result = a;
  for (std::size_t row = 1; row < a.order(); ++row) {
    const Rational t = a(row, 0).rational();
    result(row, 0) = FieldElement(t - Rational(floor_of(t)));
  }
  return result;
}

std::string text_of(const RationalVector& x) {
  std::string result;
  for (const Rational& entry : x) result += (result.empty() ? "(" : ", ") + exact_text(entry);
  return result + ")";
}

std::string text_of(const FieldMatrix& a) {
  std::string result;
  for (std::size_t row = 1; row < a.order(); ++row) {
    for (std::size_t column = 1; column < a.order(); ++column)
      result += (column > 1 ? ", " : row > 1 ? "], [" : "[[") + a(row, column).text();
  }
  return "x ↦ " + result + "]]x + " + text_of(translation_of(a));
}

std::int64_t integer_of(const Rational& x) { return x.numerator().convert_to<std::int64_t>(); }

/// A basis of the integer covectors n with n(R − 1) = 0: rows of the unimodular U of Hermite's form U(R − 1) = H that
/// belong to rows 0 of H.
RationalMatrix fixed_covectors(const FieldMatrix& a) {
  const auto m = static_cast<slong>(a.order() - 1);
  fmpz_mat_t difference;
  fmpz_mat_t form;
  fmpz_mat_t transform;
  fmpz_mat_init(difference, m, m);
  fmpz_mat_init(form, m, m);
  fmpz_mat_init(transform, m, m);
  for (slong row = 0; row < m; ++row) {
    for (slong column = 0; column < m; ++column) {
      const auto entry = a(static_cast<std::size_t>(row) + 1, static_cast<std::size_t>(column) + 1);
      fmpz_set_si(fmpz_mat_entry(difference, row, column), integer_of(entry.rational()) - (row == column ? 1 : 0));
    }
  }
  fmpz_mat_hnf_transform(form, transform, difference);
  RationalMatrix result;
  for (slong row = 0; row < m; ++row) {
    bool zero = true;
    for (slong column = 0; column < m; ++column) zero = zero && fmpz_is_zero(fmpz_mat_entry(form, row, column)) != 0;
    if (!zero) continue;
    RationalVector covector;
    for (slong column = 0; column < m; ++column) {
      Integer entry;
      fmpz_get_mpz(entry.backend().data(), fmpz_mat_entry(transform, row, column));
      covector.emplace_back(entry);
    }
    result.push_back(std::move(covector));
  }
  fmpz_mat_clear(difference);
  fmpz_mat_clear(form);
  fmpz_mat_clear(transform);
  return result;
}

RationalMatrix rational_gram(const InvariantForm& form) {
  const std::size_t m = form.gram().order();
  RationalMatrix result(m, RationalVector(m));
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) result[row][column] = form.gram()(row, column).rational();
  }
  return result;
}

/// The least |γx − x|² > 0, or 0, over all x and over the elements (R, t + z), z ∈ ℤᵐ, but the identity.
///
/// The part of t + z in the space fixed by R is what all points are displaced by at least. With covectors N as above,
/// N(t + z) runs through N·t + ℤᵏ, and the shortest vector w with N·w = c has |w|² = cᵀ(NG⁻¹Nᵀ)⁻¹c.
Rational least_displacement(const RationalMatrix& dual_gram, const FieldMatrix& element) {
  const RationalMatrix covectors = fixed_covectors(element);
  const std::size_t k = covectors.size();
  if (k == 0) return Rational(0);
  const RationalVector t = translation_of(element);
  RationalVector offset(k);
  RationalMatrix products(k, RationalVector(k));
  for (std::size_t row = 0; row < k; ++row) {
    for (std::size_t a = 0; a < t.size(); ++a) {
      offset[row] += covectors[row][a] * t[a];
      for (std::size_t column = 0; column < k; ++column) {
        for (std::size_t b = 0; b < t.size(); ++b)
          products[row][column] += covectors[row][a] * dual_gram[a][b] * covectors[column][b];
      }
    }
  }
  const bool is_integral =
      std::all_of(offset.begin(), offset.end(), [](const Rational& x) { return x.denominator() == 1; });
  if (is_integral && k < t.size()) return Rational(0);
  return least_squared_norm(inverse(products), offset);
}

/// ℤᵐ and one generator for each representative; the relations are those of the extension.
AbelianGroup abelianisation_of(const std::vector<FieldMatrix>& representatives) {
  const std::size_t m = representatives.front().order() - 1;
  const std::size_t count = representatives.size();
  std::map<FieldMatrix, std::size_t, Precedes> number;
  for (std::size_t at = 0; at < count; ++at) number.emplace(linear_part(representatives[at]), at);
  std::vector<std::vector<std::int64_t>> relations;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t column = 0; column < m; ++column) {
      std::vector<std::int64_t> relation(m + count);
      for (std::size_t row = 0; row < m; ++row)
        relation[row] = integer_of(representatives[a](row + 1, column + 1).rational()) - (row == column ? 1 : 0);
      relations.push_back(std::move(relation));
    }
    for (std::size_t b = 0; b < count; ++b) {
      const FieldMatrix product = representatives[a] * representatives[b];
      const std::size_t c = number.at(linear_part(product));
      std::vector<std::int64_t> relation(m + count);
      for (std::size_t row = 0; row < m; ++row)
        relation[row] = integer_of((product(row + 1, 0) - representatives[c](row + 1, 0)).rational());
      ++relation[m + c];
      --relation[m + a];
      --relation[m + b];
      relations.push_back(std::move(relation));
    }
  }
  return abelian_group(m + count, relations);
}

void require_integral(const std::vector<FieldMatrix>& generators) {
  for (std::size_t at = 0; at < generators.size(); ++at) {
    for (std::size_t row = 1; row < generators[at].order(); ++row) {
      for (std::size_t column = 1; column < generators[at].order(); ++column) {
        const FieldElement& entry = generators[at](row, column);
        if (!entry.is_rational() || entry.rational().denominator() != 1)
          throw Rejection("generator " + std::to_string(at + 1) + ": row " + std::to_string(row + 1) + ", entry " +
                          std::to_string(column + 1) + " is " + entry.text() +
                          ", expected an integer: coordinates are those of the lattice of translations");
      }
      if (!generators[at](row, 0).is_rational())
        throw Rejection("generator " + std::to_string(at + 1) + ": a translation by " + generators[at](row, 0).text() +
                        " is not rational in coordinates of the lattice");
    }
  }
}

}  // namespace

CrystallographicGroup crystallographic_group(const InvariantForm& form, const std::vector<FieldMatrix>& generators) {
  require_integral(generators);
  CrystallographicGroup group;
  group.representatives.push_back(FieldMatrix::identity(form.matrix().order()));
  std::map<FieldMatrix, std::size_t, Precedes> found{{group.representatives.front(), 0}};
  for (std::size_t at = 0; at < group.representatives.size(); ++at) {
    for (const FieldMatrix& generator : generators) {
      const FieldMatrix next = reduced(group.representatives[at] * generator);
      const auto [position, is_new] = found.try_emplace(linear_part(next), group.representatives.size());
      if (is_new) {
        if (group.representatives.size() == most_linear_parts)
          throw Rejection("the linear parts give more than " + std::to_string(most_linear_parts) + " elements");
        group.representatives.push_back(next);
        continue;
      }
      const FieldMatrix& known = group.representatives[position->second];
      if (known == next) continue;
      RationalVector extra = translation_of(next);
      const RationalVector other = translation_of(known);
      for (std::size_t axis = 0; axis < extra.size(); ++axis) extra[axis] -= other[axis];
      throw Rejection("the group contains the translation by " + text_of(extra) +
                      ", which is not integral: coordinates are those of the lattice of all translations");
    }
  }
  const RationalMatrix dual = inverse(rational_gram(form));
  for (const FieldMatrix& element : group.representatives) {
    const Rational least = least_displacement(dual, element);
    if (least == Rational(0))
      throw Rejection("the group does not act freely: up to a translation of the lattice, " + text_of(element) +
                      " fixes a point");
    if (group.squared_displacement == Rational(0) || least < group.squared_displacement)
      group.squared_displacement = least;
  }
  group.abelianisation = abelianisation_of(group.representatives);
  return group;
}

std::vector<FieldMatrix> short_elements(const InvariantForm& form, const CrystallographicGroup& group,
                                        const Rational& squared_radius) {
  const RationalMatrix gram = rational_gram(form);
  std::vector<FieldMatrix> result;
  for (const FieldMatrix& representative : group.representatives) {
    for (const RationalVector& t : lattice_points(gram, translation_of(representative), squared_radius)) {
      FieldMatrix element = representative;
      for (std::size_t row = 1; row < element.order(); ++row) element(row, 0) = FieldElement(t[row - 1]);
      if (!is_identity(element)) result.push_back(std::move(element));
    }
  }
  return result;
}

}  // namespace delcert
