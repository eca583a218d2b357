#pragma once

#include <algorithm>
#include <vector>

#include "proofs/checker/point_set.hpp"

namespace delcert::checker {

using Vertices = std::vector<Vertex>;

/// The non-empty subsets of the vertices, the larger first.
inline std::vector<Vertices> faces_of(const Vertices& vertices) {
  std::vector<Vertices> faces;
  for (unsigned subset = 1; subset < 1u << vertices.size(); ++subset) {
    Vertices& face = faces.emplace_back();
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      if ((subset >> k & 1) != 0) face.push_back(vertices[k]);
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Vertices& a, const Vertices& b) { return a.size() > b.size(); });
  return faces;
}

}  // namespace delcert::checker
