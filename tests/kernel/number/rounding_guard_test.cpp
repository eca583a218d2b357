#include "kernel/number/rounding_guard.hpp"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <stdexcept>
#include <thread>
#include <type_traits>

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(!std::is_copy_constructible_v<RoundingGuard> && !std::is_move_constructible_v<RoundingGuard>);

unsigned mode() { return _MM_GET_ROUNDING_MODE(); }
constexpr unsigned nearest = 0;
constexpr unsigned upward = 0x4000;

TEST(RoundingGuard, rounds_upwards_while_it_lives) {
  volatile double one = 1;
  volatile double little = 0x1p-80;
  {
    const RoundingGuard guard;
    EXPECT_EQ(mode(), upward);
    const volatile double sum = one + little;
    EXPECT_EQ(sum, 0x1.0000000000001p0);
  }
  EXPECT_EQ(mode(), nearest);
  const volatile double sum = one + little;
  EXPECT_EQ(sum, 1.0);
}

TEST(RoundingGuard, nests) {
  const RoundingGuard outer;
  {
    const RoundingGuard inner;
    EXPECT_EQ(mode(), upward);
  }
  EXPECT_EQ(mode(), upward);
}

TEST(RoundingGuard, restores_the_mode_when_an_exception_passes) {
  EXPECT_THROW(
      {
        const RoundingGuard guard;
        throw std::runtime_error("");
      },
      std::runtime_error);
  EXPECT_EQ(mode(), nearest);
}

TEST(RoundingGuard, is_one_threads_own) {
  unsigned elsewhere = upward;
  {
    std::thread other([&elsewhere] { elsewhere = mode(); });
    const RoundingGuard guard;
    other.join();
    EXPECT_EQ(mode(), upward);
  }
  EXPECT_EQ(elsewhere, nearest);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
