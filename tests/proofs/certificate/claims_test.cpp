#include "proofs/certificate/claims.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

using Names = std::vector<std::string>;
using Side = Margin::Side;
using Unit = Margin::Unit;

/// Every level with all that a family may state of it.
std::vector<Claims> samples() {
  const Rational x = Rational(1) / Rational(10);
  Claims flat;
  flat.input = InputClaim{true, {}};
  flat.stars = StarMargins{x, x, x};
  flat.manifold = ManifoldClaim{8, -2, true, {{1, {}}, {4, {}}, {1, {}}}};
  flat.stable_stars.emplace();
  flat.no_forbidden = "3 \"sets\"";
  flat.delaunay.emplace();
  flat.triangulation = TriangulationClaim{"space-form", {}};
  flat.metric = MetricClaim{true, {}};
  Claims curved = flat;
  curved.input = InputClaim{{}, InputClaim::Density{x, x, x}};
  curved.stable_stars->reach = x;
  curved.no_forbidden.reset();
  curved.delaunay->balls = DelaunayClaim::Balls{x, x};
  curved.triangulation->riemannian = TriangulationClaim::RiemannianSimplices{x, x};
  curved.metric = MetricClaim{true, x, x, Rational(2)};
  Claims field = curved;
  field.delaunay = DelaunayClaim{{}, DelaunayClaim::Stability{x, x}};
  Claims submanifold = field;
  submanifold.full_stars.emplace();
  submanifold.triangulation = TriangulationClaim{"graph", {}, TriangulationClaim::Graph{x, Rational(2) * x}};
  submanifold.isotopy = IsotopyClaim{x};
  Claims with_slivers = submanifold;
  with_slivers.isotopy = IsotopyClaim{{}, x};
  return {flat, curved, field, submanifold, with_slivers};
}

std::string text_of(const Claims& claims) {
  std::string result;
  for (const ClaimedLevel& level : claimed_levels(claims)) {
    result += level.name + ":";
    for (const LevelEntry& entry : level.entries) result += " " + entry.key + "=" + entry.json;
    result += "\n";
  }
  return result;
}

TEST(Claims, name_the_hypotheses_unless_they_are_the_printed_ones) {
  Claims claims;
  claims.input = InputClaim{true, {}, ParameterConstraints::sharper};
  EXPECT_EQ(text_of(claims), "0: hypotheses_2=true hypotheses=\"sharper\"\n");
  claims.input->hypotheses_2 = false;
  EXPECT_EQ(text_of(claims), "0: hypotheses_2=false\n");
}

TEST(Claims, are_stated_by_the_keys_of_the_format) {
  const auto all = samples();
  EXPECT_EQ(text_of(all[0]),
            "0: hypotheses_2=true\n"
            "1: protection=\"1/10\" thickness=\"1/10\" circumradius=\"1/10\"\n"
            "2: simplices=8 euler_characteristic=-2 closed=true homology=[\"Z\",\"Z^4\",\"Z\"]\n"
            "2s:\n"
            "3: tested=\"3 \\\"sets\\\"\"\n"
            "4:\n"
            "5: route=\"space-form\"\n"
            "6: self_delaunay=true bilipschitz=\"1\"\n");
  EXPECT_EQ(text_of(all[1]),
            "0: density=\"1/10\" distortion=\"1/10\" metric_distortion=\"1/10\"\n"
            "1: protection=\"1/10\" thickness=\"1/10\" circumradius=\"1/10\"\n"
            "2: simplices=8 euler_characteristic=-2 closed=true homology=[\"Z\",\"Z^4\",\"Z\"]\n"
            "2s: reach=\"1/10\"\n"
            "4: protection=\"1/10\" circumradius=\"1/10\"\n"
            "5: route=\"space-form\" thickness=\"1/10\" radius=\"1/10\"\n"
            "6: self_delaunay=true weight=\"1/10\" bilipschitz=[\"1/10\",\"2\"]\n");
  EXPECT_NE(text_of(all[3]).find("1f:\n2: "), std::string::npos);
  EXPECT_NE(
      text_of(all[3]).find("5: route=\"graph\" contraction=\"1/10\" displacement=\"1/5\"\n5i: margin=\"1/10\"\n6: "),
      std::string::npos);
  EXPECT_NE(text_of(all[4]).find("\n5i: cosine=\"1/10\"\n6: "), std::string::npos);
  EXPECT_NE(text_of(all[2]).find("4: edge=\"1/10\" margin=\"1/10\"\n"), std::string::npos);
}

