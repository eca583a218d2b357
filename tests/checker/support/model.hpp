#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace delcert::checker_tests {

/// numerator / denominator, denominator > 0.
struct Fraction {
  long long numerator = 0;
  long long denominator = 1;

  double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
  /// One of the three spellings of the format: integer, hexadecimal float, fraction.
  std::string text() const;
};

Fraction operator+(const Fraction& a, const Fraction& b);
/// The largest multiple of 2^-40 that is <= value.
Fraction at_most(double value);

using Labels = std::vector<int>;

/// A triangulated point set from which certificates are made. It is known by its combinatorics, not computed by a
/// Delaunay algorithm: the lattice A_m^* has the Kuhn triangulation as its Delaunay triangulation, and small
/// perturbations do not change it.
struct Model {
  int m = 0;
  bool torus = true;
  std::vector<std::vector<int>> gram;  // of the torus
  Fraction radius;                     // of the ball
  Fraction epsilon, mu, rho;
  std::vector<std::vector<Fraction>> net, points;
  std::vector<Labels> net_simplices;       // of positive determinant
  std::vector<std::vector<Labels>> stars;  // for each label its simplices, without the label
  std::vector<bool> interior;
  // Of a basis that is not reduced: its columns in terms of one that is, the inverse of that matrix, the Gram matrix
  // there.
  std::vector<std::vector<int>> basis, inverse, reduced_gram;
};

/// The simplices of the stars, each once, as sorted sets in lexicographic order.
std::vector<Labels> simplices_of(const std::vector<std::vector<Labels>>& stars);

/// The integer vectors by which the lifts of the other vertices of a simplex nearest to its first one are moved.
std::vector<std::vector<int>> nearest_shifts(const Model& model, const Labels& simplex);

/// Margins in doubles, without error bounds.
struct Margins {
  double protection = 0, thickness = 0, circumradius = 0;
};

/// The lattice A_m^* with N^m points in the torus R^m/Z^m with G = (m + 1) I - J, perturbed by up to `size`/N in each
/// coordinate. The covering radius is sqrt(m (m + 2) / 12) / N, the separation sqrt(m)/N; epsilon is `stretch` times
/// the covering radius, mu the largest permitted value, about.
Model kuhn_torus(int m, int N, double stretch, double size, std::uint64_t seed);

/// Rows of points at distance h = 1/N, the rows at distance 7h/8 and shifted by h/2 in turn, in a disc of 13 epsilon;
/// the triangulated ball has radius 11 epsilon.
Model staggered_disc(int N, double size, std::uint64_t seed);

/// The same torus in another basis, the columns of an integer matrix of determinant 1 with the given inverse.
Model in_basis(const Model& model, const std::vector<std::vector<int>>& basis,
               const std::vector<std::vector<int>>& inverse);

/// What the stars of the perturbed points have; of the first `labels` only, if that is said.
Margins measure(const Model& model, int labels = 1 << 30);

/// The stars of the interior labels from the list of all simplices.
std::vector<std::vector<Labels>> stars_of(const std::vector<Labels>& simplices, const std::vector<bool>& interior);

/// The number of different simplices of the stars, and the Euler characteristic of the complex of their faces.
std::pair<long long, long long> count(const std::vector<std::vector<Labels>>& stars);

}  // namespace delcert::checker_tests
