#include "proofs/report/certificate_item.hpp"

#include <gtest/gtest.h>

#include "proofs/certificate/summary_json.hpp"
#include "proofs/report/fitting_drawing.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(CertificateItem, has_what_info_prints_and_a_drawing) {
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  const PageItem item = certificate_item(certificate, {"t.json", "abc"}, {});
  auto header = item.data.at("header");
  EXPECT_EQ(header.at("file_sha256"), "abc");
  header.erase("file_sha256");
  EXPECT_EQ(header, summary_json(certificate));
  EXPECT_EQ(item.data.at("simplices"), certificate.simplices.size());
  EXPECT_TRUE(item.data.at("check").is_null());
  EXPECT_EQ(item.data.at("seal_fits"), true);
  CertificateSummary changed = certificate;
  changed.sealed_bytes.front() = changed.sealed_bytes.front() == '0' ? '1' : '0';
  EXPECT_EQ(certificate_item(changed, {"t.json", ""}, {}).data.at("seal_fits"), false);
  EXPECT_TRUE(item.data.at("notes").empty());
  EXPECT_FALSE(item.data.at("drawing").is_null());
  EXPECT_FALSE(item.data.at("drawing").at("exact").is_null());
  EXPECT_FALSE(item.block.empty());
  EXPECT_EQ(item.data.at("drawing").at("exact_names"), (std::vector<std::string>{"coordinate 1", "coordinate 2"}));
  const PageItem sphere = certificate_item(drawn_certificates().at("submanifold"), {"s.json", ""}, {});
  EXPECT_EQ(sphere.data.at("drawing").at("exact_names"),
            (std::vector<std::string>{"net point 1", "net point 2", "net point 3", "moved in its chart by 1",
                                      "moved in its chart by 2"}));
}

TEST(CertificateItem, has_what_the_checker_said) {
  const CheckRecord check{"delcert-check 0.0.0", "2001-02-03", {{"status", "rejected"}, {"exit", 1}}};
  const PageItem item = certificate_item(drawn_certificates().at("sphere-2"), {"s.json", ""}, check);
  EXPECT_EQ(item.data.at("check").at("checker"), "delcert-check 0.0.0");
  EXPECT_EQ(item.data.at("check").at("result").at("status"), "rejected");
}

TEST(CertificateItem, of_what_cannot_be_drawn_says_why) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  certificate.simplices.at(0).at(0) = 1000000;
  const PageItem item = certificate_item(certificate, {"t.json", ""}, {});
  EXPECT_TRUE(item.data.at("drawing").is_null());
  EXPECT_TRUE(item.block.empty());
  ASSERT_EQ(item.data.at("notes").size(), 1U);
  EXPECT_TRUE(item.data.at("notes").at(0).get<std::string>().starts_with("There is no picture"));
}

TEST(CertificateItem, keeps_to_its_budget) {
  // Thousands of digits that nothing compresses well: they do not fit, and the page says that it leaves them out.
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  Rational power(1);
  for (int step = 0; step < 3000; ++step) power = power * Rational(3, 7);
  for (auto& point : certificate.points) {
    power = power * Rational(7, 11);
    point[0] = point[0] + power;
  }
  const PageItem item = certificate_item(certificate, {"t.json", ""}, {});
  EXPECT_LE(item.block.size(), PageBudget().bytes(certificate.simplices.size()));
  EXPECT_TRUE(item.data.at("drawing").at("exact").is_null());
  ASSERT_EQ(item.data.at("notes").size(), 1U);
  EXPECT_NE(item.data.at("notes").at(0).get<std::string>().find("exact coordinates are left out"), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
