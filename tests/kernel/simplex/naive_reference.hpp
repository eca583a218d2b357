#pragma once

#include <cstddef>
#include <vector>

#include "kernel/simplex/cayley_menger.hpp"
#include "tests/kernel/simplex/instances.hpp"

// Section 2 taken at its word: every face, every altitude, from edge lengths by determinants. Shares no code with what
// it checks but the determinants.
namespace delcert::test {

/// Υ(σ)²
inline Rational naive_squared_thickness(const EdgeGram<Rational>& simplex) {
  const auto j = static_cast<long>(simplex.dimension());
  if (j == 0) return Rational(1);
  const Rational own = absolute(cayley_menger_determinant(simplex));
  if (own == Rational(0)) return Rational(0);
  Rational longest(0);
  Rational largest_facet(0);
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    for (std::size_t q = 0; q < p; ++q) longest = maximum(longest, simplex.squared_edge(p, q));
    largest_facet = maximum(largest_facet, absolute(cayley_menger_determinant(simplex.opposite_facet(p))));
  }
  return own / (Rational(2) * largest_facet) / (Rational(j * j) * longest);
}

inline std::vector<EdgeGram<Rational>> all_faces(const EdgeGram<Rational>& simplex) {
  std::vector<EdgeGram<Rational>> result;
  for (std::size_t mask = 1; mask < (std::size_t{1} << simplex.vertex_count()); ++mask) {
    std::vector<std::size_t> vertices;
    for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
      if ((mask >> i & 1U) != 0) vertices.push_back(i);
    }
    result.push_back(simplex.face(vertices));
  }
  return result;
}

inline bool naive_good(const EdgeGram<Rational>& simplex, const Rational& squared_flake_parameter) {
  for (const auto& face : all_faces(simplex)) {
    const Rational bound = power(squared_flake_parameter, static_cast<long>(face.dimension()));
    if (naive_squared_thickness(face) < bound) return false;
  }
  return true;
}

inline bool naive_flake(const EdgeGram<Rational>& simplex, const Rational& squared_flake_parameter) {
  if (naive_good(simplex, squared_flake_parameter)) return false;
  for (std::size_t p = 0; p < simplex.vertex_count() && simplex.dimension() > 0; ++p) {
    if (!naive_good(simplex.opposite_facet(p), squared_flake_parameter)) return false;
  }
  return true;
}

/// Γ₀² somewhere between clearly small and 1, or exactly at the threshold of some face of dimension 2.
inline Rational any_squared_flake_parameter(const EdgeGram<Rational>& simplex) {
  if (simplex.dimension() >= 2 && *rc::gen::inRange(0, 3) == 0) {
    const Rational thickness = naive_squared_thickness(simplex.face({0, 1, 2}));
    // Where thickness² is the square of a rational, the parameter is exactly at the threshold.
    const Rational root = square_root_lower(thickness, 60);
    if (root > Rational(0)) return root;
  }
  return ratio(1, *rc::gen::element(1, 2, 3, 4, 8, 30, 100, 1000, 100000));
}

}  // namespace delcert::test
