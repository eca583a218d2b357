#include "proofs/formula/object.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Types, are_told_apart_by_name_and_by_being_a_set) {
  EXPECT_EQ(types::integer, (Type{"integer", false}));
  EXPECT_NE(types::integer, types::number);
  EXPECT_NE(types::integer, types::integers);
}

TEST(Types, have_a_text_for_messages) {
  EXPECT_EQ(types::number.text(), "number");
  EXPECT_EQ(types::integers.text(), "set of integer");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
