#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "support/progress.hpp"

namespace delcert {

/// One line on a terminal that says how far long work has come, how long it took, and how long it may still take:
/// "perturbing: 4120/10293 (40 %), 2 s, about 3 s left". It is drawn after a fifth of a second and at most ten times
/// a second, and removed at the end. Where standard error is not a terminal nothing is drawn, unless plain lines are
/// asked for.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;
  using Now = std::function<Clock::time_point()>;

  /// On standard error.
  ProgressLine();
  /// On any stream and with any clock.
  ProgressLine(std::ostream& out, bool shown, Now now = Clock::now);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Where nothing is drawn, from now on a plain line with the same, so often: for work of hours whose standard error
  /// is a file.
  void also_without_terminal(std::chrono::milliseconds every);

  /// Precondition: done <= total.
  void update(std::string_view stage, std::size_t done, std::size_t total);
  /// Removes the line, so that something else can be printed.
  void clear();

  /// For long work: updates the line, and throws Interrupted after Ctrl-C. Valid while this object lives.
  [[nodiscard]] Progress callback();

 private:
  [[nodiscard]] std::string text(std::size_t done, std::size_t total, std::chrono::milliseconds elapsed) const;

  std::ostream& out_;
  bool shown_;
  Now now_;
  std::string stage_;
  std::size_t done_before_ = 0;  ///< when the stage began
  Clock::time_point stage_start_;
  Clock::time_point last_drawn_;
  bool on_screen_ = false;
  std::optional<std::chrono::milliseconds> every_;
};

}  // namespace delcert
