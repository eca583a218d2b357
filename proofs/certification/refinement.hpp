#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace delcert {

/// What a run failed at before radii were made smaller there.
struct FailedRound {
  std::string stage;       ///< "charts", "stars", "level 5", "level 5i": where it ended
  std::size_t places = 0;  ///< at so many places
  std::size_t points = 0;  ///< of so many points; 0 while charts do not fit, of which the first ones are known only
};

/// Watches whether smaller radii help. Rounds differ in how far they come; those that end at the same stage are
/// compared.
class Refinement {
 public:
  void add(FailedRound round) { rounds_.push_back(std::move(round)); }
  [[nodiscard]] std::size_t size() const { return rounds_.size(); }

  /// Whether another round is not worth its points: charts fit, the last one ended at the same stage as the one before,
  /// at no fewer places, and they are more than one in fifty points, or it was so the round before too.
  [[nodiscard]] bool has_stalled() const;
  /// "refined 2 times, level 5 failed at 41 of 13482 points, at 120 the time before, some 2 more rounds"; empty before
  /// the first round.
  [[nodiscard]] std::string text() const;
  /// What to say where `has_stalled`.
  [[nodiscard]] std::string reason() const;

 private:
  [[nodiscard]] bool is_no_better(std::size_t round) const;
  /// If places go on to become fewer at the rate of the last round.
  [[nodiscard]] std::optional<std::size_t> rounds_left() const;
  std::vector<FailedRound> rounds_;
};

}  // namespace delcert
