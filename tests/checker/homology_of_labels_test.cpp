// The homology of a certified complex from the labels of its simplices alone: the manifold, and with it the group, is
// taken out of the certificate before it is read.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "kernel/topology/homology.hpp"
#include "kernel/topology/pure_complex.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/proofs/certificate/space_form_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

using Groups = std::vector<std::string>;

/// H₀ … H_m of the simplices of a certificate without its manifold, its net and its points.
Groups homology_of_labels(const std::string& bytes) {
  Json document = Json::parse(bytes);
  const std::size_t width = document["points"].at(0).size();
  for (const char* key : {"manifold", "levels", "net", "points", "elements", "loops"}) document.erase(key);
  std::vector<std::uint32_t> labels;
  for (const Json& simplex : document["simplices"]) {
    for (std::size_t k = 0; k <= width; ++k) labels.push_back(simplex[k].get<std::uint32_t>());
  }
  Groups result;
  for (const AbelianGroup& group : homology(PureComplex(Dimension(static_cast<int>(width)), labels)))
    result.push_back(group_text(group));
  return result;
}

template <int m>
std::string certificate_of(const std::string& name, const Rational& radius, int patch_factor) {
  const auto sample = test::space_form_run<m>(name, radius, patch_factor, 5);
  EXPECT_TRUE(sample.run.is_certified()) << name;
  delcert::Claims claims;
  claims.stars = StarMargins{Rational(1), Rational(1), Rational(1)};
  claims.manifold = ManifoldClaim{};
  const test::TemporaryFolder folder;
  sample.write(folder / "run.json", claims);
  std::ifstream file(folder / "run.json", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(HomologyOfLabels, of_runs_is_that_of_the_group_that_they_do_not_see) {
  const Rational one(1);
  EXPECT_EQ(homology_of_labels(certificate_of<2>("klein-bottle", one / Rational(24), 9)),
            (Groups{"Z", "Z + Z/2", "0"}));
  EXPECT_EQ(homology_of_labels(certificate_of<2>("bolza-surface", one / Rational(8), 9)), (Groups{"Z", "Z^4", "Z"}));
  EXPECT_EQ(homology_of_labels(certificate_of<3>("projective-space-3", one / Rational(7), 7)),
            (Groups{"Z", "Z/2", "0", "Z"}));
}

TEST(HomologyOfLabels, of_nets_made_by_other_means_is_that_of_their_groups) {
  EXPECT_EQ(homology_of_labels(sealed(icosphere().document())), (Groups{"Z", "0", "Z"}));
  EXPECT_EQ(homology_of_labels(sealed(projective_plane().document())), (Groups{"Z", "Z/2", "0"}));
  EXPECT_EQ(homology_of_labels(sealed(cell_600().document())), (Groups{"Z", "0", "0", "Z"}));
  EXPECT_EQ(homology_of_labels(sealed(projective_space().document())), (Groups{"Z", "Z/2", "0", "Z"}));
}

/// Two labels without common neighbours made one: a handle more.
TEST(HomologyOfLabels, of_other_labels_is_another) {
  const std::vector<std::vector<Labels>>& stars = klein_bottle().model.stars;
  std::set<int> near{0};
  for (int ring = 0; ring < 2; ++ring) {
    std::set<int> more;
    for (const int i : near) {
      for (const Labels& others : stars[static_cast<std::size_t>(i)]) more.insert(others.begin(), others.end());
    }
    near.merge(more);
  }
  int far = 0;
  while (near.contains(far)) ++far;
  Json document = klein_bottle().document();
  for (Json& simplex : document["simplices"]) {
    for (std::size_t k = 0; k <= 2; ++k) {
      if (simplex[k] == far) simplex[k] = 0;
    }
  }
  EXPECT_EQ(homology_of_labels(sealed(document)), (Groups{"Z", "Z^2 + Z/2", "0"}));
}

}  // namespace
}  // namespace delcert::checker_tests
