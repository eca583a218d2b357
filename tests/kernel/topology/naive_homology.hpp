#pragma once

#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "tests/kernel/topology/known_complexes.hpp"

// The homology of small complexes from whole boundary matrices, without any reduction and without a library.
namespace delcert::test {

using NaiveMatrix = std::vector<std::vector<long long>>;

/// Makes the matrix diagonal by row and column operations and returns the diagonal without zeros.
inline std::vector<long long> naive_diagonal(NaiveMatrix a) {
  std::vector<long long> diagonal;
  const std::size_t rows = a.size(), columns = rows == 0 ? 0 : a[0].size();
  for (std::size_t t = 0; t < rows && t < columns; ++t) {
    for (;;) {
      std::size_t row = rows, column = columns;
      for (std::size_t i = t; i < rows; ++i) {
        for (std::size_t j = t; j < columns; ++j) {
          if (a[i][j] != 0 && (row == rows || std::abs(a[i][j]) < std::abs(a[row][column]))) row = i, column = j;
        }
      }
      if (row == rows) return diagonal;
      std::swap(a[t], a[row]);
      for (auto& line : a) std::swap(line[t], line[column]);
      bool clean = true;
      for (std::size_t i = t + 1; i < rows; ++i) {
        const long long factor = a[i][t] / a[t][t];
        for (std::size_t j = t; j < columns; ++j) a[i][j] -= factor * a[t][j];
        clean = clean && a[i][t] == 0;
      }
      for (std::size_t j = t + 1; j < columns; ++j) {
        const long long factor = a[t][j] / a[t][t];
        for (std::size_t i = t; i < rows; ++i) a[i][j] -= factor * a[i][t];
        clean = clean && a[t][j] == 0;
      }
      if (clean) break;
    }
    diagonal.push_back(std::abs(a[t][t]));
  }
  return diagonal;
}

/// d₁ | d₂ | … of ℤ/a₁ ⊕ ℤ/a₂ ⊕ …, without those that are 1.
inline std::vector<long long> naive_invariant_factors(std::vector<long long> orders) {
  for (std::size_t i = 0; i < orders.size(); ++i) {
    for (std::size_t j = i + 1; j < orders.size(); ++j) {
      const long long divisor = std::gcd(orders[i], orders[j]);
      orders[j] = orders[i] / divisor * orders[j];
      orders[i] = divisor;
    }
  }
  std::erase(orders, 1);
  return orders;
}

struct NaiveGroup {
  std::size_t free_rank = 0;
  std::vector<long long> torsion;
};

inline std::vector<NaiveGroup> naive_homology(const LabelComplex& complex) {
  std::vector<std::map<std::vector<std::uint32_t>, std::size_t>> faces(complex.corners());
  for (std::size_t simplex = 0; simplex < complex.size(); ++simplex) {
    for (unsigned subset = 1; subset < 1U << complex.corners(); ++subset) {
      std::vector<std::uint32_t> face;
      for (std::size_t corner = 0; corner < complex.corners(); ++corner) {
        if ((subset >> corner & 1U) != 0) face.push_back(complex.labels[simplex * complex.corners() + corner]);
      }
      std::sort(face.begin(), face.end());
      auto& known = faces[face.size() - 1];
      known.try_emplace(face, known.size());
    }
  }
  std::vector<NaiveGroup> result(complex.corners());
  std::size_t rank = 0;
  for (std::size_t k = 0; k < complex.corners(); ++k) {
    result[k].free_rank = faces[k].size() - rank;
    if (k + 1 == complex.corners()) break;
    NaiveMatrix boundary(faces[k].size(), std::vector<long long>(faces[k + 1].size(), 0));
    for (const auto& [face, column] : faces[k + 1]) {
      for (std::size_t omitted = 0; omitted < face.size(); ++omitted) {
        std::vector<std::uint32_t> facet = face;
        facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(omitted));
        boundary[faces[k].at(facet)][column] = omitted % 2 == 0 ? 1 : -1;
      }
    }
    const std::vector<long long> diagonal = naive_diagonal(boundary);
    rank = diagonal.size();
    result[k].free_rank -= rank;
    result[k].torsion = naive_invariant_factors(diagonal);
  }
  return result;
}

}  // namespace delcert::test
