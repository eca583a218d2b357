#include "apps/progress_line.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

#include "apps/interruption.hpp"

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

std::string duration_text(std::int64_t milliseconds) {
  const std::int64_t seconds = (milliseconds + 999) / 1000;
  if (seconds < 120) return std::to_string(seconds) + " s";
  if (seconds < 7200) return std::to_string(seconds / 60) + " min";
  return std::to_string(seconds / 3600) + " h " + std::to_string(seconds / 60 % 60) + " min";
}

}  // namespace

ProgressLine::ProgressLine() : ProgressLine(std::cerr, standard_error_is_a_terminal()) {}

ProgressLine::ProgressLine(std::ostream& out, bool shown, Now now)
    : out_(out), shown_(shown), now_(std::move(now)), stage_start_(now_()), last_drawn_(stage_start_) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::update(std::string_view stage, std::size_t done, std::size_t total) {
  if (!shown_) return;
  const Clock::time_point now = now_();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
  }
  const auto elapsed = std::chrono::duration_cast<Milliseconds>(now - stage_start_);
  if (elapsed < before_first || now - last_drawn_ < between) return;
  last_drawn_ = now;

  out_ << erase_line << stage_ << ": " << done;
  if (total != 0) out_ << '/' << total << " (" << done * 100 / total << " %)";
  out_ << ", " << duration_text(elapsed.count());
  if (done != 0 && done < total) {
    const auto remaining = elapsed.count() * static_cast<std::int64_t>(total - done) / static_cast<std::int64_t>(done);
    out_ << ", about " << duration_text(remaining) << " left";
  }
  out_ << std::flush;
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
