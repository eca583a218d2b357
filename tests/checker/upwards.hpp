#pragma once

#include <gtest/gtest.h>

#include <cfenv>

#include "proofs/checker/program/self_test.hpp"

namespace delcert::test {

/// The checker computes with upward rounding, which its self-test sets; others in the same process round to nearest.
struct Upwards {
  Upwards() { EXPECT_EQ(checker::self_test(), ""); }
  ~Upwards() { std::fesetround(FE_TONEAREST); }
  Upwards(const Upwards&) = delete;
  Upwards& operator=(const Upwards&) = delete;
};

}  // namespace delcert::test
