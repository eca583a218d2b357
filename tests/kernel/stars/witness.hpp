#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernel/stars/proposal.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {

/// The vertices lie in a common open ball of this radius: about the circumcentre of one of their faces.
template <int m>
bool lies_in_an_open_ball(const FlatSpace<m>& space, const ExactPoints<m>& vertices, const Rational& radius) {
  for (std::size_t mask = 1; mask < (std::size_t{1} << vertices.size()); ++mask) {
    ExactPoints<m> face;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if ((mask >> i & 1U) != 0) face.push_back(vertices[i]);
    }
    const auto ball = ball_of_simplex<m>(space, face);
    if (!ball) continue;
    if (std::all_of(vertices.begin(), vertices.end(), [&](const auto& vertex) {
          return squared_distance<m>(space, vertex, ball->centre) < square(radius);
        })) {
      return true;
    }
  }
  return false;
}

/// (−1)^number of inversions.
inline int sign_of_order(const std::vector<std::uint32_t>& labels) {
  int sign = 1;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) sign = labels[j] > labels[i] ? -sign : sign;
  }
  return sign;
}

/// The signed number of times that each set of m labels bounds one of the simplices, as docs/certificate-format.md
/// counts (0.cycle); those with 0 left out.
template <int m>
std::map<std::vector<std::uint32_t>, int> uncancelled_faces(const std::vector<LiftedSimplex<m>>& simplices) {
  std::map<std::vector<std::uint32_t>, int> result;
  for (const auto& simplex : simplices) {
    for (std::size_t k = 0; k <= m; ++k) {
      std::vector<std::uint32_t> labels;
      for (std::size_t corner = 0; corner <= m; ++corner) {
        if (corner != k) labels.push_back(simplex[corner].index);
      }
      const int sign = sign_of_order(labels) * (k % 2 == 0 ? 1 : -1);
      std::sort(labels.begin(), labels.end());
      result[labels] += sign;
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

/// Why these simplices do not show that the torus is covered by their balls, of which that of a simplex is to have a
/// radius below radius_of(simplex); empty if they do (level 0).
template <int m, class RadiusOf>
std::string complaint_of_torus_cover(const FlatSpace<m>& space, const ExactPoints<m>& points,
                                     const std::vector<LiftedSimplex<m>>& simplices, const RadiusOf& radius_of) {
  Rational total(0);
  for (const auto& simplex : simplices) {
    const auto vertices = all_at<m>(points, std::span<const Lift<m>>(simplex));
    if (!lies_in_an_open_ball<m>(space, vertices, radius_of(simplex))) return "0.ball";
    total += edge_determinant<m>(vertices);
  }
  if (!uncancelled_faces<m>(simplices).empty()) return "0.cycle";
  return total == Rational(factorial(m)) ? "" : "0.degree";
}

/// Why these simplices do not show that the torus is within `radius` of the points; empty if they do (level 0).
template <int m>
std::string complaint_of_torus_witness(const FlatSpace<m>& space, const ExactPoints<m>& points,
                                       const std::vector<LiftedSimplex<m>>& simplices, const Rational& radius) {
  return complaint_of_torus_cover<m>(space, points, simplices, [&](const auto&) { return radius; });
}

}  // namespace delcert::test
