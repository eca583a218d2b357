#include "proofs/certification/shared_certification.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "kernel/parallel/threads.hpp"
#include "kernel/ranks/thread_ranks.hpp"
#include "proofs/certificate/chunks.hpp"
#include "proofs/certificate/file_text.hpp"
#include "proofs/certification/certification.hpp"
#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class SharedCertification : public testing::Test {
 protected:
  static SharedOptions options_for(const std::string& manifold, const Rational& radius, std::size_t chunks) {
    SharedOptions result;
    result.certify.source.manifold = manifold;
    result.certify.source.radius = radius;
    result.certify.source.seed = 1;
    result.certify.threads = 1;
    result.certify.origin = {{"command", "the same"}};
    result.chunks = chunks;
    return result;
  }

  /// The bytes of the files of a folder.
  static std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::ifstream in(entry.path(), std::ios::binary);
      result[entry.path().filename()].assign(std::istreambuf_iterator<char>(in), {});
    }
    return result;
  }

  SharedReport run(std::size_t ranks, SharedOptions options, const std::string& name) const {
    options.certify.output = (folder_ / name).string();
    SharedReport report;
    run_ranks_in_threads(ranks, [&](Communicator& communicator) {
      SharedReport mine = certify_shared(communicator, options, no_progress());
      if (communicator.rank() == 0) report = std::move(mine);
    });
    return report;
  }

  void expect_the_same_for_all_ranks(SharedOptions options, const std::vector<std::size_t>& counts) const {
    CertifyOptions alone = options.certify;
    alone.output = (folder_ / "alone.json").string();
    const RunReport expected = certified_run(alone, no_progress());
    const std::string root = write_chunks(read_text(alone.output), options.chunks, folder_ / "split");
    const auto files = files_in(folder_ / "split");
    EXPECT_EQ(files.size(), options.chunks + 1);
    for (const std::size_t count : counts) {
      const std::string name = "ranks-" + std::to_string(count);
      const SharedReport report = run(count, options, name);
      EXPECT_TRUE(files_in(folder_ / name) == files) << count;
      EXPECT_EQ(report.root, root);
      EXPECT_EQ(report.levels, expected.claims.names());
      EXPECT_EQ(report.points, expected.points);
      EXPECT_EQ(report.simplices, expected.simplices);
      EXPECT_EQ(report.reasons, expected.reasons);
      EXPECT_EQ(report.bytes_of_perturbation > 0, count > 1);
      EXPECT_FALSE(std::filesystem::exists(folder_ / (name + ".progress")));
    }
  }

  test::TemporaryFolder folder_;
  ThreadLimit one_for_each_rank_{1};
};

TEST_F(SharedCertification, of_a_sphere_is_the_same_for_any_number_of_ranks) {
  expect_the_same_for_all_ranks(options_for("sphere-2", Rational(1, 16), 5), {1, 2, 3, 4});
}

TEST_F(SharedCertification, of_a_3_sphere_is_the_same_for_any_number_of_ranks) {
  expect_the_same_for_all_ranks(options_for("sphere-3", Rational(1, 5), 3), {1, 4});
}

TEST_F(SharedCertification, with_fewer_chunks_than_ranks_is_the_same) {
  expect_the_same_for_all_ranks(options_for("sphere-2", Rational(1, 10), 2), {3});
}

TEST_F(SharedCertification, of_another_seed_is_another_one) {
  SharedOptions options = options_for("sphere-2", Rational(1, 10), 2);
  const std::string first = run(2, options, "first").root;
  options.certify.source.seed = 2;
  EXPECT_NE(run(2, options, "second").root, first);
}

TEST_F(SharedCertification, refuses_what_it_cannot_divide) {
  EXPECT_THROW(run(2, options_for("torus-2", Rational(1, 10), 2), "torus"), InputError);
  EXPECT_THROW(run(2, options_for("projective-plane", Rational(1, 10), 2), "plane"), InputError);
  EXPECT_THROW(run(2, options_for("sphere-2", Rational(1, 10), 100000), "chunks"), InputError);
  EXPECT_THROW(run(100, options_for("sphere-2", Rational(1, 10), 2), "ranks"), Rejection);
  (void)run(2, options_for("sphere-2", Rational(1, 10), 2), "twice");
  EXPECT_THROW(run(2, options_for("sphere-2", Rational(1, 10), 2), "twice"), InputError);
}

TEST_F(SharedCertification, goes_on_from_what_is_finished) {
  SharedOptions options = options_for("sphere-2", Rational(1, 12), 3);
  const std::string root = run(3, options, "whole").root;
  // What a rank that is killed leaves behind: here one throws when chunks are to be written into a file.
  options.certify.output = (folder_ / "ended").string();
  std::filesystem::create_directories(folder_ / "ended/2.json.zst");
  EXPECT_ANY_THROW((void)run(3, options, "ended"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "ended.progress/net"));
  std::filesystem::remove(folder_ / "ended/2.json.zst");
  // Another run does not take it for its own.
  SharedOptions other = options;
  other.certify.origin = {{"command", "another"}};
  EXPECT_THROW(run(3, other, "ended"), InputError);
  EXPECT_THROW(run(2, options, "ended"), InputError);
  const SharedReport report = run(3, options, "ended");
  EXPECT_EQ(report.root, root);
  EXPECT_EQ(report.restored_colours, report.colours);
  EXPECT_GT(report.colours, 10U);
  EXPECT_TRUE(files_in(folder_ / "ended") == files_in(folder_ / "whole"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
