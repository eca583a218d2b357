#include "proofs/publication/certificate_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "proofs/certification/certification.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(CertificatePage, has_the_constants_for_the_parameters_and_the_digest_of_the_file) {
  const test::TemporaryFolder folder;
  CertifyOptions options;
  options.source.manifold = "torus-2";
  options.source.lattice = 12;
  options.source.displacement_exponent = 8;
  options.choice.mode = RunMode::measured;
  options.output = (folder / "torus.json").string();
  (void)certified_run(options, no_progress());
  const PageItem item = certificate_page_item(options.output, {});
  EXPECT_EQ(item.data.at("header").at("file_sha256"), shown_file(options.output).sha256);
  EXPECT_EQ(shown_file(options.output).name, "torus.json");
  EXPECT_TRUE(item.data.at("ledger").contains("flake_divisor"));
  EXPECT_THROW((void)certificate_page_item(folder / "tours.json", {}), InputError);
}

TEST(CertificatePage, a_digest_is_that_of_the_bytes) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "abc", "abc");
  EXPECT_EQ(shown_file(folder / "abc").sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_THROW((void)shown_file(folder / "abd"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
