#include "proofs/report/decimation.hpp"

#include <algorithm>
#include <limits>

#include "proofs/report/worst_simplices.hpp"

namespace delcert {

namespace {

using Numbers = std::vector<std::uint32_t>;
constexpr std::uint32_t left_out = std::numeric_limits<std::uint32_t>::max();

/// For each simplex of the drawing whether one of the worst has a label in common with it.
std::vector<char> in_stars_of_the_worst(const Drawing& drawing) {
  const std::size_t corners = drawing.dimension + 1;
  std::vector<char> is_worst(
      drawing.positions.empty() ? 0 : 1 + *std::max_element(drawing.positions.begin(), drawing.positions.end()));
  const auto mark = [&](const std::vector<double>& values, bool least_is_worst) {
    for (const std::uint32_t position : worst_simplices(values, least_is_worst)) {
      if (position < is_worst.size()) is_worst[position] = 1;
    }
  };
  mark(drawing.measures.protection, true);
  mark(drawing.measures.thickness, true);
  mark(drawing.measures.circumradius, false);
  mark(drawing.measures.hinge, true);

  std::vector<char> is_seen(
      drawing.labels.empty() ? 0 : 1 + *std::max_element(drawing.labels.begin(), drawing.labels.end()));
  const auto label = [&](std::size_t corner) { return drawing.labels[drawing.simplices[corner]]; };
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    if (is_worst[drawing.positions[simplex]] == 0) continue;
    for (std::size_t corner = 0; corner < corners; ++corner) is_seen[label(corners * simplex + corner)] = 1;
  }
  std::vector<char> result(drawing.simplex_count());
  for (std::size_t corner = 0; corner < drawing.simplices.size(); ++corner) {
    if (is_seen[label(corner)] != 0) result[corner / corners] = 1;
  }
  return result;
}

/// Keeps `more` of the simplices that are not kept yet, evenly spaced among them.
void keep_evenly(std::vector<char>& kept, std::size_t more) {
  const auto others = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 0));
  std::size_t seen = 0;
  for (char& one : kept) {
    if (one != 0) continue;
    // Of the first k of the others, ⌊k · more / others⌋ are kept.
    one = static_cast<char>((seen + 1) * more / others > seen * more / others);
    ++seen;
  }
}

/// The facets of the remaining simplices, each as increasing vertices; sorted.
std::vector<Numbers> facets_of(const Drawing& drawing) {
  const std::size_t corners = drawing.dimension + 1;
  std::vector<Numbers> result;
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    for (std::size_t opposite = 0; opposite < corners; ++opposite) {
      Numbers facet;
      for (std::size_t corner = 0; corner < corners; ++corner) {
        if (corner != opposite) facet.push_back(drawing.simplices[corners * simplex + corner]);
      }
      std::sort(facet.begin(), facet.end());
      result.push_back(std::move(facet));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Pairs of matching faces with their new vertices, where both are faces of remaining simplices of `part`.
std::vector<MatchingFaces> remaining_faces(const Drawing& drawing, const Numbers& new_numbers, const Drawing& part) {
  std::vector<MatchingFaces> result;
  if (drawing.matching_faces.empty()) return result;
  const std::vector<Numbers> facets = facets_of(part);
  for (MatchingFaces faces : drawing.matching_faces) {
    bool remain = true;
    for (Numbers* face : {&faces.first, &faces.second}) {
      for (std::uint32_t& vertex : *face) vertex = new_numbers[vertex];
      Numbers sorted = *face;
      std::sort(sorted.begin(), sorted.end());
      remain = remain && std::binary_search(facets.begin(), facets.end(), sorted);
    }
    if (remain) result.push_back(std::move(faces));
  }
  return result;
}

}  // namespace

Drawing decimated(const Drawing& drawing, std::size_t most) {
  if (drawing.simplex_count() <= most) return drawing;
  const std::size_t corners = drawing.dimension + 1;
  std::vector<char> kept = in_stars_of_the_worst(drawing);
  const auto in_stars = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 1));
  if (in_stars < most) keep_evenly(kept, most - in_stars);

  Drawing part = drawing;
  part.simplices.clear();
  part.positions.clear();
  part.coordinates.clear();
  part.labels.clear();
  part.lifts.clear();
  Numbers new_numbers(drawing.vertex_count(), left_out);
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    if (kept[simplex] == 0) continue;
    part.positions.push_back(drawing.positions[simplex]);
    for (std::size_t corner = 0; corner < corners; ++corner)
      new_numbers[drawing.simplices[corners * simplex + corner]] = 0;
  }
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    if (new_numbers[vertex] == left_out) continue;
    new_numbers[vertex] = static_cast<std::uint32_t>(part.labels.size());
    part.labels.push_back(drawing.labels[vertex]);
    part.lifts.push_back(drawing.lifts[vertex]);
    for (std::size_t axis = 0; axis < drawing.ambient_dimension; ++axis)
      part.coordinates.push_back(drawing.coordinates[drawing.ambient_dimension * vertex + axis]);
  }
  for (std::size_t corner = 0; corner < drawing.simplices.size(); ++corner) {
    if (kept[corner / corners] != 0) part.simplices.push_back(new_numbers[drawing.simplices[corner]]);
  }
  part.matching_faces = remaining_faces(drawing, new_numbers, part);
  return part;
}

}  // namespace delcert
