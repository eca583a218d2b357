#include "kernel/stars/star_complex.hpp"

#include "kernel/simplex/faces.hpp"
#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
LiftedSimplex<m> simplex_of_labels(const std::array<std::uint32_t, static_cast<std::size_t>(m) + 1>& labels) {
  LiftedSimplex<m> result;
  for (std::size_t corner = 0; corner <= m; ++corner) result[corner] = {labels[corner], {}};
  return result;
}

/// The boundary of a simplex with m + 2 vertices: the smallest m-sphere.
template <int m>
std::vector<LiftedSimplex<m>> smallest_sphere() {
  std::vector<LiftedSimplex<m>> result;
  for (Faces faces(m + 2, m + 1); faces.has_face(); faces.advance()) {
    std::array<std::uint32_t, static_cast<std::size_t>(m) + 1> labels;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      labels[corner] = static_cast<std::uint32_t>(faces.vertices()[corner]);
    }
    result.push_back(simplex_of_labels<m>(labels));
  }
  return result;
}

template <int m>
std::vector<LiftedSimplex<m>> torus_simplices(const FlatSpace<m>& space, std::size_t count) {
  return propose_delaunay<m>(space, approximate_all<m>(random_points<m>(count, 1, 20)), 0.2);
}

TEST(StarFailures, concern_each_label_once) {
  const std::vector<StarFailure> failures{{Label(3), "", {Label(5), Label(3)}}, {Label(1), "", {Label(3), Label(2)}}};
  EXPECT_EQ(labels_concerned_by(failures), (std::vector<Label>{Label(2), Label(3), Label(5)}));
  EXPECT_TRUE(labels_concerned_by({}).empty());
}

TEST(StarComplex, has_the_stars_of_its_labels) {
  const auto simplices = torus_simplices<2>(hexagonal_torus(), 40);
  const StarComplex<2> complex(simplices, std::vector<bool>(40, true));
  EXPECT_EQ(complex.simplices(), simplices);
  for (std::uint32_t i = 0; i < 40; ++i) {
    std::vector<std::array<std::uint32_t, 2>> expected;
    for (const auto& simplex : simplices) {
      std::vector<std::uint32_t> others;
      for (const auto& vertex : simplex) {
        if (vertex.index != i) others.push_back(vertex.index);
      }
      if (others.size() == 2) expected.push_back({others[0], others[1]});
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(complex.star(Label(i)), expected);
    EXPECT_GE(expected.size(), 3U);
    for (const auto& others : expected) EXPECT_LT(others[0], others[1]);
  }
}

TEST(StarComplex, has_the_euler_characteristic_of_its_manifold) {
  const auto characteristic = []<int m>(const std::vector<LiftedSimplex<m>>& simplices, std::size_t labels) {
    return StarComplex<m>(simplices, std::vector<bool>(labels, true)).euler_characteristic();
  };
  EXPECT_EQ((characteristic.operator()<1>(smallest_sphere<1>(), 3)), 0);
  EXPECT_EQ((characteristic.operator()<2>(smallest_sphere<2>(), 4)), 2);
  EXPECT_EQ((characteristic.operator()<3>(smallest_sphere<3>(), 5)), 0);
  EXPECT_EQ((characteristic.operator()<4>(smallest_sphere<4>(), 6)), 2);
  EXPECT_EQ((characteristic.operator()<2>({simplex_of_labels<2>({0, 1, 2})}, 3)), 1);
  EXPECT_EQ((characteristic.operator()<2>({simplex_of_labels<2>({0, 1, 2}), simplex_of_labels<2>({3, 4, 5})}, 6)), 2);
  EXPECT_EQ((characteristic.operator()<1>(torus_simplices<1>(cubic_torus<1>(), 9), 9)), 0);
  EXPECT_EQ((characteristic.operator()<2>(torus_simplices<2>(hexagonal_torus(), 60), 60)), 0);
  // 60 points are enough for a cube to be triangulated without meeting itself.
  EXPECT_EQ((characteristic.operator()<3>(torus_simplices<3>(cubic_torus<3>(), 120), 120)), 0);
  EXPECT_EQ((characteristic.operator()<2>({}, 3)), 0);
}

TEST(StarComplex, is_a_complex_of_labels) {
  const StarComplex<3> torus(torus_simplices<3>(cubic_torus<3>(), 120), std::vector<bool>(120, true));
  const PureComplex complex = torus.label_complex();
  EXPECT_EQ(complex.dimension(), 3);
  EXPECT_EQ(complex.count(3), torus.simplices().size());
  EXPECT_EQ(complex.count(0), 120U);
  EXPECT_EQ(complex.euler_characteristic(), torus.euler_characteristic());
  std::vector<std::vector<std::uint32_t>> expected, found;
  for (const auto& simplex : torus.simplices()) {
    expected.emplace_back();
    for (const auto& vertex : simplex) expected.back().push_back(vertex.index);
  }
  std::sort(expected.begin(), expected.end());
  for (std::size_t at = 0; at < complex.count(3); ++at) {
    const auto vertices = complex.vertices(3, at);
    found.emplace_back(vertices.begin(), vertices.end());
  }
  EXPECT_EQ(found, expected);
  const StarComplex<2> meets_itself({simplex_of_labels<2>({0, 1, 1})}, std::vector<bool>(2, true));
  EXPECT_THROW((void)meets_itself.label_complex(), InputError);
}

TEST(StarComplex, of_a_closed_manifold_has_no_failures) {
  EXPECT_TRUE(StarComplex<2>(smallest_sphere<2>(), std::vector<bool>(4, true)).combinatorial_failures().empty());
  EXPECT_TRUE(StarComplex<4>(smallest_sphere<4>(), std::vector<bool>(6, true)).combinatorial_failures().empty());
  EXPECT_TRUE(StarComplex<3>(torus_simplices<3>(cubic_torus<3>(), 120), std::vector<bool>(120, true))
                  .combinatorial_failures()
                  .empty());
}

bool concerns(const StarFailure& failure, std::uint32_t label) {
  return std::count(failure.concerned.begin(), failure.concerned.end(), Label(label)) > 0;
}

TEST(StarComplex, names_the_stars_that_miss_a_simplex) {
  auto simplices = torus_simplices<2>(hexagonal_torus(), 40);
  const auto removed = simplices[5];
  simplices.erase(simplices.begin() + 5);
  const auto failures = StarComplex<2>(simplices, std::vector<bool>(40, true)).combinatorial_failures();
  ASSERT_EQ(failures.size(), 3U);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto label = removed[corner].index;
    EXPECT_EQ(failures[corner].label, Label(label));
    EXPECT_TRUE(mentions(failures[corner].reason, "in 1 simplices instead of 2")) << failures[corner].reason;
    EXPECT_TRUE(concerns(failures[corner], label));
    EXPECT_EQ(failures[corner].concerned.size(), 2U);
  }
}

