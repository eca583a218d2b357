#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/checker/core_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests::by_hand {
namespace {

using checker::FieldElement;
using checker::FieldMatrix;
using checker::Label;
using checker::Quantity;
using checker::Rational;
using Rules = std::vector<std::string>;

struct Core : testing::Test {
  const test::Upwards upwards;
};

void expect_verified(const CoreSample& sample, std::size_t points, std::size_t simplices) {
  EXPECT_EQ(broken_rules(sample), Rules{});
  EXPECT_EQ(sample.coordinates.size(), points);
  EXPECT_EQ(sample.data.simplices(), simplices);
}

/// The number of the simplex with these labels.
std::size_t simplex_with(const CoreSample& sample, const std::vector<Label>& labels) {
  for (std::size_t s = 0; s < sample.data.simplices(); ++s) {
    if (std::equal(labels.begin(), labels.end(), &sample.data.labels[s * (sample.m() + 1)])) return s;
  }
  ADD_FAILURE() << "no such simplex";
  return 0;
}

TEST_F(Core, verifies_tori_of_every_dimension) {
  expect_verified(grid_torus(1, 3), 3, 3);
  expect_verified(grid_torus(2, 3), 9, 18);
  expect_verified(grid_torus(3, 3), 27, 162);
  expect_verified(grid_torus(4, 3), 81, 1944);
}

TEST_F(Core, verifies_spheres_and_projective_spaces) {
  expect_verified(icosahedron(false), 12, 20);
  expect_verified(icosahedron(true), 6, 10);
  expect_verified(cross_polytope(2), 6, 8);
  expect_verified(cross_polytope(3), 8, 16);
  expect_verified(cell_600(false), 120, 600);
  expect_verified(cell_600(true), 60, 300);
}

TEST_F(Core, verifies_a_klein_bottle) {
  const CoreSample sample = klein_bottle();
  EXPECT_EQ(broken_rules(sample), Rules{});
  EXPECT_EQ(sample.data.simplices(), 2 * sample.coordinates.size());
}

TEST_F(Core, verifies_the_bolza_surface) {
  const CoreSample sample = bolza_surface();
  EXPECT_EQ(broken_rules(sample), Rules{});
  EXPECT_EQ(sample.data.simplices(), 2 * sample.coordinates.size() + 4);  // the Euler characteristic is -2
}

// One forgery a rule, which no other rule sees.

/// An edge that has two relative elements although all positions agree: K is a sphere, but it is said to be the
/// quotient by half a turn, which has fixed points.
TEST_F(Core, refuses_two_elements_on_an_edge) {
  CoreSample sample = cross_polytope(2);
  FieldMatrix turn = FieldMatrix::identity(3);
  turn(0, 0) = turn(1, 1) = FieldElement(-1);  // about the points 4 and 5
  sample.data.generators = {turn};
  sample.data.words = {{0, 1}};
  const auto turned = static_cast<std::uint32_t>(simplex_with(sample, {0, 3, 4}));
  const auto beside = static_cast<std::uint32_t>(simplex_with(sample, {0, 2, 4}));
  sample.data.elements[turned * 2 + 1] = 1;  // of the vertex 4
  sample.data.loops = {{{turned, 0, 2}, {beside, 2, 0}}};
  EXPECT_EQ(broken_rules(sample), Rules{"core.edges"});
}

/// With one more step along an edge that has no element, the loop has the element of its generator and ends elsewhere.
TEST_F(Core, refuses_a_loop_that_is_not_closed) {
  CoreSample sample = grid_torus(2, 4);
  std::uint32_t s = 0;
  while (sample.data.labels[s * 3] != 0 || sample.data.elements[s * 2] != 0) ++s;
  EXPECT_EQ(broken_rules(sample), Rules{});
  sample.data.loops[0].push_back({s, 0, 1});
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
}

TEST_F(Core, refuses_a_wrong_relative_element) {
  CoreSample sample = grid_torus(2, 4);
  sample.data.elements[0] = sample.data.elements[0] == 1 ? 2 : 1;
  const Rules rules = broken_rules(sample);
  EXPECT_NE(std::find(rules.begin(), rules.end(), "core.edges"), rules.end());
}

/// A sphere over a sphere, branched at two poles, at which the triangles go round twice.
TEST_F(Core, refuses_a_fan_that_closes_twice_round) {
  CoreSample sample = cross_polytope(2);
  const auto points = sample.coordinates;
  sample.data.labels.clear();
  sample.data.elements.clear();
  // The poles are 0 and 1; the equator is 2, 4, 3, 5 and once more.
  sample.coordinates = {points[0], points[1]};
  for (int round = 0; round < 2; ++round) {
    for (const std::size_t at : {2U, 4U, 3U, 5U}) sample.coordinates.push_back(points[at]);
  }
  for (Label k = 0; k < 8; ++k) {
    const Label a = 2 + std::min(k, (k + 1) % 8), b = 2 + std::max(k, (k + 1) % 8);
    sample.add({0, a, b}, {0, 0, 0});
    sample.add({1, a, b}, {0, 0, 0});
  }
  sample.place_points();
  EXPECT_EQ(broken_rules(sample), Rules{"core.stars"});
}

TEST_F(Core, refuses_two_sheets_with_one_label_in_common) {
  CoreSample sample = cross_polytope(2);
  const std::size_t simplices = sample.data.simplices();
  for (Label j = 1; j < 6; ++j) sample.coordinates.push_back(sample.coordinates[j]);
  for (std::size_t s = 0; s < simplices; ++s) {
    std::vector<Label> labels(&sample.data.labels[3 * s], &sample.data.labels[3 * s] + 3);
    for (Label& j : labels) j += j == 0 ? 0 : 5;
    sample.add(labels, {0, 0, 0});
  }
  sample.place_points();
  EXPECT_EQ(broken_rules(sample), Rules{"core.stars"});
}

/// The same in dimension 3, about an edge: the suspension of the branched sphere.
TEST_F(Core, refuses_tetrahedra_that_go_twice_round_an_edge) {
  CoreSample sample = cross_polytope(3);
  const auto points = sample.coordinates;
  sample.data.labels.clear();
  sample.data.elements.clear();
  sample.coordinates = {points[0], points[1], points[2], points[3]};
  for (int round = 0; round < 2; ++round) {
    for (const std::size_t at : {4U, 6U, 5U, 7U}) sample.coordinates.push_back(points[at]);
  }
  for (Label k = 0; k < 8; ++k) {
    const Label a = 4 + std::min(k, (k + 1) % 8), b = 4 + std::max(k, (k + 1) % 8);
    for (const Label pole : {0U, 1U}) {
      for (const Label other : {2U, 3U}) sample.add({pole, other, a, b}, {0, 0, 0, 0});
    }
  }
  sample.place_points();
  EXPECT_EQ(broken_rules(sample), Rules{"core.stars"});
}

TEST_F(Core, refuses_a_hole) {
  CoreSample sample = icosahedron(false);
  sample.remove(sample.data.simplices() - 1);
  EXPECT_EQ(broken_rules(sample), Rules{"core.facets"});
}

TEST_F(Core, refuses_a_facet_with_three_simplices) {
  // A triangle more, which no star has as its first one and none of whose directions is that of a witness.
  const CoreSample original = grid_torus(2, 5);
  std::size_t found = 0;
  for (Label a = 0; a < 25 && found == 0; ++a) {
    for (Label b = a + 1; b < 25 && found == 0; ++b) {
      for (Label c = b + 1; c < 25 && found == 0; ++c) {
        CoreSample sample = original;
        sample.add({a, b, c}, {0, 0, 0});
        found += broken_rules(sample) == Rules{"core.facets"} ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(found, 1U);
}

/// The vertex 12 of a torus is drawn across an edge of its link: the triangle there is turned over. Whenever one
/// is, the rule of facets and that of stars see it, whatever local Delaunay says.
TEST_F(Core, refuses_one_simplex_that_is_turned_over) {
  const CoreSample original = grid_torus(2, 5);
  std::set<Rules> found;
  for (int direction = 0; direction < 64; ++direction) {
    CoreSample sample = original;
    for (std::size_t k = 0; k < 2; ++k) {
      const int steps = (k == 0 ? direction % 8 : direction / 8) * 2 - 7;
      sample.coordinates[12][k] = sample.coordinates[12][k] + Rational(steps) / Rational(24);
    }
    sample.place_points();
    found.insert(broken_rules(sample));
  }
  EXPECT_EQ(found,
            (std::set<Rules>{
                {}, {"core.hinges"}, {"core.facets", "core.stars"}, {"core.facets", "core.hinges", "core.stars"}}));
}

/// Three points north of the equator and the pole: what is meant to be the large triangle is the small one.
TEST_F(Core, refuses_a_simplex_too_large_for_its_hemisphere) {
  const auto pyramid = [](double height) {
    CoreSample sample =
        polytope(2, {{0, 0, 1, 0}, {1, 0, height, 0}, {-0.5, 0.75, height, 0}, {-0.5, -0.75, height, 0}}, false);
    sample.data.labels = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
    sample.data.elements = std::vector<std::uint32_t>(8, 0);
    sample.place_points();
    return sample;
  };
  EXPECT_EQ(broken_rules(pyramid(-0.25)), Rules{});
  const Rules rules = broken_rules(pyramid(0.25));
  EXPECT_NE(std::find(rules.begin(), rules.end(), "core.facets"), rules.end());
}

TEST_F(Core, refuses_a_flat_simplex) {
  // The edge {6, 7} gets a vertex in its middle, on one side only; on the other side there is a flat triangle.
  CoreSample sample = grid_torus(2, 5);
  std::vector<std::size_t> at_edge;
  for (std::size_t s = 0; s < sample.data.simplices(); ++s) {
    const Label* labels = &sample.data.labels[3 * s];
    if (std::count(labels, labels + 3, 6) + std::count(labels, labels + 3, 7) == 2) at_edge.push_back(s);
  }
  ASSERT_EQ(at_edge.size(), 2U);
  const Label* labels = &sample.data.labels[3 * at_edge[0]];
  const Label apex = labels[0] + labels[1] + labels[2] - 13;
  sample.coordinates.push_back(sample.coordinates[6]);
  for (std::size_t k = 0; k < 2; ++k)
    sample.coordinates[25][k] = (sample.coordinates[6][k] + sample.coordinates[7][k]) / Rational(2);
  sample.remove(at_edge[0]);
  for (const Label end : {6U, 7U}) sample.add({std::min(apex, end), std::max(apex, end), 25}, {0, 0, 0});
  sample.add({6, 7, 25}, {0, 0, 0});
  sample.place_points();
  sample.find_loops();
  EXPECT_EQ(broken_rules(sample), Rules{"core.sign"});
}

TEST_F(Core, refuses_a_hinge_that_is_not_locally_delaunay) {
  CoreSample sample = grid_torus(2, 5);
  // The squares have the corners {0, 1, 5, 6} and the diagonal {0, 6}.
  sample.remove(simplex_with(sample, {0, 1, 6}));
  sample.remove(simplex_with(sample, {0, 5, 6}));
  sample.add({0, 1, 5}, {0, 0, 0});
  sample.add({1, 5, 6}, {0, 0, 0});
  sample.find_loops();
  EXPECT_EQ(broken_rules(sample), Rules{"core.hinges"});
}

/// The double cover of the torus, said to be the torus: the loop goes along twice the generator.
TEST_F(Core, refuses_a_double_cover) {
  CoreSample sample = covering_torus(3);
  EXPECT_TRUE(sample.data.loops[0].empty());
  CoreSample doubled = sample;
  doubled.data.generators[0](1, 0) = FieldElement(2);
  doubled.find_loops();
  EXPECT_EQ(broken_rules(doubled), Rules{});
  sample.data.loops = doubled.data.loops;
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
  sample.data.loops.erase(sample.data.loops.begin());
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
}

TEST_F(Core, refuses_a_group_that_is_too_small) {
  CoreSample sample = icosahedron(true);
  sample.data.generators.clear();
  sample.data.loops.clear();
  sample.data.words.clear();
  std::fill(sample.data.elements.begin(), sample.data.elements.end(), 0);
  EXPECT_NE(broken_rules(sample), Rules{});
}

TEST_F(Core, refuses_loops_that_are_not_along_generators) {
  const CoreSample original = klein_bottle();
  ASSERT_EQ(broken_rules(original), Rules{});
  CoreSample sample = original;
  std::swap(sample.data.loops[1], sample.data.loops[2]);
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
  sample = original;
  sample.data.loops[0].pop_back();  // does not end at label 0
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
  sample = original;
  sample.data.loops[2] = sample.data.loops[1];
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
}

TEST_F(Core, refuses_a_generator_that_is_no_isometry) {
  CoreSample sample = klein_bottle();
  sample.data.generators[0](1, 1) = FieldElement(2);
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
  sample = bolza_surface();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      sample.data.generators[0](i, k) = FieldElement(0) - sample.data.generators[0](i, k);  // exchanges the sheets
  }
  EXPECT_EQ(broken_rules(sample), Rules{"core.group"});
}

TEST_F(Core, refuses_two_components) {
  CoreSample sample = cross_polytope(2);
  const std::size_t simplices = sample.data.simplices();
  for (Label j = 0; j < 6; ++j) sample.coordinates.push_back(sample.coordinates[j]);
  for (std::size_t s = 0; s < simplices; ++s) {
    const Label* labels = &sample.data.labels[3 * s];
    const std::vector<Label> others{labels[0] + 6, labels[1] + 6, labels[2] + 6};
    sample.add(others, {0, 0, 0});
  }
  sample.place_points();
  EXPECT_EQ(broken_rules(sample), Rules{"core.connected"});
}

TEST_F(Core, refuses_a_label_without_simplices) {
  CoreSample sample = cross_polytope(2);
  sample.coordinates.push_back(sample.coordinates[0]);
  sample.place_points();
  EXPECT_EQ(broken_rules(sample), (Rules{"core.connected", "core.stars"}));
}

// Margins.

TEST_F(Core, decides_ties_of_rational_data) {
  // Squared circumradius 2/25 · (1/2 · 4/3 · ...): of equilateral triangles with the squared side 2/25.
  const CoreSample sample = grid_torus(2, 5);
  // The circumradius is sqrt(2/75); the nearest other points are at twice that.
  EXPECT_EQ(broken_rules(sample, "1/6", "0"), Rules{});
  EXPECT_EQ(broken_rules(sample, "8/49", "0"), Rules{"4.ball"});  // 64/2401 < 2/75
  EXPECT_EQ(broken_rules(sample, "1/6", "8/49"), Rules{});
  EXPECT_EQ(broken_rules(sample, "1/6", "1/6"), Rules{"4.empty"});
  // A circle: points 1/4 apart, of radius 1/8, all other points as far again.
  const CoreSample circle = grid_torus(1, 4);
  EXPECT_EQ(broken_rules(circle, "1/8", "31/128"), Rules{});
  EXPECT_EQ(broken_rules(circle, "1/8", "1/4"), Rules{"4.empty"});
  EXPECT_EQ(broken_rules(circle, "127/1024", "0"), Rules{"4.ball"});
}

TEST_F(Core, knows_the_circumballs_of_polytopes) {
  // tan r: of the octahedron sqrt 2, of the 16-cell sqrt 3 (pi/3); opposite vertices are at pi - r.
  EXPECT_EQ(broken_rules(cross_polytope(2), "239/250", "3/20"), Rules{});  // r = 0.95531..., pi - 2r = 1.2309...
  EXPECT_EQ(broken_rules(cross_polytope(2), "191/200", "3/20"), Rules{"4.ball"});
  EXPECT_EQ(broken_rules(cross_polytope(3), "22/21", "1/2"), Rules{});  // r = 1.0471..., pi - 2r = pi/3
  EXPECT_EQ(broken_rules(cross_polytope(3), "104/100", "1/2"), Rules{"4.ball"});
  EXPECT_EQ(broken_rules(cross_polytope(3), "22/21", "11/20"), Rules{"4.ball"});  // beyond a quarter of a circle
  // Of the icosahedron: r = 0.65235..., the next vertices at 1.38208...
  EXPECT_EQ(broken_rules(icosahedron(false), "653/1000", "18/25"), Rules{});
  EXPECT_EQ(broken_rules(icosahedron(false), "653/1000", "74/100"), Rules{"4.empty"});
  EXPECT_EQ(broken_rules(icosahedron(false), "652/1000", "18/25"), Rules{"4.ball"});
}

/// That of all faces, from the lists of the core, with whatever is wrong with them.
TEST_F(Core, counts_faces_as_they_are_counted_without_it) {
  CoreSample pinched = grid_torus(2, 4), open = grid_torus(3, 3);
  pinched.add({0, 1, 2}, {0, 0});
  open.remove(5);
  open.remove(17);
  for (const CoreSample& sample : {grid_torus(2, 3), grid_torus(3, 3), icosahedron(false), cell_600(true),
                                   klein_bottle(), bolza_surface(), pinched, open}) {
    checker::Report report;
    checker::core::Complex complex(sample.data);
    checker::core::check_manifold(complex, report);
    for (const Label length : {1U, 5U, 1000U}) {
      for (Label begin = 0; begin < complex.size(); begin += length) {
        const Label end = std::min<Label>(begin + length, complex.size());
        const checker::FaceCount found = checker::core::count_faces(complex, begin, end),
                                 known = checker::count_faces(sample.m(), sample.data.labels, begin, end);
        EXPECT_EQ(found.simplices, known.simplices);
        EXPECT_EQ(found.euler_characteristic, known.euler_characteristic) << begin << " to " << end;
      }
    }
  }
}

/// What a check of margins says is broken.
template <class Check>
Rules broken_by(const CoreSample& sample, const Check& check) {
  checker::Report report;
  checker::core::Complex complex(sample.data);
  checker::core::check_manifold(complex, report);
  check(complex, report);
  Rules rules;
  for (const checker::Finding& finding : report.findings) rules.push_back(finding.rule);
  return rules;
}

Quantity fraction(int numerator, int denominator) { return Quantity(Rational(numerator) / Rational(denominator)); }

TEST_F(Core, knows_the_cotangents_of_regular_polytopes) {
  const auto cotangents = [](const CoreSample& sample, int thousandths) {
    return broken_by(sample, [&](auto& complex, auto& report) {
      checker::core::check_cotangents(complex, fraction(thousandths, 1000), report);
    });
  };
  // Twice cot 60 degrees, 1.1547...
  for (const CoreSample& sample : {icosahedron(false), icosahedron(true), cross_polytope(2), grid_torus(2, 4)}) {
    EXPECT_EQ(cotangents(sample, 1154), Rules{});
    EXPECT_EQ(cotangents(sample, 1155), Rules{"6.self-delaunay"});
  }
  EXPECT_EQ(cotangents(klein_bottle(), 0), Rules{});
  EXPECT_EQ(cotangents(bolza_surface(), 2000), Rules{"6.self-delaunay"});
}

TEST_F(Core, knows_how_much_polytopes_are_stretched) {
  const auto stretching = [](const CoreSample& sample, const Quantity& least, const Quantity& greatest) {
    return broken_by(sample, [&](auto& complex, auto& report) {
      checker::core::check_stretching(complex, least, greatest, report);
    });
  };
  // The octahedron: edges of pi/2 and chords of sqrt 2, a = b = 2 sqrt 2 / pi = 0.90031..., cos r = 1 / sqrt 3.
  const CoreSample octahedron = cross_polytope(2);
  EXPECT_EQ(stretching(octahedron, fraction(519, 1000), fraction(1560, 1000)), Rules{});  // 0.51979..., 1.55939...
  EXPECT_EQ(stretching(octahedron, fraction(520, 1000), fraction(1560, 1000)), Rules{"6.bilipschitz"});
  EXPECT_EQ(stretching(octahedron, fraction(519, 1000), fraction(1559, 1000)), Rules{"6.bilipschitz"});
  const CoreSample torus = grid_torus(2, 4);
  EXPECT_EQ(stretching(torus, fraction(1, 1), fraction(1, 1)), Rules{});
  EXPECT_EQ(stretching(torus, fraction(1001, 1000), fraction(2, 1)), Rules{"6.bilipschitz"});
  EXPECT_EQ(stretching(torus, fraction(1, 2), fraction(999, 1000)), Rules{"6.bilipschitz"});
  EXPECT_EQ(stretching(bolza_surface(), fraction(1, 2), fraction(2, 1)), Rules{});
  EXPECT_EQ(stretching(bolza_surface(), fraction(1, 2), fraction(1, 1)), Rules{"6.bilipschitz"});
}

TEST_F(Core, knows_the_thickness_of_polytopes_in_charts) {
  const auto riemannian = [](const CoreSample& sample, const Quantity& thickness, const Quantity& radius) {
    return broken_by(sample, [&](auto& complex, auto& report) {
      checker::core::check_riemannian_simplices(complex, thickness, radius, report);
    });
  };
  // The octahedron in the chart of a vertex: two legs of pi/2 at a right angle, the altitude pi/4 on a base of
  // pi sqrt 2 / 2: thickness 1/4.
  for (const CoreSample& sample : {cross_polytope(2)}) {
    EXPECT_EQ(riemannian(sample, fraction(249, 1000), fraction(1571, 1000)), Rules{});
    EXPECT_EQ(riemannian(sample, fraction(251, 1000), fraction(1571, 1000)), Rules{"5.thickness"});
    EXPECT_EQ(riemannian(sample, fraction(249, 1000), fraction(157, 100)), Rules{"5.radius"});
  }
  // Equilateral triangles: sqrt 3 / 4 = 0.43301...; the side is sqrt (2/16).
  EXPECT_EQ(riemannian(grid_torus(2, 4), fraction(433, 1000), fraction(354, 1000)), Rules{});
  EXPECT_EQ(riemannian(grid_torus(2, 4), fraction(4331, 10000), fraction(353, 1000)),
            (Rules{"5.thickness", "5.radius"}));
}

/// That neighbours suffice: the least distance of all lifts from a circumball, by brute force.
TEST_F(Core, finds_the_protection_among_neighbours) {
  const CoreSample sample = klein_bottle();
  const double protection = least_protection(sample);
  ASSERT_GT(protection, 0);
  const auto stated = [&](double factor) {
    return std::to_string(std::lround(factor * protection * 1e9)) + "/1000000000";
  };
  EXPECT_EQ(broken_rules(sample, "1", stated(0.9999)), Rules{});
  EXPECT_EQ(broken_rules(sample, "1", stated(1.0001)), Rules{"4.empty"});
}

}  // namespace
}  // namespace delcert::checker_tests::by_hand
