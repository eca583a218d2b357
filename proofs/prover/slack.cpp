#include "proofs/prover/slack.hpp"

#include <algorithm>
#include <array>

namespace delcert {

namespace {

const Rational sharpness(Integer(1), Integer(1000));

bool is_narrow(const Rational& a, const Rational& b) {
  return absolute(a - b) <= sharpness * maximum(absolute(a), absolute(b));
}

/// A simple number well between two of the same sign; of such that are far apart, near the geometric mean.
Rational between(const Rational& a, const Rational& b) {
  const Rational lower = minimum(a, b);
  const Rational upper = maximum(a, b);
  if (lower > Rational(0) && upper > Rational(4) * lower) {
    return lower * Rational::power_of_two(std::max(1L, binary_exponent(upper / lower) / 2));
  }
  if (upper < Rational(0) && lower < Rational(4) * upper) {
    return upper * Rational::power_of_two(std::max(1L, binary_exponent(lower / upper) / 2));
  }
  const Rational third = (upper - lower) / Rational(3);
  BoxSide middle;
  middle.lower = lower + third;
  middle.upper = upper - third;
  return simplest_in(middle);
}

class Bisection {
 public:
  Bisection(const Step& step, const std::string& constant, const SearchLimits& limits)
      : step_(step), constants_(step.constants), limits_(limits) {
    slack_.constant = constant;
    slack_.stated = step.constants.at(constant);
  }

  Slack run() {
    const Verdict stated = verdict_with(slack_.stated);
    if (is_proved(stated)) {
      slack_.proved = slack_.stated;
    } else {
      find_proved(is_refuted(stated));
    }
    if (!slack_.proved) return std::move(slack_);
    if (!slack_.refuted && !undecided_) find_refuted();
    narrow();
    return std::move(slack_);
  }

 private:
  Verdict verdict_with(const Rational& value) {
    constants_[slack_.constant] = value;
    ++slack_.attempts;
    const StepOutcome outcome = prove(step_, constants_, limits_);
    if (is_refuted(outcome.verdict)) last_counterexample_ = outcome.counterexample;
    return outcome.verdict;
  }

  /// The stated value moved up or down, further and further.
  [[nodiscard]] std::vector<Rational> moved(bool up) const {
    const Rational& from = slack_.stated;
    std::vector<Rational> result;
    if (from == Rational(0)) {
      for (const long exponent : {-20L, -10L, 0L, 10L}) {
        result.push_back(Rational(up ? 1 : -1) * Rational::power_of_two(exponent));
      }
      return result;
    }
    const bool grows = up == (from > Rational(0));
    const Rational little = Rational(1) + sharpness / Rational(2);
    result.push_back(grows ? from * little : from / little);
    for (const long exponent : {1L, 2L, 4L, 8L, 16L, 32L, 64L}) {
      result.push_back(from * Rational::power_of_two(grows ? exponent : -exponent));
    }
    return result;
  }

  void note_refuted(const Rational& value) {
    slack_.refuted = value;
    slack_.counterexample = last_counterexample_;
  }

  /// From a value that is not proved to the next that is, on either side.
  void find_proved(bool refuted) {
    if (refuted) note_refuted(slack_.stated);
    if (!refuted) undecided_ = slack_.stated;
    const std::array<std::vector<Rational>, 2> ways{moved(true), moved(false)};
    for (std::size_t at = 0; at < ways[0].size(); ++at) {
      for (const auto& way : ways) {
        if (!is_proved(verdict_with(way[at]))) continue;
        slack_.proved = way[at];
        // What lies before it on the same way is nearer.
        if (at > 0) {
          const Verdict before = verdict_with(way[at - 1]);
          if (is_refuted(before)) note_refuted(way[at - 1]);
          if (is_undecided(before)) undecided_ = way[at - 1];
        }
        return;
      }
    }
  }

  void find_refuted() {
    const std::array<std::vector<Rational>, 2> ways{moved(true), moved(false)};
    std::array<Rational, 2> proved{slack_.stated, slack_.stated};
    for (std::size_t at = 0; at < ways[0].size(); ++at) {
      for (std::size_t way = 0; way < 2; ++way) {
        const Verdict verdict = verdict_with(ways[way][at]);
        if (is_proved(verdict)) {
          proved[way] = ways[way][at];
          continue;
        }
        slack_.proved = proved[way];
        if (is_refuted(verdict)) note_refuted(ways[way][at]);
        if (is_undecided(verdict)) undecided_ = ways[way][at];
        return;
      }
    }
  }

  void narrow() {
    constexpr std::size_t most = 80;
    if (undecided_ && !slack_.refuted) look_beyond();
    // The proved end first; what is undecided counts as not proved.
    while (slack_.attempts < most) {
      const std::optional<Rational> other = undecided_ ? undecided_ : slack_.refuted;
      if (!other || is_narrow(*slack_.proved, *other)) break;
      const Rational middle = between(*slack_.proved, *other);
      const Verdict verdict = verdict_with(middle);
      if (is_proved(verdict)) slack_.proved = middle;
      if (is_undecided(verdict)) undecided_ = middle;
      if (is_refuted(verdict)) {
        note_refuted(middle);
        undecided_.reset();
      }
    }
    if (!undecided_ || !slack_.refuted) return;
    Rational open = *undecided_;
    while (slack_.attempts < 2 * most && !is_narrow(open, *slack_.refuted)) {
      const Rational middle = between(open, *slack_.refuted);
      if (is_refuted(verdict_with(middle))) {
        note_refuted(middle);
      } else {
        open = middle;
      }
    }
  }

  /// From proved over undecided on to refuted.
  void look_beyond() {
    Rational distance = *undecided_ - *slack_.proved;
    for (int doubling = 0; doubling < 12; ++doubling) {
      const Rational value = *undecided_ + distance;
      if (is_refuted(verdict_with(value))) {
        note_refuted(value);
        return;
      }
      distance = distance + distance;
    }
  }

  const Step& step_;
  std::map<std::string, Rational> constants_;
  const SearchLimits& limits_;
  Slack slack_;
  std::optional<Rational> undecided_;  ///< the value nearest to `proved` that is neither
  std::map<std::string, Rational> last_counterexample_;
};

}  // namespace

bool Slack::is_sharp() const { return proved && refuted && is_narrow(*proved, *refuted); }

Slack slack_of(const Step& step, const std::string& constant, const SearchLimits& limits) {
  return Bisection(step, constant, limits).run();
}

}  // namespace delcert
