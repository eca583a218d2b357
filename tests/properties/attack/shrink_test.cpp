#include "properties/attack/shrink.hpp"

#include <gtest/gtest.h>

#include "properties/attack/attempt.hpp"
#include "properties/attack/tally.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::triangle_bindings;
using test::wrong_claim;

bool is_violated(const Bindings& bindings) {
  return is_refuted(attempt(wrong_claim(), bindings).conclusions.at(0).verdict);
}

const InstanceClass& simplices() { return instance_class("simplex"); }

/// Some instance that refutes the wrong claim, of many digits.
Bindings found_instance() {
  const Claim claim = wrong_claim();
  for (std::uint64_t number = 0;; ++number) {
    const auto instance = sample_instance(claim, {3, 4}, 1, number);
    if (instance && is_violated(instance->bindings) && written_size(simplices(), instance->bindings) > 7200) {
      return instance->bindings;
    }
  }
}

TEST(Shrink, a_counterexample_becomes_one_that_a_person_can_read) {
  const Bindings found = found_instance();
  const Bindings result = shrunk(simplices(), found, is_violated);
  EXPECT_TRUE(is_violated(result));
  EXPECT_NO_THROW(simplices().require(result));
  EXPECT_EQ(std::get<long>(result.at("k")), 2);
  EXPECT_EQ(std::get<long>(result.at("m")), 2);
  // Two dimensions and some 60 characters of JSON around six small numbers.
  EXPECT_LT(written_size(simplices(), result), 4150U);
}

TEST(Shrink, what_nothing_simpler_has_stays_as_it_is) {
  const Bindings whole = triangle_bindings(Rational(1) / Rational(3), Rational::power_of_two(-70));
  const std::size_t size = written_size(simplices(), whole);
  const Bindings result = shrunk(
      simplices(), whole, [&](const Bindings& candidate) { return written_size(simplices(), candidate) >= size; });
  EXPECT_EQ(written_size(simplices(), result), size);
}

TEST(Shrink, it_ends_when_everything_simpler_has_the_property) {
  const Bindings result = shrunk(simplices(), found_instance(), [](const Bindings&) { return true; });
  EXPECT_EQ(std::get<long>(result.at("k")), 1);
  EXPECT_EQ(std::get<long>(result.at("m")), 1);
}

TEST(Shrink, no_more_are_asked_than_allowed) {
  std::size_t asked = 0;
  (void)shrunk(
      simplices(), found_instance(),
      [&](const Bindings&) {
        ++asked;
        return false;
      },
      10);
  EXPECT_EQ(asked, 10U);
}

TEST(Shrink, a_candidate_that_cannot_be_asked_does_not_have_the_property) {
  const Bindings found = found_instance();
  const auto cannot = [](const Bindings&) -> bool { throw InputError("vertex 7 of a triangle"); };
  EXPECT_EQ(written_size(simplices(), shrunk(simplices(), found, cannot)), written_size(simplices(), found));
  const auto interrupted = [](const Bindings&) -> bool { throw std::runtime_error("interrupted"); };
  EXPECT_THROW((void)shrunk(simplices(), found, interrupted), std::runtime_error);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
