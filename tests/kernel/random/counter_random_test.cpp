#include "kernel/random/counter_random.hpp"

#include <set>

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Words = std::array<std::uint32_t, 4>;

/// Philox 4x32-10 once more, from its definition (Salmon et al., Parallel random numbers: as easy as 1, 2, 3).
Words philox(Words counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32U) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32U) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

Words next_four(CounterRandom& random) {
  Words words;
  for (auto& word : words) word = random.next_word();
  return words;
}

TEST(CounterRandom, gives_the_published_words_for_counter_and_key_zero) {
  CounterRandom random(0, RandomPurpose::darts, 0, 0);
  EXPECT_EQ(next_four(random), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(CounterRandom, is_philox_of_seed_label_attempt_and_purpose) {
  const std::uint64_t seed = 0x0123456789abcdef;
  for (const auto purpose :
       {RandomPurpose::darts, RandomPurpose::gap_filling, RandomPurpose::jitter, RandomPurpose::perturbation}) {
    CounterRandom random(seed, purpose, 0xfedcba98, 77);
    for (std::uint32_t block = 0; block < 3; ++block) {
      const Words counter{0xfedcba98, 77, static_cast<std::uint32_t>(purpose), block};
      EXPECT_EQ(next_four(random), philox(counter, {0x89abcdef, 0x01234567}));
    }
  }
}

TEST(CounterRandom, has_streams_that_differ_in_every_argument) {
  std::set<Words> blocks;
  const auto first_block = [](std::uint64_t seed, RandomPurpose purpose, std::uint32_t label, std::uint32_t attempt) {
    CounterRandom random(seed, purpose, label, attempt);
    return next_four(random);
  };
  std::size_t count = 0;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32U}) {
    for (const auto purpose : {RandomPurpose::darts, RandomPurpose::jitter, RandomPurpose::perturbation}) {
      for (const std::uint32_t label : {0U, 1U, 0xffffffffU}) {
        for (const std::uint32_t attempt : {0U, 1U, 100000U}) {
          blocks.insert(first_block(seed, purpose, label, attempt));
          ++count;
        }
      }
    }
  }
  EXPECT_EQ(blocks.size(), count);
}

TEST(CounterRandom, has_units_that_are_multiples_of_two_to_the_minus_53_below_1) {
  CounterRandom random(5, RandomPurpose::darts, 3, 0);
  CounterRandom words(5, RandomPurpose::darts, 3, 0);
  double total = 0;
  double least = 1;
  double most = 0;
  constexpr int draws = 4000;
  for (int draw = 0; draw < draws; ++draw) {
    const double unit = random.next_unit();
    const Rational high(words.next_word() >> 5U);
    const Rational low(words.next_word() >> 6U);
    EXPECT_EQ(Rational::exactly(unit), (high * Rational::power_of_two(26) + low) * Rational::power_of_two(-53));
    total += unit;
    least = std::min(least, unit);
    most = std::max(most, unit);
  }
  EXPECT_NEAR(total / draws, 0.5, 0.02);
  EXPECT_LT(least, 0.002);
  EXPECT_GT(most, 0.998);
  EXPECT_LT(most, 1);
}

TEST(CounterRandom, has_integers_of_the_bits_asked_for) {
  CounterRandom random(9, RandomPurpose::perturbation, 1, 2);
  EXPECT_EQ(random.next_integer(0), 0);
  for (const unsigned bits : {1U, 2U, 31U, 32U, 33U, 64U, 70U, 200U}) {
    Integer seen_once = 0;
    Integer seen_always = (Integer(1) << bits) - 1;
    for (int draw = 0; draw < 200; ++draw) {
      const Integer drawn = random.next_integer(bits);
      EXPECT_GE(drawn, 0);
      EXPECT_LT(drawn, Integer(1) << bits);
      seen_once |= drawn;
      seen_always &= drawn;
    }
    // Every bit is 1 sometimes and 0 sometimes.
    EXPECT_EQ(seen_once, (Integer(1) << bits) - 1) << bits;
    EXPECT_EQ(seen_always, 0) << bits;
  }
}

TEST(CounterRandom, draws_small_integers_equally_often) {
  CounterRandom random(10, RandomPurpose::perturbation, 1, 2);
  std::array<int, 8> counts{};
  constexpr int draws = 8000;
  for (int draw = 0; draw < draws; ++draw) ++counts.at(random.next_integer(3).convert_to<std::size_t>());
  for (const int count : counts) EXPECT_NEAR(count, draws / 8, 150);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
