#include "kernel/manifold/quotient/invariant_form.hpp"

#include "support/error.hpp"

namespace delcert {

namespace {

std::string entry(std::size_t row, std::size_t column) {
  return "row " + std::to_string(row + 1) + ", entry " + std::to_string(column + 1);
}

/// The lower triangular L with G = LLᵀ.
std::vector<std::vector<BigInterval>> cholesky_factor(const FieldMatrix& gram) {
  const std::size_t n = gram.order();
  std::vector<std::vector<BigInterval>> result(n, std::vector<BigInterval>(n));
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      BigInterval rest = gram(row, column).enclosure();
      for (std::size_t k = 0; k < column; ++k) rest -= result[row][k] * result[column][k];
      result[row][column] = row == column ? square_root(rest) : rest / result[column][column];
    }
  }
  return result;
}

std::vector<std::vector<BigInterval>> product_of(const std::vector<std::vector<BigInterval>>& a,
                                                 const std::vector<std::vector<BigInterval>>& b) {
  const std::size_t n = a.size();
  std::vector<std::vector<BigInterval>> result(n, std::vector<BigInterval>(n));
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      for (std::size_t k = 0; k < n; ++k) result[row][column] += a[row][k] * b[k][column];
    }
  }
  return result;
}

}  // namespace

InvariantForm::InvariantForm(FieldElement time, FieldMatrix gram)
    : time_(std::move(time)),
      gram_(std::move(gram)),
      matrix_(gram_.order() + 1),
      curvature_(static_cast<Curvature>(time_.sign())) {
  const std::size_t m = gram_.order();
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < row; ++column) {
      if (!(gram_(row, column) == gram_(column, row)))
        throw InputError("gram, " + entry(row, column) + ": found " + gram_(row, column).text() + ", expected " +
                         gram_(column, row).text() + " as in " + entry(column, row) + ": the matrix is symmetric");
    }
  }
  if (!is_positive_definite(gram_)) throw InputError("gram is not positive definite");
  matrix_(0, 0) = time_;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) matrix_(row + 1, column + 1) = gram_(row, column);
  }
  inverse_gram_ = inverse(gram_);
}

InvariantForm InvariantForm::standard(Curvature curvature, int dimension) {
  return {FieldElement(sign_of(curvature)), FieldMatrix::identity(static_cast<std::size_t>(dimension))};
}

std::optional<std::string> InvariantForm::why_no_isometry(const FieldMatrix& a) const {
  const std::size_t n = matrix_.order();
  if (curvature_ == Curvature::zero) {
    for (std::size_t column = 0; column < n; ++column) {
      if (!(a(0, column) == FieldElement(column == 0 ? 1 : 0)))
        return entry(0, column) + " is " + a(0, column).text() + ", expected the first row 1, 0, …, 0";
    }
  }
  const FieldMatrix image = transposed(a) * matrix_ * a;
  const std::size_t first = curvature_ == Curvature::zero ? 1 : 0;
  for (std::size_t row = first; row < n; ++row) {
    for (std::size_t column = first; column < n; ++column) {
      if (!(image(row, column) == matrix_(row, column)))
        return "does not preserve the form: " + entry(row, column) + " of AᵀJA is " + image(row, column).text() +
               ", of J " + matrix_(row, column).text();
    }
  }
  if (curvature_ == Curvature::negative && a(0, 0).sign() <= 0)
    return "exchanges the sheets of the hyperboloid: row 1, entry 1 is " + a(0, 0).text();
  return std::nullopt;
}

FieldMatrix InvariantForm::inverse_of(const FieldMatrix& a) const {
  if (curvature_ == Curvature::zero) return inverse(a);
  // J⁻¹AᵀJ.
  const std::size_t n = matrix_.order();
  const FieldMatrix lowered = transposed(a) * matrix_;
  FieldMatrix result(n);
  for (std::size_t column = 0; column < n; ++column) {
    result(0, column) = lowered(0, column) / time_;
    for (std::size_t row = 1; row < n; ++row) {
      for (std::size_t k = 1; k < n; ++k) result(row, column) += inverse_gram_(row - 1, k - 1) * lowered(k, column);
    }
  }
  return result;
}

FieldVector InvariantForm::bisector(const FieldMatrix& a) const {
  FieldVector step = a.column(0);
  step[0] -= FieldElement(1);
  FieldVector result = matrix_ * step;
  if (curvature_ == Curvature::zero) {
    // 2⟨t, y⟩ ≤ |t|².
    result[0] = -pairing(step, result) / FieldElement(2);
  }
  return result;
}

FieldElement InvariantForm::dual_product(const FieldVector& a, const FieldVector& b) const {
  FieldElement result(0);
  for (std::size_t row = 1; row < a.size(); ++row) {
    for (std::size_t column = 1; column < b.size(); ++column)
      result += a[row] * inverse_gram_(row - 1, column - 1) * b[column];
  }
  return curvature_ == Curvature::zero ? result : result + a[0] * b[0] / time_;
}

FieldElement InvariantForm::displacement_of_origin(const FieldVector& first_column) const {
  if (curvature_ != Curvature::zero) return first_column[0];
  return pairing(first_column, matrix_ * first_column);
}

BigInterval InvariantForm::distance_from(const BigInterval& displacement) const {
  switch (curvature_) {
    case Curvature::negative:
      return area_cosine(displacement);
    case Curvature::zero:
      return square_root(displacement);
    default:
      return arccosine(displacement);
  }
}

BigInterval InvariantForm::displacement_of_ray(const FieldVector& ray) const {
  const BigInterval squared = pairing(ray, matrix_ * ray).enclosure();
  if (curvature_ == Curvature::zero) return squared / square(ray[0].enclosure());
  // x₀√(b/⟨x, x⟩): the first coordinate, in the standard basis, of the ray's point.
  return ray[0].enclosure() * square_root(time_.enclosure() / squared);
}

std::vector<std::vector<BigInterval>> InvariantForm::in_standard_basis(const FieldMatrix& a) const {
  const std::size_t n = matrix_.order();
  std::vector<std::vector<BigInterval>> result(n, std::vector<BigInterval>(n));
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) result[row][column] = a(row, column).enclosure();
  }
  if (curvature_ == Curvature::zero) return result;
  const auto factor = cholesky_factor(gram_);
  std::vector<std::vector<BigInterval>> change(n, std::vector<BigInterval>(n));
  std::vector<std::vector<BigInterval>> back = change;
  const BigInterval scale = square_root(absolute(time_.enclosure()));
  change[0][0] = scale;
  back[0][0] = BigInterval(1) / scale;
  for (std::size_t row = 1; row < n; ++row) {
    for (std::size_t column = row; column < n; ++column) change[row][column] = factor[column - 1][row - 1];
  }
  // The inverse of an upper triangular matrix, column by column.
  for (std::size_t column = 1; column < n; ++column) {
    for (std::size_t row = column; row >= 1; --row) {
      BigInterval rest(row == column ? 1 : 0);
      for (std::size_t k = row + 1; k <= column; ++k) rest -= change[row][k] * back[k][column];
      back[row][column] = rest / change[row][row];
    }
  }
  return product_of(product_of(change, result), back);
}

}  // namespace delcert
