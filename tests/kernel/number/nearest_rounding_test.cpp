#include "kernel/number/nearest_rounding.hpp"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <stdexcept>
#include <type_traits>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(!std::is_copy_constructible_v<NearestRounding> && !std::is_move_constructible_v<NearestRounding>);

unsigned mode() { return _MM_GET_ROUNDING_MODE(); }
constexpr unsigned nearest = 0;
constexpr unsigned upward = 0x4000;

TEST(NearestRounding, suspends_a_guard_while_it_lives) {
  volatile double one = 1;
  volatile double little = 0x1p-80;
  const RoundingGuard guard;
  {
    const NearestRounding nearest_rounding;
    EXPECT_EQ(mode(), nearest);
    const volatile double sum = one + little;
    EXPECT_EQ(sum, 1.0);
  }
  EXPECT_EQ(mode(), upward);
  const volatile double sum = one + little;
  EXPECT_EQ(sum, 0x1.0000000000001p0);
}

TEST(NearestRounding, changes_nothing_where_rounding_is_to_nearest_already) {
  {
    const NearestRounding nearest_rounding;
    EXPECT_EQ(mode(), nearest);
  }
  EXPECT_EQ(mode(), nearest);
}

TEST(NearestRounding, restores_the_mode_when_an_exception_passes) {
  const RoundingGuard guard;
  EXPECT_THROW(
      {
        const NearestRounding nearest_rounding;
        throw std::runtime_error("");
      },
      std::runtime_error);
  EXPECT_EQ(mode(), upward);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
