#include "proofs/certificate/stated_levels.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

void expect_same(const std::vector<ClaimedLevel>& stated, const std::vector<ClaimedLevel>& claimed) {
  ASSERT_EQ(stated.size(), claimed.size());
  for (std::size_t at = 0; at < claimed.size(); ++at) {
    EXPECT_EQ(stated[at].name, claimed[at].name);
    ASSERT_EQ(stated[at].entries.size(), claimed[at].entries.size()) << claimed[at].name;
    for (std::size_t k = 0; k < claimed[at].entries.size(); ++k) {
      const LevelEntry& read = stated[at].entries[k];
      const LevelEntry& written = claimed[at].entries[k];
      EXPECT_EQ(read.key, written.key);
      ASSERT_EQ(read.margins.size(), written.margins.size()) << claimed[at].name << " " << written.key;
      if (written.margins.empty()) {
        EXPECT_EQ(read.json, written.json);
      }
      for (std::size_t m = 0; m < written.margins.size(); ++m) {
        EXPECT_EQ(read.margins[m].value, written.margins[m].value);
        EXPECT_EQ(read.margins[m].side, written.margins[m].side) << claimed[at].name << " " << written.key;
        EXPECT_EQ(read.margins[m].unit, written.margins[m].unit) << claimed[at].name << " " << written.key;
      }
    }
  }
}

/// All that any family states; each bound is another number.
Claims all_claims() {
  long next = 2;
  const auto bound = [&next] { return Rational(1) / Rational(next++); };
  Claims claims;
  claims.input = InputClaim{{}, InputClaim::Density{bound(), bound(), bound()}};
  claims.stars = StarMargins{bound(), bound(), bound()};
  claims.full_stars.emplace();
  claims.manifold = ManifoldClaim{8, -2, true, {{1, {}}, {4, {}}, {1, {}}}};
  claims.stable_stars.emplace();
  claims.stable_stars->reach = bound();
  claims.triangulation = TriangulationClaim{"graph", TriangulationClaim::RiemannianSimplices{bound(), bound()},
                                            TriangulationClaim::Graph{bound(), bound()}};
  claims.isotopy = IsotopyClaim{bound()};
  claims.metric = MetricClaim{true, bound(), bound(), Rational(2), bound()};
  return claims;
}

TEST(StatedLevels, are_read_as_they_were_claimed) {
  const test::TemporaryFolder folder;
  std::vector<Claims> all(5, all_claims());
  all[0].delaunay = DelaunayClaim{DelaunayClaim::Balls{Rational(1) / Rational(7), Rational(3)}, {}};
  all[1].delaunay = DelaunayClaim{{}, DelaunayClaim::Stability{Rational(1) / Rational(7), Rational(3)}};
  all[2].delaunay = DelaunayClaim{{}, {}, DelaunayClaim::Restricted{true, true, Rational(1) / Rational(7)}};
  all[3] = small_run().claims();
  all[4].isotopy = IsotopyClaim{{}, Rational(1) / Rational(7)};
  for (const Claims& claims : all) {
    small_run().write(folder / "c.json", claims, small_run().manifold);
    expect_same(stated_levels(read_certificate(folder / "c.json")), claimed_levels(claims));
  }
}

TEST(StatedLevels, keep_what_they_do_not_know_as_text) {
  CertificateSummary certificate;
  certificate.levels = {{"9", {{"margin", "1/3"}, {"simplices", "many"}, {"closed", "perhaps"}}}};
  const auto levels = stated_levels(certificate);
  ASSERT_EQ(levels.size(), 1U);
  ASSERT_EQ(levels[0].entries.size(), 3U);
  EXPECT_TRUE(levels[0].entries[0].margins.empty());
  EXPECT_EQ(levels[0].entries[0].json, "\"1/3\"");
  EXPECT_EQ(levels[0].entries[1].json, "\"many\"");
  EXPECT_EQ(levels[0].entries[2].json, "\"perhaps\"");
}

TEST(StatedLevels, refuse_bounds_that_are_no_numbers) {
  CertificateSummary certificate;
  certificate.levels = {{"1", {{"protection", "0.5"}}}};
  try {
    (void)stated_levels(certificate);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("levels: \"1\": \"protection\": "), std::string::npos) << error.what();
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
