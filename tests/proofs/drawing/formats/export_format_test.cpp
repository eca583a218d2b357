#include "proofs/drawing/formats/export_format.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(ExportFormat, NamesAreDifferentAndAreFound) {
  std::set<std::string_view> names;
  for (const ExportFormat& format : export_formats()) {
    EXPECT_TRUE(names.insert(format.name).second);
    EXPECT_EQ(&export_format(format.name), &format);
  }
}

TEST(ExportFormat, OneThatIsNotThereIsRefusedWithAGuess) {
  try {
    (void)export_format("jsn");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean json?"), std::string::npos);
  }
}

// What is not written is not measured, and what is measured is written.
TEST(ExportFormat, HasMeasuresIfItsTextDependsOnThem) {
  const CertificateSummary& certificate = test::drawn_certificates().at("flat-torus");
  const Drawing measured = drawing_of(certificate, {});
  DrawingOptions options;
  options.is_measured = false;
  const Drawing unmeasured = drawing_of(certificate, options);
  EXPECT_TRUE(unmeasured.measures.protection.empty() && unmeasured.measures.hinge.empty());
  for (const ExportFormat& format : export_formats()) {
    if (!format.has_coordinates) {
      EXPECT_FALSE(format.has_measures);
      continue;
    }
    ExportContent with{certificate}, without{certificate};
    with.drawing = &measured;
    without.drawing = &unmeasured;
    EXPECT_EQ(format.text(with) != format.text(without), format.has_measures) << format.name;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
