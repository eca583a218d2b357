#include "kernel/formula/formula_error.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(FormulaErrors, the_place_is_kept) {
  const FormulaError error(7, "message");
  EXPECT_EQ(error.offset(), 7U);
  EXPECT_STREQ(error.what(), "message");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
