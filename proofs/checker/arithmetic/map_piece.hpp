#pragma once

#include <vector>

#include "proofs/checker/arithmetic/rational_function.hpp"

namespace delcert::checker {

/// What a map does where polynomials are not negative: a rational map is one piece without conditions.
struct MapPiece {
  RationalMap map;
  std::vector<Polynomial> nonnegative;
};

bool is_affine(const Polynomial& p);
/// False if certainly no point makes all of these positive: affine ones are decided exactly, by elimination; the others
/// are not looked at.
bool may_be_positive_together(const std::vector<Polynomial>& polynomials);

/// The pieces whose regions have an interior; they cover R^m. Without absolute values: one. Otherwise all of them, and
/// what absolute values are of, have to be affine. Throws Malformed (form.formula).
std::vector<MapPiece> pieces_of(std::size_t m, const FormulaMap& f);

/// Polynomials that have the signs of these after the map, where none of its denominators vanishes.
std::vector<Polynomial> signs_after(const std::vector<Polynomial>& polynomials, const RationalMap& map);
/// The one and then the other; none if something is divided by what is 0 everywhere.
std::optional<MapPiece> composed_pieces(const MapPiece& first, const MapPiece& second);

}  // namespace delcert::checker
