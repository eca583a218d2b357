#pragma once

#include <array>
#include <cstdint>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/filter.hpp"
#include "kernel/number/rational.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

enum class Rung : unsigned char { interval, big_interval, rational, algebraic };
inline constexpr std::size_t rung_count = 4;

/// How many decisions each rung has settled, and how many none could.
struct LadderStatistics {
  std::array<std::uint64_t, rung_count> settled{};
  std::uint64_t undecided = 0;

  void count(Rung rung, std::uint64_t times = 1) { settled[static_cast<std::size_t>(rung)] += times; }
  [[nodiscard]] std::uint64_t total() const;
  LadderStatistics& operator+=(const LadderStatistics& other);
  friend LadderStatistics operator-(const LadderStatistics& a, const LadderStatistics& b);
};

/// The counters of this thread. Code whose filter runs in a tight loop counts its interval decisions here itself.
[[nodiscard]] LadderStatistics& ladder_statistics();

/// One decision that climbs: asked on one rung after the other until a rung is sure, and counted there. How far it goes
/// and over which rungs is the caller's; `decide` is the usual way.
class Ladder {
 public:
  /// Asks on one rung, unless one before was sure. Returns whether the decision is made.
  template <class Predicate>
  bool ask(Rung rung, const Predicate& predicate) {
    if (is_undecided(verdict_)) {
      verdict_ = predicate();
      if (!is_undecided(verdict_)) ladder_statistics().count(rung);
    }
    return !is_undecided(verdict_);
  }

  /// The same in intervals of first, 2·first, … last bits.
  template <class Predicate>
  bool ask_in_bits(unsigned first, unsigned last, const Predicate& predicate) {
    for (unsigned bits = first; bits <= last && is_undecided(verdict_); bits *= 2) {
      const BigInterval::Precision precision(PrecisionBits{bits});
      ask(Rung::big_interval, predicate);
    }
    return !is_undecided(verdict_);
  }

  /// What came of it; a decision that no rung has made is counted.
  [[nodiscard]] Verdict finish() const {
    if (is_undecided(verdict_)) ++ladder_statistics().undecided;
    return verdict_;
  }

 private:
  Verdict verdict_ = Verdict::undecided;
};

/// The part of the ladder above the filter: for callers that have already found the interval rung undecided.
/// `predicate.template operator()<S>()` returns the verdict computed in S, S = BigInterval, Rational.
template <class Predicate>
[[nodiscard]] Verdict decide_above_filter(const Predicate& predicate) {
  Ladder ladder;
  ladder.ask_in_bits(128, 128, [&] { return predicate.template operator()<BigInterval>(); });
  ladder.ask(Rung::rational, [&] { return predicate.template operator()<Rational>(); });
  return ladder.finish();
}

/// Decides a predicate about rational quantities: intervals, 128-bit intervals, rationals, in this order, until one
/// is sure. The rational rung always is, unless the predicate itself gives up (a degenerate simplex, say).
template <class Predicate>
[[nodiscard]] Verdict decide(const Predicate& predicate) {
  {
    const FilterGuard guard;
    Ladder filter;
    if (filter.ask(Rung::interval, [&] { return predicate.template operator()<Filter>(); })) return filter.finish();
  }
  return decide_above_filter(predicate);
}

}  // namespace delcert
