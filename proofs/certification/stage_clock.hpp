#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How long each stage of a run took and which rungs settled its decisions, told by the stages' own reports of
/// progress: a stage begins with its first report and ends when another begins.
class StageClock {
 public:
  struct Stage {
    std::string name;
    double seconds = 0;
    LadderStatistics decisions;
  };

  /// Passes every report on to `inner`.
  [[nodiscard]] Progress callback(Progress inner);
  /// Begins a stage that does not report.
  void begin(std::string_view name);
  /// Ends the last stage. The stages in the order in which they first began; repeated ones are added up.
  [[nodiscard]] std::vector<Stage> finish();

 private:
  void end_current();

  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  bool running_ = false;
  std::chrono::steady_clock::time_point start_;
  LadderStatistics decisions_before_;
};

}  // namespace delcert
