#include "kernel/topology/homology.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <set>

#include "support/error.hpp"
#include "tests/kernel/topology/naive_homology.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::vector<AbelianGroup> homology_of(const LabelComplex& complex) {
  return homology(PureComplex(Dimension(complex.dimension), complex.labels));
}

std::vector<std::string> texts(const LabelComplex& complex) {
  std::vector<std::string> result;
  for (const AbelianGroup& group : homology_of(complex)) result.push_back(group_text(group));
  return result;
}

TEST(Homology, of_known_complexes) {
  for (const KnownComplex& known : known_complexes()) EXPECT_EQ(texts(known.complex), known.homology) << known.name;
}

TEST(Homology, of_a_closed_manifold_without_a_simplex) {
  for (const KnownComplex& known : known_complexes()) {
    if (!known.closed_manifold || !known.orientable || known.homology[0] != "Z") continue;
    std::vector<std::string> expected = known.homology;
    expected.back() = "0";
    EXPECT_EQ(texts(without_simplex(known.complex, known.complex.size() / 2)), expected) << known.name;
  }
  // A class of order 2 becomes free.
  const LabelComplex projective_plane = six_vertex_projective_plane(), klein_bottle = glued_polygon("abAb");
  EXPECT_EQ(texts(without_simplex(projective_plane, 4)), (std::vector<std::string>{"Z", "Z", "0"}));
  EXPECT_EQ(texts(without_simplex(klein_bottle, 4)), (std::vector<std::string>{"Z", "Z^2", "0"}));
}

TEST(Homology, notices_a_side_that_is_glued_the_other_way) {
  EXPECT_EQ(texts(glued_polygon("abAB"))[1], "Z^2");
  EXPECT_EQ(texts(glued_polygon("abAb"))[1], "Z + Z/2");
  EXPECT_EQ(texts(glued_polygon("abab"))[1], "Z/2");
  EXPECT_NE(texts(glued_dodecahedron(1)), texts(glued_dodecahedron(2)));
  EXPECT_NE(texts(lens_space(5, 1)), texts(lens_space(7, 1)));
}

TEST(Homology, of_the_empty_complex_and_of_points) {
  EXPECT_EQ(texts({2, {}}), (std::vector<std::string>{"0", "0", "0"}));
  EXPECT_EQ(texts({0, {7, 3, 7}}), (std::vector<std::string>{"Z^2"}));
  EXPECT_EQ(texts({1, {3, 9}}), (std::vector<std::string>{"Z", "0"}));
}

/// The same complex with its labels, and the order of its simplices and of their vertices, changed at random.
LabelComplex shuffled(const LabelComplex& complex, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto below = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  std::vector<std::uint32_t> names(*std::max_element(complex.labels.begin(), complex.labels.end()) + 1);
  for (std::size_t at = 0; at < names.size(); ++at) names[at] = static_cast<std::uint32_t>(3 * at + 5);
  for (std::size_t at = names.size(); at > 1; --at) std::swap(names[at - 1], names[below(at)]);
  std::vector<std::vector<std::uint32_t>> simplices(complex.size());
  for (std::size_t at = 0; at < complex.labels.size(); ++at) {
    simplices[at / complex.corners()].push_back(names[complex.labels[at]]);
  }
  for (std::size_t at = simplices.size(); at > 1; --at) std::swap(simplices[at - 1], simplices[below(at)]);
  LabelComplex result{complex.dimension, {}};
  for (auto& simplex : simplices) {
    std::rotate(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(below(simplex.size())), simplex.end());
    result.labels.insert(result.labels.end(), simplex.begin(), simplex.end());
  }
  return result;
}

TEST(Homology, does_not_depend_on_the_labels) {
  for (const KnownComplex& known : known_complexes()) {
    EXPECT_EQ(texts(shuffled(known.complex, 1)), known.homology) << known.name;
  }
}

RC_GTEST_PROP(Homology, is_that_of_whole_boundary_matrices, ()) {
  // By a generator of our own: those of RapidCheck stay near 0 at first, where sets of labels would not fill.
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto below = [&random](std::uint64_t count) { return static_cast<std::uint32_t>(random() % count); };
  LabelComplex complex{1 + static_cast<int>(below(3)), {}};
  const std::uint32_t vertices = static_cast<std::uint32_t>(complex.corners()) + below(4), count = 1 + below(20);
  for (std::uint32_t simplex = 0; simplex < count; ++simplex) {
    std::set<std::uint32_t> labels;
    while (labels.size() < complex.corners()) labels.insert(below(vertices));
    complex.labels.insert(complex.labels.end(), labels.begin(), labels.end());
  }
  const auto ours = homology_of(complex);
  const auto naive = naive_homology(complex);
  RC_ASSERT(ours.size() == naive.size());
  for (std::size_t k = 0; k < ours.size(); ++k) {
    RC_ASSERT(ours[k].free_rank == naive[k].free_rank);
    RC_ASSERT(ours[k].torsion == std::vector<Integer>(naive[k].torsion.begin(), naive[k].torsion.end()));
  }
}

TEST(Homology, is_that_of_whole_boundary_matrices_where_there_is_torsion) {
  for (const LabelComplex& complex : {six_vertex_projective_plane(), glued_polygon("aaaa"), glued_polygon("aabbaabb"),
                                      suspension(six_vertex_projective_plane())}) {
    const auto ours = homology_of(complex);
    const auto naive = naive_homology(complex);
    for (std::size_t k = 0; k < ours.size(); ++k) {
      EXPECT_EQ(ours[k].free_rank, naive[k].free_rank);
      EXPECT_EQ(ours[k].torsion, std::vector<Integer>(naive[k].torsion.begin(), naive[k].torsion.end()));
    }
  }
}

TEST(Homology, of_very_many_components_is_left_undecided) {
  // Each projective plane leaves one critical edge and one critical triangle.
  LabelComplex many{2, {}};
  const LabelComplex one = six_vertex_projective_plane();
  for (std::uint32_t copy = 0; copy < 8200; ++copy) {
    for (const std::uint32_t label : one.labels) many.labels.push_back(6 * copy + label);
  }
  EXPECT_THROW((void)homology_of(many), Undecided);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
