// The homology of a certified complex from the labels of its simplices alone: the manifold, and with it the group, is
// taken out of the certificate before it is read.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/topology/homology.hpp"
#include "kernel/topology/pure_complex.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "tests/checker/support/space_form_samples.hpp"
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
  const SpaceForm form = verify_space_form(find_space_form(name));
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, patch_factor);
  PerturbationParameters parameters = measured_parameters(Dimension(m), 1);
  parameters.choices = 5;
  const auto run = run_in_charts<m>(atlas, parameters, {}, no_progress());
  EXPECT_TRUE(run.is_certified()) << name;
  SpaceFormClaims claims;
  claims.stars = StarMargins{Rational(1), Rational(1), Rational(1)};
  claims.manifold = ManifoldClaim{};
  std::vector<Vector<Rational, m>> centres, vectors;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    centres.push_back(atlas.centre(Label(index)));
    vectors.push_back(run.points.exact(Label(index)));
  }
  const test::TemporaryFolder folder;
  write_space_form_certificate<m>(
      folder / "run.json", {form, space_form_parameters(parameters, Dimension(m), true), radius, centres, vectors,
                            placed_complex<m>(atlas, run.complex), claims});
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
