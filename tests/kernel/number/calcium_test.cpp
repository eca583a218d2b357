#include "kernel/number/calcium.hpp"

#include <gtest/gtest.h>

namespace DELCERT_THIS_FILE {

TEST(Calcium, headers_leave_the_allocator_of_flint_as_it_was) {
  void* memory = flint_malloc(16);
  EXPECT_NE(memory, nullptr);
  memory = flint_realloc(memory, 32);
  EXPECT_NE(memory, nullptr);
  flint_free(memory);
}

TEST(Calcium, inline_functions_that_allocate_work) {
  qqbar_ptr numbers = _qqbar_vec_init(3);
  qqbar_set_si(numbers + 2, -7);
  EXPECT_EQ(qqbar_sgn_re(numbers + 2), -1);
  EXPECT_NE(qqbar_is_zero(numbers), 0);
  _qqbar_vec_clear(numbers, 3);
}

}  // namespace DELCERT_THIS_FILE
