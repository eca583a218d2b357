#include "proofs/checker/geometry/homology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "proofs/checker/report/report.hpp"
#include "tests/kernel/topology/known_complexes.hpp"

namespace delcert::checker_tests {
namespace {

using checker::FaceComplex;
using checker::LabelSet;
using test::known_complexes;
using test::KnownComplex;
using test::LabelComplex;

/// With the labels changed by a permutation.
FaceComplex faces_of(const LabelComplex& complex, unsigned seed) {
  std::vector<std::uint32_t> names(*std::max_element(complex.labels.begin(), complex.labels.end()) + 1);
  std::iota(names.begin(), names.end(), 0U);
  std::mt19937_64 random(seed);
  for (std::size_t at = names.size(); seed != 0 && at > 1; --at) std::swap(names[at - 1], names[random() % at]);
  std::vector<LabelSet> simplices;
  for (std::size_t at = 0; at < complex.labels.size(); at += complex.corners()) {
    LabelSet& simplex = simplices.emplace_back();
    for (std::size_t corner = 0; corner < complex.corners(); ++corner) {
      simplex[corner] = names[complex.labels[at + corner]];
    }
    std::sort(simplex.begin(), simplex.begin() + complex.dimension + 1);
  }
  return {complex.dimension, simplices};
}

TEST(HomologyOfTheChecker, of_known_complexes) {
  for (const KnownComplex& known : known_complexes()) {
    EXPECT_EQ(faces_of(known.complex, 0).homology(), known.homology) << known.name;
  }
}

TEST(HomologyOfTheChecker, does_not_depend_on_the_labels) {
  for (const KnownComplex& known : known_complexes()) {
    EXPECT_EQ(faces_of(known.complex, 1).homology(), known.homology) << known.name;
  }
}

TEST(HomologyOfTheChecker, notices_a_missing_simplex) {
  using Groups = std::vector<std::string>;
  const auto punctured = [](const LabelComplex& complex) {
    return faces_of(without_simplex(complex, complex.size() / 3), 0).homology();
  };
  EXPECT_EQ(punctured(test::seven_vertex_torus()), (Groups{"Z", "Z^2", "0"}));
  EXPECT_EQ(punctured(test::six_vertex_projective_plane()), (Groups{"Z", "Z", "0"}));
  EXPECT_EQ(punctured(test::lens_space(5, 2)), (Groups{"Z", "Z/5", "0", "0"}));
}

TEST(HomologyOfTheChecker, of_groups_of_several_summands) {
  LabelComplex wound = test::glued_polygon("aaaa");
  for (const char* word : {"aaaaaa", "aaaa", "aaaaaaaaa"})
    wound = test::disjoint_union(wound, test::glued_polygon(word));
  // Z/4 + Z/6 + Z/4 + Z/9
  EXPECT_EQ(faces_of(wound, 0).homology(), (std::vector<std::string>{"Z^4", "Z/2 + Z/12 + Z/36", "0"}));
}

TEST(HomologyOfTheChecker, of_very_much_torsion_is_left_undecided) {
  LabelComplex many{2, {}};
  const LabelComplex one = test::six_vertex_projective_plane();
  for (std::uint32_t copy = 0; copy < 8200; ++copy) {
    for (const std::uint32_t label : one.labels) many.labels.push_back(6 * copy + label);
  }
  EXPECT_THROW((void)faces_of(many, 0).homology(), checker::Undecided);
}

TEST(HomologyOfTheChecker, of_points_and_of_nothing) {
  EXPECT_EQ(FaceComplex(2, {}).homology(), (std::vector<std::string>{"0", "0", "0"}));
  EXPECT_EQ(FaceComplex(1, {LabelSet{3, 9}}).homology(), (std::vector<std::string>{"Z", "0"}));
}

/// In ranges of labels, whose counts add up.
std::pair<std::int64_t, std::int64_t> counted(LabelComplex complex, checker::Label length) {
  const auto corners = static_cast<std::ptrdiff_t>(complex.corners());
  for (auto begin = complex.labels.begin(); begin != complex.labels.end(); begin += corners)
    std::sort(begin, begin + corners);
  std::pair<std::int64_t, std::int64_t> sum;
  checker::Label labels = 0;
  for (const checker::Label label : complex.labels) labels = std::max(labels, label + 1);
  for (checker::Label begin = 0; begin < labels; begin += length) {
    const checker::FaceCount count =
        checker::count_faces(static_cast<std::size_t>(complex.dimension), complex.labels, begin, begin + length);
    sum.first += count.simplices;
    sum.second += count.euler_characteristic;
  }
  return sum;
}

/// By the ranks of its homology.
TEST(HomologyOfTheChecker, has_the_euler_characteristic_of_the_count_of_faces) {
  for (const KnownComplex& known : known_complexes()) {
    std::int64_t euler = 0, sign = 1;
    for (const std::string& group : known.homology) {
      const std::int64_t rank = group.starts_with("Z^") ? std::stol(group.substr(2))
                                                        : (group.starts_with("Z") && !group.starts_with("Z/") ? 1 : 0);
      euler += sign * rank;
      sign = -sign;
    }
    const auto simplices = static_cast<std::int64_t>(known.complex.labels.size() / known.complex.corners());
    for (const checker::Label length : {1U, 3U, 100000U})
      EXPECT_EQ(counted(known.complex, length), std::pair(simplices, euler)) << known.name << " " << length;
  }
  EXPECT_EQ(counted(test::smallest_sphere(4), 2).second, 2);
  EXPECT_EQ(counted(test::glued_polygon("abABcdCD"), 7).second, -2);
  EXPECT_EQ(counted({2, {}}, 5), std::pair(std::int64_t{0}, std::int64_t{0}));
}

}  // namespace
}  // namespace delcert::checker_tests
