#pragma once

#include <memory>
#include <optional>

#include "proofs/checker/arithmetic/square_matrix.hpp"
#include "proofs/checker/certificate/cursor.hpp"

namespace delcert::checker {

/// A group of isometries of a model space, as a certificate states it.
struct SpaceForm {
  /// The part of the manifold block from the key "field" on. Throws Malformed.
  SpaceForm(int curvature, int dimension, Cursor& cursor);

  int K;
  std::size_t m;
  std::unique_ptr<NumberField> field;
  FieldElement time;
  FieldMatrix gram{0};
  std::vector<FieldMatrix> generators;
  Quantity injectivity_radius;

  /// diag(time, gram): the form that the generators preserve.
  FieldMatrix form() const;
  /// T = diag(sqrt |time|, L^T) with gram = L L^T (for K = 0: time counts as 1), to the basis in which the form is
  /// diag(K, 1, ..., 1); and its inverse. With the precision of balls.
  SquareMatrix<Ball> basis() const;
  SquareMatrix<Ball> inverse_basis() const;
  /// T A T^-1.
  SquareMatrix<Ball> in_standard_basis(const FieldMatrix& a) const;
};

/// Reads a coefficient list [c_0, c_1, ...] as the element c_0 + c_1 t + ... of the field.
FieldElement parse_element(Cursor& cursor, const NumberField& field);

}  // namespace delcert::checker
