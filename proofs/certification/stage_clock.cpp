#include "proofs/certification/stage_clock.hpp"

#include <algorithm>

namespace delcert {

Progress StageClock::callback(Progress inner) {
  return [this, inner = std::move(inner)](std::string_view stage, std::size_t done, std::size_t total) {
    if (!running_ || stages_[current_].name != stage) begin(stage);
    inner(stage, done, total);
  };
}

void StageClock::begin(std::string_view name) {
  end_current();
  const auto found =
      std::find_if(stages_.begin(), stages_.end(), [&](const Stage& stage) { return stage.name == name; });
  current_ = static_cast<std::size_t>(found - stages_.begin());
  if (found == stages_.end()) stages_.push_back({std::string(name), 0, {}});
  running_ = true;
  start_ = std::chrono::steady_clock::now();
  decisions_before_ = ladder_statistics();
}

std::vector<StageClock::Stage> StageClock::finish() {
  end_current();
  return stages_;
}

void StageClock::end_current() {
  if (!running_) return;
  stages_[current_].seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  stages_[current_].decisions += ladder_statistics() - decisions_before_;
  running_ = false;
}

}  // namespace delcert
