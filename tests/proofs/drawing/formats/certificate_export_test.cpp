#include "proofs/drawing/formats/certificate_export.hpp"

#include <gtest/gtest.h>

#include "proofs/drawing/formats/surface_formats.hpp"
#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(CertificateExport, is_what_the_format_makes_of_a_drawing) {
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  ExportRequest request;
  request.format = &export_format("off");
  request.drawing.copies = DrawingCopies::glued;
  const Drawing drawing = drawing_of(certificate, request.drawing);
  ExportContent content{certificate};
  content.drawing = &drawing;
  const ExportedText found = exported(certificate, request);
  EXPECT_EQ(found.text, off_text(content));
  EXPECT_NE(found.summary.find("approximate"), std::string::npos);
  request.drawing.copies = DrawingCopies::cell;
  EXPECT_NE(exported(certificate, request).text, found.text);
}

TEST(CertificateExport, of_a_simplified_complex_says_how_it_was_made) {
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  ExportRequest request;
  request.format = &export_format("regina");
  const std::string whole = exported(certificate, request).text;
  request.simplify = true;
  const ExportedText found = exported(certificate, request);
  EXPECT_NE(found.summary.find("contractions of edges"), std::string::npos);
  EXPECT_LT(found.text.size(), whole.size());
}

TEST(CertificateExport, of_a_wrong_seal_is_refused) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  ExportRequest request;
  request.format = &export_format("csv");
  EXPECT_NO_THROW((void)exported(certificate, request));
  certificate.sealed_bytes.front() = certificate.sealed_bytes.front() == '0' ? '1' : '0';
  EXPECT_THROW((void)exported(certificate, request), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
