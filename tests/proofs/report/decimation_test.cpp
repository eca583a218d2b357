#include "proofs/report/decimation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "proofs/report/worst_simplices.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;
using Labels = std::multiset<std::uint32_t>;

/// The labels of each simplex by its position in the certificate.
std::map<std::uint32_t, Labels> simplices_of(const Drawing& drawing) {
  const std::size_t corners = drawing.dimension + 1;
  std::map<std::uint32_t, Labels> result;
  for (std::size_t corner = 0; corner < drawing.simplices.size(); ++corner)
    result[drawing.positions[corner / corners]].insert(drawing.labels[drawing.simplices[corner]]);
  return result;
}

std::size_t in_stars_of_the_worst(const Drawing& drawing, std::set<std::uint32_t>& positions) {
  const auto simplices = simplices_of(drawing);
  std::set<std::uint32_t> labels;
  const auto add = [&](const std::vector<double>& values, bool least) {
    for (const std::uint32_t position : worst_simplices(values, least)) {
      const auto found = simplices.find(position);
      if (found != simplices.end()) labels.insert(found->second.begin(), found->second.end());
    }
  };
  add(drawing.measures.protection, true);
  add(drawing.measures.thickness, true);
  add(drawing.measures.circumradius, false);
  add(drawing.measures.hinge, true);
  for (const auto& [position, own] : simplices) {
    if (std::any_of(own.begin(), own.end(), [&](std::uint32_t label) { return labels.contains(label); }))
      positions.insert(position);
  }
  return positions.size();
}

TEST(Decimation, of_what_is_small_enough_leaves_all) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const Drawing same = decimated(drawing, drawing.simplex_count());
    EXPECT_EQ(same.simplices, drawing.simplices) << family;
    EXPECT_EQ(same.matching_faces.size(), drawing.matching_faces.size()) << family;
  }
}

TEST(Decimation, keeps_the_stars_of_the_worst_and_as_many_as_it_may) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    std::set<std::uint32_t> stars;
    const std::size_t least = in_stars_of_the_worst(drawing, stars);
    const std::size_t most = drawing.simplex_count() - 1;
    const Drawing part = decimated(drawing, most);
    EXPECT_EQ(part.simplex_count(), std::max(most, least)) << family;
    const auto whole = simplices_of(drawing), kept = simplices_of(part);
    for (const auto& [position, labels] : kept) EXPECT_EQ(labels, whole.at(position)) << family;
    for (const std::uint32_t position : stars) EXPECT_TRUE(kept.contains(position)) << family << " " << position;
    // Without room for more, only the stars.
    EXPECT_EQ(decimated(drawing, 1).simplex_count(), least) << family;
  }
}

TEST(Decimation, leaves_out_what_nothing_uses_and_keeps_places) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const Drawing part = decimated(drawing, 1);
    const std::set<std::uint32_t> used(part.simplices.begin(), part.simplices.end());
    EXPECT_EQ(used.size(), part.vertex_count()) << family;
    ASSERT_EQ(part.coordinates.size(), part.vertex_count() * part.ambient_dimension) << family;
    ASSERT_EQ(part.lifts.size(), part.vertex_count()) << family;
    // Every vertex is one of the whole drawing, with label, lift and coordinates.
    const auto vertices_of = [](const Drawing& one) {
      std::multiset<std::vector<double>> result;
      for (std::size_t vertex = 0; vertex < one.vertex_count(); ++vertex) {
        const auto first = one.coordinates.begin() + static_cast<std::ptrdiff_t>(vertex * one.ambient_dimension);
        std::vector<double> row(first, first + static_cast<std::ptrdiff_t>(one.ambient_dimension));
        row.push_back(one.labels[vertex]);
        row.push_back(one.lifts[vertex]);
        result.insert(row);
      }
      return result;
    };
    const auto all = vertices_of(drawing), own = vertices_of(part);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), own.begin(), own.end())) << family;
    EXPECT_LE(part.matching_faces.size(), drawing.matching_faces.size()) << family;
    for (const MatchingFaces& faces : part.matching_faces) {
      for (std::size_t corner = 0; corner < faces.first.size(); ++corner)
        EXPECT_EQ(part.labels.at(faces.first[corner]), part.labels.at(faces.second[corner])) << family;
    }
  }
}

TEST(Decimation, is_even) {
  const Drawing drawing = drawing_of(drawn_certificates().at("flat-torus"), {});
  const std::size_t half = drawing.simplex_count() / 2;
  const Drawing part = decimated(drawing, half);
  ASSERT_LE(part.simplex_count(), std::max(half, decimated(drawing, 1).simplex_count()));
  // What remains comes from the beginning and from the end.
  EXPECT_LT(part.positions.front(), drawing.positions[drawing.simplex_count() / 4]);
  EXPECT_GT(part.positions.back(), drawing.positions[3 * drawing.simplex_count() / 4]);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
