#pragma once

#include <array>
#include <cstdint>

#include "kernel/number/algebraic.hpp"
#include "kernel/number/filter.hpp"
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

namespace detail {
template <class Predicate>
bool settles(Rung rung, Verdict& verdict, const Predicate& predicate) {
  verdict = predicate();
  if (is_undecided(verdict)) return false;
  ladder_statistics().count(rung);
  return true;
}
}  // namespace detail

/// The part of the ladder above the filter: for callers that have already found the interval rung undecided.
/// `predicate.template operator()<S>()` returns the verdict computed in S, S = BigInterval, Rational.
template <class Predicate>
[[nodiscard]] Verdict decide_above_filter(const Predicate& predicate) {
  Verdict verdict = Verdict::undecided;
  {
    const BigInterval::Precision precision(PrecisionBits{128});
    if (detail::settles(Rung::big_interval, verdict, [&] { return predicate.template operator()<BigInterval>(); }))
      return verdict;
  }
  if (detail::settles(Rung::rational, verdict, [&] { return predicate.template operator()<Rational>(); }))
    return verdict;
  ++ladder_statistics().undecided;
  return Verdict::undecided;
}

/// Decides a predicate about rational quantities: intervals, 128-bit intervals, rationals, in this order, until one
/// is sure. The rational rung always is, unless the predicate itself gives up (a degenerate simplex, say).
template <class Predicate>
[[nodiscard]] Verdict decide(const Predicate& predicate) {
  Verdict verdict = Verdict::undecided;
  {
    const FilterGuard guard;
    if (detail::settles(Rung::interval, verdict, [&] { return predicate.template operator()<Filter>(); }))
      return verdict;
  }
  return decide_above_filter(predicate);
}

/// The part of `decide_algebraic` above the filter.
/// `predicate.template operator()<S>()` returns the verdict computed in S, S = BigInterval, Algebraic.
template <class Predicate>
[[nodiscard]] Verdict decide_algebraic_above_filter(const Predicate& predicate) {
  constexpr unsigned first_precision = 128;
  constexpr unsigned last_precision = 4096;
  Verdict verdict = Verdict::undecided;
  for (unsigned bits = first_precision; bits <= last_precision; bits *= 2) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    if (detail::settles(Rung::big_interval, verdict, [&] { return predicate.template operator()<BigInterval>(); }))
      return verdict;
  }
  try {
    if (detail::settles(Rung::algebraic, verdict, [&] { return predicate.template operator()<Algebraic>(); }))
      return verdict;
  } catch (const Algebraic::TooLarge&) {
    // Undecided, like a predicate that gives up.
  }
  ++ladder_statistics().undecided;
  return Verdict::undecided;
}

/// Decides a predicate about quantities with square roots: intervals, intervals of 128, 256, … 4096 bits, algebraic
/// numbers. The algebraic rung is always sure, unless the predicate itself gives up or the degree grows beyond what
/// `Algebraic` takes on.
template <class Predicate>
[[nodiscard]] Verdict decide_algebraic(const Predicate& predicate) {
  Verdict verdict = Verdict::undecided;
  {
    const FilterGuard guard;
    if (detail::settles(Rung::interval, verdict, [&] { return predicate.template operator()<Filter>(); }))
      return verdict;
  }
  return decide_algebraic_above_filter(predicate);
}

}  // namespace delcert
