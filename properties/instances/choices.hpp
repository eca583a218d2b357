#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/random/counter_random.hpp"

namespace delcert {

/// Where an instance class takes its decisions from, as numbers in [0, 1): random ones for an attack, the coordinates
/// of a search for `tighten`. Draw the numbers that matter most first.
class Choices {
 public:
  Choices() = default;
  Choices(const Choices&) = delete;
  Choices& operator=(const Choices&) = delete;
  virtual ~Choices() = default;

  /// A multiple of 2⁻⁵³ in [0, 1).
  [[nodiscard]] virtual double unit() = 0;

  /// True with the given probability.
  [[nodiscard]] bool happens(double probability) { return unit() < probability; }
  /// first … last, both included. Precondition: first ≤ last.
  [[nodiscard]] long between(long first, long last);
  /// A multiple of 2^−bits in [−1, 1). Precondition: bits ≤ 52.
  [[nodiscard]] Rational symmetric(unsigned bits);
  /// A multiple of 2^−bits in [0, 1). Precondition: bits ≤ 53.
  [[nodiscard]] Rational fraction(unsigned bits);
};

/// Random choices that depend on (seed, stream, number) only. Numbers from 2³² on use streams of their own.
class RandomChoices : public Choices {
 public:
  RandomChoices(std::uint64_t seed, std::uint32_t stream, std::uint64_t number)
      : random_(seed, RandomPurpose::instances, stream + static_cast<std::uint32_t>(number >> 32U) * odd,
                static_cast<std::uint32_t>(number)) {}
  [[nodiscard]] double unit() override { return random_.next_unit(); }

 private:
  static constexpr std::uint32_t odd = 2654435769U;
  CounterRandom random_;
};

/// Given choices, rounded to multiples of 2⁻⁵³ in [0, 1), then ½ for ever.
class GivenChoices : public Choices {
 public:
  explicit GivenChoices(std::vector<double> values) : values_(std::move(values)) {}
  [[nodiscard]] double unit() override;
  /// How many have been asked for.
  [[nodiscard]] std::size_t taken() const { return taken_; }

 private:
  std::vector<double> values_;
  std::size_t taken_ = 0;
};

/// A 32-bit number that tells texts apart, the same everywhere (FNV-1a).
[[nodiscard]] std::uint32_t stream_of(std::string_view text);

}  // namespace delcert
