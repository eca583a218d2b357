#pragma once

#include <string>
#include <vector>

#include "kernel/chart/point_grid.hpp"

namespace delcert {

/// The squared length of a shortest non-zero vector of ℤᵐ in this metric: the square of the systole of the flat
/// torus, whose injectivity radius is half the systole. Exact, by enumeration of all integer vectors that could be
/// as short as a vector of a reduced basis.
template <int m>
[[nodiscard]] Rational squared_systole(const FrameMetric<m>& metric);

/// The Gram matrix of a basis of the same lattice that is reduced in the sense of Lenstra, Lenstra and Lovász with
/// δ = 99/100; that of the frame itself if this is reduced. Exact.
template <int m>
[[nodiscard]] Matrix<Rational, m> reduced_gram(const FrameMetric<m>& metric);

/// `gram = [["1", "0"], ["0", "1"]]`, as in a manifold file.
template <int m>
[[nodiscard]] std::string gram_text(const Matrix<Rational, m>& gram);

}  // namespace delcert
