#include "proofs/drawing/formats/drawing_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(DrawingJson, HasTheWholeDrawing) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const auto json = nlohmann::json::parse(drawing_json(certificate, drawing, Verification::not_asked, false));
    EXPECT_EQ(json.at("format"), "delcert-drawing");
    EXPECT_EQ(json.at("version"), 1);
    EXPECT_EQ(json.at("certificate").at("sha256"), certificate.seal);
    EXPECT_TRUE(json.at("certificate").at("verified").is_null());
    EXPECT_EQ(json.at("copies"), "cell");
    EXPECT_EQ(json.at("vertices").at("coordinates").size(), drawing.vertex_count() * drawing.ambient_dimension) << name;
    EXPECT_EQ(json.at("vertices").at("label"), nlohmann::json(drawing.labels));
    EXPECT_EQ(json.at("simplices"), nlohmann::json(drawing.simplices));
    EXPECT_EQ(json.at("matching_faces").size(), drawing.matching_faces.size());
    const auto& protection = json.at("measures").at("protection");
    ASSERT_EQ(protection.size(), drawing.simplex_count());
    for (std::size_t k = 0; k < protection.size(); ++k)
      EXPECT_NEAR(protection[k].get<double>() / drawing.measures.protection[drawing.positions[k]], 1, 1e-8);
    EXPECT_EQ(json.at("measures").at("hinge").is_null(), drawing.measures.hinge.empty()) << name;
    EXPECT_FALSE(json.contains("exact"));
  }
}

TEST(DrawingJson, SaysWhatTheCheckerSaidAndTheExactNumbersIfAsked) {
  const CertificateSummary certificate = test::torus_certificate();
  const Drawing drawing = drawing_of(certificate, {});
  const auto json = nlohmann::json::parse(drawing_json(certificate, drawing, Verification::verified, true));
  EXPECT_EQ(json.at("certificate").at("verified"), true);
  EXPECT_EQ(json.at("exact").at("coordinates").size(), certificate.points.size());
  EXPECT_NE(drawing_json(certificate, drawing, Verification::rejected, false).find("\"verified\":false"),
            std::string::npos);
}

TEST(DrawingJson, WhatCannotBeMeasuredIsNull) {
  CertificateSummary certificate = test::hexagon_certificate();
  certificate.points.back() = certificate.points.front();
  const Drawing drawing = drawing_of(certificate, {});
  const auto json = nlohmann::json::parse(drawing_json(certificate, drawing, Verification::not_asked, false));
  EXPECT_TRUE(json.at("measures").at("thickness").back().is_null());
  EXPECT_FALSE(json.at("measures").at("thickness").front().is_null());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
