#pragma once

#include <optional>
#include <vector>

#include "proofs/prover/prover.hpp"

namespace delcert {

/// How far a constant of a step can be moved, the others being what they are: the best value lies between `proved`,
/// with which the step is proved, and `refuted`, with which it is refuted.
struct Slack {
  std::string constant;
  Rational stated;
  std::optional<Rational> proved;   ///< nothing if no value near was proved
  std::optional<Rational> refuted;  ///< nothing if none was refuted: the step seems to hold with any value
  std::map<std::string, Rational> counterexample;  ///< with the value `refuted`
  std::size_t attempts = 0;                        ///< how often the prover was asked

  /// |proved − refuted| is at most 1/1000 of the greater: what is between is decided but for that.
  [[nodiscard]] bool is_sharp() const;
};

/// Less work than for the step itself: there are many attempts, and those next to the best value take the most.
inline constexpr SearchLimits slack_limits{4000, 100000, 4, 40};

/// The best value of a constant by bisection. In which direction the step becomes false is found out by trying, up to a
/// factor of 2^64. A step that is false with the value stated is asked for values with which it is true.
/// Precondition: the step has the constant.
[[nodiscard]] Slack slack_of(const Step& step, const std::string& constant, const SearchLimits& limits = slack_limits);

}  // namespace delcert
