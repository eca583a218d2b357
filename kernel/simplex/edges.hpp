#pragma once

#include <vector>

#include "kernel/simplex/edge_gram.hpp"

namespace delcert {

/// |p_i − p_j|² for 0 ≤ i < j ≤ k, in lexicographic order; empty for a vertex.
template <Scalar S>
[[nodiscard]] std::vector<S> squared_edges(const EdgeGram<S>& simplex) {
  std::vector<S> result;
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    for (std::size_t j = i + 1; j < simplex.vertex_count(); ++j) result.push_back(simplex.squared_edge(i, j));
  }
  return result;
}

/// Δ(σ)²; 0 for a vertex.
template <Scalar S>
[[nodiscard]] S squared_longest_edge(const EdgeGram<S>& simplex) {
  S result(0);
  for (std::size_t i = 1; i < simplex.vertex_count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) result = maximum(result, simplex.squared_edge(i, j));
  }
  return result;
}

/// L(σ)². Throws std::invalid_argument for a vertex, which has no edge.
template <Scalar S>
[[nodiscard]] S squared_shortest_edge(const EdgeGram<S>& simplex) {
  const std::vector<S> edges = squared_edges(simplex);
  if (edges.empty()) throw std::invalid_argument("a vertex has no shortest edge");
  S result = edges.front();
  for (const S& edge : edges) result = minimum(result, edge);
  return result;
}

/// Δ(σ), on the rungs that have square roots.
template <Scalar S>
[[nodiscard]] S longest_edge(const EdgeGram<S>& simplex) {
  return square_root(squared_longest_edge(simplex));
}

/// L(σ), on the rungs that have square roots. Throws std::invalid_argument for a vertex.
template <Scalar S>
[[nodiscard]] S shortest_edge(const EdgeGram<S>& simplex) {
  return square_root(squared_shortest_edge(simplex));
}

}  // namespace delcert
