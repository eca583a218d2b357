#include "apps/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

#include "apps/interruption.hpp"
#include "support/duration.hpp"

namespace delcert {

namespace {

using Milliseconds = std::chrono::milliseconds;

constexpr Milliseconds before_first(200);
constexpr Milliseconds between(100);
constexpr const char* erase_line = "\r\x1b[K";

bool standard_error_is_a_terminal() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

ProgressLine::ProgressLine() : ProgressLine(std::cerr, standard_error_is_a_terminal()) {}

ProgressLine::ProgressLine(std::ostream& out, bool shown, Now now)
    : out_(out), shown_(shown), now_(std::move(now)), stage_start_(now_()), last_drawn_(stage_start_) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::also_without_terminal(Milliseconds every) {
  if (!shown_) every_ = every;
}

std::string ProgressLine::text(std::size_t done, std::size_t total, Milliseconds elapsed) const {
  std::string result = stage_ + ": " + std::to_string(done);
  if (total != 0) result += "/" + std::to_string(total) + " (" + std::to_string(done * 100 / total) + " %)";
  result += ", " + duration_text(elapsed);
  // What was there when the stage began says nothing of how fast it is.
  const std::size_t done_since = done - std::min(done, done_before_);
  if (done_since != 0 && done < total) {
    const double share = static_cast<double>(total - done) / static_cast<double>(done_since);
    const Milliseconds remaining(static_cast<std::int64_t>(static_cast<double>(elapsed.count()) * share));
    result += ", about " + duration_text(remaining) + " left";
  }
  return result;
}

void ProgressLine::update(std::string_view stage, std::size_t done, std::size_t total) {
  if (!shown_ && !every_) return;
  const Clock::time_point now = now_();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
    done_before_ = done;
    if (every_) last_drawn_ = now;
  }
  const auto elapsed = std::chrono::duration_cast<Milliseconds>(now - stage_start_);
  if (now - last_drawn_ < every_.value_or(between)) return;
  if (shown_ && elapsed < before_first) return;
  last_drawn_ = now;
  if (!shown_) {
    out_ << text(done, total, elapsed) << std::endl;
    return;
  }
  out_ << erase_line << text(done, total, elapsed) << std::flush;
  on_screen_ = true;
}

void ProgressLine::clear() {
  if (on_screen_) out_ << erase_line << std::flush;
  on_screen_ = false;
}

Progress ProgressLine::callback() {
  return [this](std::string_view stage, std::size_t done, std::size_t total) {
    throw_if_interrupted();
    update(stage, done, total);
  };
}

}  // namespace delcert
