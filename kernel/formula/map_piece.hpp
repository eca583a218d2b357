#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/formula/rational_function.hpp"

namespace delcert {

/// What a map does on a closed region: where some polynomials are not negative. A rational map is one piece without
/// conditions; a piecewise linear one has a piece for each pattern of signs of its absolute values.
struct MapPiece {
  std::vector<Polynomial> nonnegative;
  std::vector<RationalFunction> map;
};

/// Whether the polynomial has degree 0 or 1.
[[nodiscard]] bool is_affine(const Polynomial& p);
/// False if certainly no point makes all of these positive: those of degree 0 and 1 are decided exactly, by elimination
/// of one variable after the other; the others are not looked at.
[[nodiscard]] bool may_be_positive_together(const std::vector<Polynomial>& polynomials);

/// The pieces of the map that these plain formulas are, abs() allowed: those of regions with an interior, which cover
/// ℝᵐ. None if it is neither rational nor piecewise linear: with an absolute value all pieces and all that absolute
/// values are of have to be affine; or if it has more than 64 pieces.
[[nodiscard]] std::optional<std::vector<MapPiece>> pieces_of(const std::vector<ExpressionPointer>& formulas,
                                                             const std::vector<std::string>& variables,
                                                             const RingPointer& ring);

/// second∘first, by pieces: those of regions with an interior, as far as this is decided. None if a denominator becomes
/// 0 everywhere. Throws std::length_error for what is too large.
[[nodiscard]] std::optional<std::vector<MapPiece>> composed(const std::vector<MapPiece>& second,
                                                            const std::vector<MapPiece>& first);

/// A polynomial that has the sign of p(f) where no denominator of f vanishes.
[[nodiscard]] Polynomial sign_after(const Polynomial& p, const std::vector<RationalFunction>& f);

/// Whether they are the same functions, coordinate by coordinate.
[[nodiscard]] bool are_same(const std::vector<RationalFunction>& a, const std::vector<RationalFunction>& b);
/// Whether it is the identity.
[[nodiscard]] bool is_identity(const std::vector<RationalFunction>& map);

}  // namespace delcert
