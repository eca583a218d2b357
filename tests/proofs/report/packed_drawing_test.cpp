#include "proofs/report/packed_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/proofs/drawing/drawn_certificates.hpp"
#include "tests/proofs/report/unpacked.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;
using test::from_codes;
using test::from_planes;
using test::from_varints;
using test::stream_of;
using test::unpacked;
using Json = nlohmann::ordered_json;

/// A packed drawing as numbers again, read in another way than it was written.
struct Unpacked {
  Json description;
  std::string bytes;
  std::vector<std::vector<std::uint32_t>> rows;
  std::vector<std::uint32_t> labels;
  std::vector<std::vector<double>> axes;

  explicit Unpacked(const PackedDrawing& packed)
      : description(packed.description), bytes(unpacked(packed.block)), labels(varints(description.at("label"))) {
    for (const Json& axis : description.at("coordinates")) {
      axes.emplace_back();
      for (const std::uint32_t bits : from_planes(stream_of(bytes, axis), 4))
        axes.back().push_back(std::bit_cast<float>(bits));
    }
    std::vector<std::vector<std::uint32_t>> columns;
    for (const Json& column : description.at("simplices")) columns.push_back(varints(column));
    for (std::size_t at = 0; at < columns.at(0).size(); ++at) {
      bool same = at > 0;
      rows.emplace_back();
      for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::uint32_t before = same ? rows[at - 1][column] : column > 0 ? rows[at][column - 1] : 0;
        rows[at].push_back(before + columns[column][at]);
        same = same && columns[column][at] == 0;
      }
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> varints(const Json& entry) const {
    return from_varints(stream_of(bytes, entry));
  }
  [[nodiscard]] std::vector<double> measure(const char* name) const {
    const Json& entry = description.at("measures").at(name);
    return from_codes(stream_of(bytes, entry), entry);
  }
  /// The labels of a simplex, in increasing order.
  [[nodiscard]] std::vector<std::uint32_t> labels_of(std::size_t simplex) const {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t vertex : rows.at(simplex)) result.push_back(labels.at(vertex));
    std::sort(result.begin(), result.end());
    return result;
  }
};

TEST(PackedDrawing, has_every_simplex_where_it_was_with_its_measures) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const Unpacked back(packed_drawing(drawing, {}, {2, false, true}));
    ASSERT_EQ(back.rows.size(), drawing.simplex_count()) << family;
    const std::size_t corners = drawing.dimension + 1;
    // By places of corners, measures as they were.
    std::map<std::vector<std::array<float, 3>>, double> expected;
    const auto place = [](std::vector<std::array<float, 3>> corners_of_one) {
      std::sort(corners_of_one.begin(), corners_of_one.end());
      return corners_of_one;
    };
    for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
      std::vector<std::array<float, 3>> own;
      for (std::size_t corner = 0; corner < corners; ++corner) {
        std::array<float, 3> point{};
        for (std::size_t axis = 0; axis < drawing.ambient_dimension; ++axis)
          point[axis] = static_cast<float>(
              drawing.coordinates[drawing.ambient_dimension * drawing.simplices[corners * simplex + corner] + axis]);
        own.push_back(point);
      }
      expected[place(own)] = drawing.measures.thickness[drawing.positions[simplex]];
    }
    const std::vector<double> thickness = back.measure("thickness");
    ASSERT_EQ(thickness.size(), back.rows.size());
    for (std::size_t simplex = 0; simplex < back.rows.size(); ++simplex) {
      std::vector<std::array<float, 3>> own;
      for (const std::uint32_t vertex : back.rows[simplex])
        own.push_back({static_cast<float>(back.axes[0][vertex]), static_cast<float>(back.axes[1][vertex]),
                       static_cast<float>(back.axes[2][vertex])});
      const auto found = expected.find(place(own));
      ASSERT_NE(found, expected.end()) << family;
      EXPECT_NEAR(thickness[simplex] / found->second, 1, 1e-3) << family;
    }
  }
}

TEST(PackedDrawing, lists_the_worst_first_with_their_exact_values) {
  const Drawing drawing = drawing_of(drawn_certificates().at("bolza-surface"), {});
  const Unpacked back(packed_drawing(drawing, {}, {1, false, true}));
  const struct {
    const char* name;
    const std::vector<double>& values;
    bool least_is_worst;
  } cases[] = {{"protection", drawing.measures.protection, true},
               {"circumradius", drawing.measures.circumradius, false},
               {"hinge", drawing.measures.hinge, true}};
  for (const auto& [name, values, least_is_worst] : cases) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    if (!least_is_worst) std::reverse(sorted.begin(), sorted.end());
    const Json& worst = back.description.at("worst").at(name);
    ASSERT_EQ(worst.size(), 10U) << name;
    for (std::size_t at = 0; at < 10; ++at) EXPECT_EQ(worst.at(at).at(1).get<double>(), sorted[at]) << name;
    const auto first = worst.at(0).at(0).get<std::size_t>();
    const auto position = static_cast<std::size_t>(std::find(values.begin(), values.end(), sorted[0]) - values.begin());
    const auto& simplex = drawn_certificates().at("bolza-surface").simplices.at(position);
    EXPECT_EQ(back.labels_of(first), (std::vector<std::uint32_t>{simplex[0], simplex[1], simplex[2]})) << name;
  }
}

TEST(PackedDrawing, has_the_faces_that_match_by_their_new_numbers) {
  const Drawing drawing = drawing_of(drawn_certificates().at("klein-bottle"), {});
  const Unpacked back(packed_drawing(drawing, {}, {2, false, true}));
  const Json& matching = back.description.at("matching");
  const auto vertices = back.varints(matching.at("vertices")), steps = back.varints(matching.at("steps"));
  ASSERT_EQ(steps.size(), drawing.matching_faces.size());
  ASSERT_EQ(vertices.size(), 4 * steps.size());
  for (std::size_t at = 0; at < steps.size(); ++at) {
    const MatchingFaces& faces = drawing.matching_faces[at];
    EXPECT_EQ(matching.at("texts").at(steps[at]), faces.step);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(back.labels.at(vertices[4 * at + k]), drawing.labels[faces.first[k]]);
      EXPECT_EQ(back.labels.at(vertices[4 * at + k]), back.labels.at(vertices[4 * at + 2 + k]));
      EXPECT_NE(vertices[4 * at + k], vertices[4 * at + 2 + k]);
    }
  }
}

TEST(PackedDrawing, says_less_where_it_is_told_to) {
  const Drawing drawing = drawing_of(drawn_certificates().at("flat-torus"), {});
  const std::vector<std::string> exact{"1/3 2/5", "0 1"};
  const PackedDrawing most = packed_drawing(drawing, exact, {2, true, true});
  const PackedDrawing least = packed_drawing(drawing, exact, {1, false, false});
  EXPECT_LT(least.block.size(), most.block.size());
  EXPECT_EQ(stream_of(unpacked(most.block), most.description.at("exact")), "1/3 2/5\n0 1");
  EXPECT_TRUE(least.description.at("exact").is_null());
  EXPECT_TRUE(least.description.at("measures").at("circumradius").is_null());
  EXPECT_FALSE(least.description.at("measures").at("protection").is_null());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
