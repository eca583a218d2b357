#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

#include "kernel/number/rational.hpp"

namespace delcert {

/// What a random number is for: streams never share numbers.
enum class RandomPurpose : std::uint32_t { darts, gap_filling, jitter, perturbation, instances };

/// Random numbers that depend on (seed, purpose, label, attempt) only: the same on every machine, for every compiler
/// and any order of evaluation. Philox 4x32-10 of Random123.
class CounterRandom {
 public:
  CounterRandom(std::uint64_t seed, RandomPurpose purpose, std::uint32_t label, std::uint32_t attempt)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}},
        counter_{{label, attempt, static_cast<std::uint32_t>(purpose), 0}} {}

  [[nodiscard]] std::uint32_t next_word() {
    if (used_ == 4) {
      block_ = generator_(counter_, key_);
      ++counter_[3];
      used_ = 0;
    }
    return block_[used_++];
  }

  /// A multiple of 2⁻⁵³ in [0, 1).
  [[nodiscard]] double next_unit() {
    const std::uint64_t high = next_word() >> 5U;
    const std::uint64_t low = next_word() >> 6U;
    return static_cast<double>((high << 26U) | low) * 0x1p-53;
  }

  /// Uniform on the integers 0 … 2^bits − 1.
  [[nodiscard]] Integer next_integer(unsigned bits) {
    Integer result = 0;
    for (unsigned taken = 0; taken < bits; taken += 32) {
      const unsigned wanted = bits - taken < 32 ? bits - taken : 32;
      result = (result << wanted) + (next_word() >> (32 - wanted));
    }
    return result;
  }

 private:
  using Generator = r123::Philox4x32;
  Generator generator_;
  Generator::key_type key_;
  Generator::ctr_type counter_;
  Generator::ctr_type block_{};
  std::size_t used_ = 4;
};

}  // namespace delcert