TEST(Claims, are_bounds_from_the_side_and_in_the_unit_of_the_theorem) {
  std::map<std::string, std::pair<Side, Unit>> found;
  for (const Claims& claims : samples()) {
    for (const ClaimedLevel& level : claimed_levels(claims)) {
      for (const LevelEntry& entry : level.entries) {
        if (entry.margins.size() == 1)
          found[level.name + "." + entry.key] = {entry.margins[0].side, entry.margins[0].unit};
      }
    }
  }
  const std::map<std::string, std::pair<Side, Unit>> expected{
      {"0.density", {Side::upper, Unit::length}},        {"0.distortion", {Side::upper, Unit::one}},
      {"0.metric_distortion", {Side::upper, Unit::one}}, {"1.protection", {Side::lower, Unit::length}},
      {"1.thickness", {Side::lower, Unit::one}},         {"1.circumradius", {Side::upper, Unit::length}},
      {"2s.reach", {Side::upper, Unit::length}},         {"4.protection", {Side::lower, Unit::length}},
      {"4.circumradius", {Side::upper, Unit::length}},   {"4.edge", {Side::lower, Unit::length}},
      {"4.margin", {Side::lower, Unit::squared_length}}, {"5.thickness", {Side::lower, Unit::one}},
      {"5.radius", {Side::upper, Unit::length}},         {"6.weight", {Side::lower, Unit::one}},
      {"5.contraction", {Side::upper, Unit::one}},       {"5.displacement", {Side::upper, Unit::length}},
      {"5i.margin", {Side::lower, Unit::length}},        {"5i.cosine", {Side::lower, Unit::one}}};
  EXPECT_EQ(found, expected);
  const auto stretch = claimed_levels(samples()[1]).back().entries.back().margins;
  ASSERT_EQ(stretch.size(), 2U);
  EXPECT_EQ(stretch[0].side, Side::lower);
  EXPECT_EQ(stretch[1].side, Side::upper);
  EXPECT_EQ(stretch[1].value, Rational(2));
}

TEST(Claims, name_the_levels_in_order) {
  const auto all = samples();
  EXPECT_EQ(all[0].names(), (Names{"0", "1", "2", "2s", "3", "4", "5", "6"}));
  EXPECT_EQ(all[1].names(), (Names{"0", "1", "2", "2s", "4", "5", "6"}));
  EXPECT_TRUE(Claims{}.names().empty());
  EXPECT_EQ(all[3].names(), (Names{"0", "1", "1f", "2", "2s", "4", "5", "5i", "6"}));
  EXPECT_EQ(all_levels(), (Names{"0", "1", "1f", "2", "2s", "3", "4", "5", "5i", "6"}));
  EXPECT_TRUE(selects(all_levels(), "2s"));
  EXPECT_FALSE(selects({"2"}, "2s"));
}

TEST(Claims, of_a_manifold_are_read_off_its_labels) {
  // The boundary of a tetrahedron.
  const PureComplex sphere(Dimension(2), {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3});
  const ManifoldClaim claim = manifold_claim(sphere, 4, true);
  EXPECT_EQ(claim.simplices, 4U);
  EXPECT_EQ(claim.euler_characteristic, 2);
  EXPECT_EQ(group_text(claim.homology[2]), "Z");
  EXPECT_EQ(manifold_claim(PureComplex(Dimension(2), {0, 1, 2}), 1, false).euler_characteristic, 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