TEST(StarComplex, names_the_stars_that_have_a_simplex_twice) {
  auto simplices = torus_simplices<3>(cubic_torus<3>(), 120);
  const auto doubled = simplices[7];
  simplices.push_back(doubled);
  const auto failures = StarComplex<3>(simplices, std::vector<bool>(120, true)).combinatorial_failures();
  ASSERT_EQ(failures.size(), 4U);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    EXPECT_EQ(failures[corner].label, Label(doubled[corner].index));
    EXPECT_TRUE(mentions(failures[corner].reason, "in 3 simplices instead of 2")) << failures[corner].reason;
    for (const Label label : failures[corner].concerned) {
      EXPECT_TRUE(std::any_of(doubled.begin(), doubled.end(), [&](const auto& v) { return v.index == label.value; }));
    }
  }
}

TEST(StarComplex, names_empty_stars) {
  const auto failures = StarComplex<2>(smallest_sphere<2>(), std::vector<bool>(5, true)).combinatorial_failures();
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].label, Label(4));
  EXPECT_TRUE(mentions(failures[0].reason, "empty"));
  EXPECT_EQ(failures[0].cause, FailureCause::combinatorial);
  EXPECT_TRUE(concerns(failures[0], 4));
}

TEST(StarComplex, names_simplices_that_meet_themselves) {
  auto simplices = smallest_sphere<2>();
  simplices.push_back({{{1, {0, 0}}, {1, {0, 1}}, {3, {0, 0}}}});
  const auto failures = StarComplex<2>(simplices, std::vector<bool>(4, true)).combinatorial_failures();
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].label, Label(1));
  EXPECT_TRUE(mentions(failures[0].reason, "twice"));
  EXPECT_EQ(failures[0].cause, FailureCause::combinatorial);
}

TEST(StarComplex, keeps_what_interior_labels_need) {
  // A hexagon about 0, and a triangle that has no interior label.
  std::vector<LiftedSimplex<2>> simplices;
  for (std::uint32_t k = 1; k < 6; ++k) simplices.push_back(simplex_of_labels<2>({0, k, k + 1}));
  simplices.push_back(simplex_of_labels<2>({0, 1, 6}));
  simplices.push_back(simplex_of_labels<2>({1, 2, 7}));
  std::vector<bool> interior(8, false);
  interior[0] = true;
  const StarComplex<2> complex(simplices, interior);
  EXPECT_EQ(complex.simplices().size(), 6U);
  EXPECT_EQ(complex.star(Label(0)).size(), 6U);
  EXPECT_TRUE(complex.star(Label(1)).empty());
  EXPECT_TRUE(complex.combinatorial_failures().empty());
  EXPECT_EQ(complex.euler_characteristic(), 1);
  // With 1 interior as well, its star is not closed.
  interior[1] = true;
  const auto failures = StarComplex<2>(simplices, interior).combinatorial_failures();
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].label, Label(1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
