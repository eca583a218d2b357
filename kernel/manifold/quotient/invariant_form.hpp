#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/chart/curved_functions.hpp"
#include "kernel/manifold/quotient/field_matrix.hpp"

namespace delcert {

/// The form ⟨x, x⟩ = b·x₀² + yᵀGy on ℝ × ℝᵐ that a group preserves, over a number field. The sign of b is the
/// curvature: by a rational change of scale it is the linear model of 𝕊ᵐ, 𝔼ᵐ (x₀ = 1) or ℍᵐ in another basis, in which
/// the matrices need fewer roots than in an orthonormal one. The origin o is the point on the ray of (1, 0).
class InvariantForm {
 public:
  /// Throws InputError, naming the entry, unless G is symmetric and positive definite.
  InvariantForm(FieldElement time, FieldMatrix gram);
  /// diag(K, 1, …, 1).
  [[nodiscard]] static InvariantForm standard(Curvature curvature, int dimension);

  [[nodiscard]] Curvature curvature() const { return curvature_; }
  [[nodiscard]] int dimension() const { return static_cast<int>(gram_.order()); }
  [[nodiscard]] const FieldElement& time() const { return time_; }
  [[nodiscard]] const FieldMatrix& gram() const { return gram_; }
  /// diag(b, G), singular for curvature 0.
  [[nodiscard]] const FieldMatrix& matrix() const { return matrix_; }

  /// Why A is no isometry of the model space, for "generator 2 …"; nothing if it is one. An isometry has AᵀJA = J and,
  /// for negative curvature, A₀₀ > 0; for curvature 0 it has the first row (1, 0, …, 0) and RᵀGR = G.
  [[nodiscard]] std::optional<std::string> why_no_isometry(const FieldMatrix& a) const;

  /// A⁻¹. Precondition: A is an isometry.
  [[nodiscard]] FieldMatrix inverse_of(const FieldMatrix& a) const;

  /// The covector ℓ with ℓ·x ≤ 0 exactly where x is not closer to Ao than to o: the bisector's side that contains o.
  /// Precondition: A is an isometry that moves o.
  [[nodiscard]] FieldVector bisector(const FieldMatrix& a) const;

  /// ⟨ℓ, ℓ′⟩ for covectors: positive definite on normals of hyperplanes of the model space.
  [[nodiscard]] FieldElement dual_product(const FieldVector& a, const FieldVector& b) const;

  /// cos d, d², cosh d of the distance d of the points o and A·o, from the first column of A. For curvature 0, in the
  /// units of G.
  [[nodiscard]] FieldElement displacement_of_origin(const FieldVector& first_column) const;

  /// The distance d from such a value.
  [[nodiscard]] BigInterval distance_from(const BigInterval& displacement) const;
  /// The same of o and the point on this ray. Precondition for negative curvature: the ray is inside the cone.
  [[nodiscard]] BigInterval displacement_of_ray(const FieldVector& ray) const;

  /// TAT⁻¹ for the change of basis T = diag(√|b|, Lᵀ), G = LLᵀ, to the standard form diag(K, 1, …, 1), in which the
  /// run computes; T = 1 for curvature 0, where the run keeps the frame of G. Rows of enclosures.
  [[nodiscard]] std::vector<std::vector<BigInterval>> in_standard_basis(const FieldMatrix& a) const;

 private:
  FieldElement time_;
  FieldMatrix gram_;
  FieldMatrix matrix_;
  FieldMatrix inverse_gram_;
  Curvature curvature_;
};

}  // namespace delcert
