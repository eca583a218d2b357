#include "proofs/publication/certificate_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(CertificatePage, has_the_constants_for_the_parameters_and_the_digest_of_the_file) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "torus.json").string();
  small_run().write(file);
  const PageItem item = certificate_page_item(file, {});
  EXPECT_EQ(item.data.at("header").at("file_sha256"), shown_file(file).sha256);
  EXPECT_EQ(shown_file(file).name, "torus.json");
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
