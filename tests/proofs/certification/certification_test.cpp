#include "proofs/certification/certification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "proofs/certificate/reader.hpp"
#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// A small member of a family, and what makes it.
struct Member {
  std::string manifold;
  CertifyOptions options;
};

CertifyOptions with_radius(const Rational& radius) {
  CertifyOptions result;
  result.source.radius = radius;
  result.source.seed = 1;
  return result;
}

CertifyOptions with_lattice(std::uint32_t number) {
  CertifyOptions result;
  result.source.lattice = number;
  result.choice.mode = RunMode::measured;
  return result;
}

class Certification : public testing::Test {
 protected:
  RunReport run(const std::string& manifold, CertifyOptions options) const {
    options.source.manifold = manifold;
    options.output = (folder_ / "certificate.json").string();
    return certified_run(options, no_progress());
  }

  test::TemporaryFolder folder_;
};

TEST_F(Certification, of_every_family_writes_what_it_reports) {
  const std::vector<Member> members{{"torus-2", with_lattice(20)},
                                    {"klein-bottle", with_radius(Rational(1, 20))},
                                    {"torus-2-hills", with_radius(Rational(1, 40))},
                                    {"sphere-2-stereographic", with_radius(Rational(1, 8))},
                                    {"trefoil", with_radius(Rational(1, 40))}};
  for (const Member& member : members) {
    const RunReport report = run(member.manifold, member.options);
    const CertificateSummary certificate = read_certificate(folder_ / "certificate.json");
    EXPECT_EQ(certificate.manifold.name, member.manifold);
    EXPECT_EQ(report.manifold, member.manifold);
    EXPECT_EQ(certificate.points.size(), report.points) << member.manifold;
    EXPECT_EQ(certificate.simplices.size(), report.simplices) << member.manifold;
    std::vector<std::string> levels;
    for (const auto& [name, entries] : certificate.levels) levels.push_back(name);
    EXPECT_EQ(levels, report.claims.names()) << member.manifold;
    EXPECT_GE(levels.size(), 2U) << member.manifold;
    EXPECT_FALSE(report.stages.empty());
  }
}

TEST_F(Certification, claims_no_more_than_is_asked_for) {
  CertifyOptions options = with_lattice(20);
  EXPECT_GT(run("torus-2", options).claims.names().size(), 3U);
  options.levels = {"0", "1", "2"};
  EXPECT_EQ(run("torus-2", options).claims.names(), (std::vector<std::string>{"0", "1", "2"}));
}

TEST_F(Certification, that_is_not_reached_is_refused_and_writes_nothing) {
  CertifyOptions options;
  options.source.lattice = 20;
  options.no_perturbation = true;
  EXPECT_THROW((void)run("torus-2", options), Rejection);
  EXPECT_THROW((void)run("tours-2", options), InputError);
  EXPECT_TRUE(folder_.is_empty());
}

TEST_F(Certification, that_is_ended_by_its_caller_at_any_stage_writes_nothing) {
  CertifyOptions options = with_lattice(20);
  options.source.manifold = "torus-2";
  options.output = (folder_ / "certificate.json").string();
  std::size_t calls = 0;
  (void)certified_run(options, [&calls](std::string_view, std::size_t, std::size_t) { ++calls; });
  std::filesystem::remove(options.output);
  ASSERT_GT(calls, 3U);
  for (std::size_t last : {std::size_t{1}, calls / 2, calls}) {
    const auto progress = [&last](std::string_view, std::size_t, std::size_t) {
      if (--last == 0) throw std::logic_error("enough");
    };
    EXPECT_THROW((void)certified_run(options, progress), std::logic_error);
    EXPECT_TRUE(folder_.is_empty());
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
