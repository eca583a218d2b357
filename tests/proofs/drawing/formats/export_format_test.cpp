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

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
