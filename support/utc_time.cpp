#include "support/utc_time.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "support/error.hpp"

namespace delcert {

std::string utc_text(std::chrono::system_clock::time_point time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  const auto day = std::chrono::floor<std::chrono::days>(seconds);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(seconds - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                     clock.minutes().count(), clock.seconds().count());
}

std::chrono::sys_seconds parse_utc(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hours = 0;
  int minutes = 0;
  int seconds = 0;
  const int read =
      std::sscanf(text.c_str(), "%4d-%2u-%2uT%2d:%2d:%2dZ", &year, &month, &day, &hours, &minutes, &seconds);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (read == 6 && date.ok()) {
    const std::chrono::sys_seconds result = std::chrono::sys_days(date) + std::chrono::hours(hours) +
                                            std::chrono::minutes(minutes) + std::chrono::seconds(seconds);
    // What is out of its range, and what is written otherwise, comes back as another text.
    if (utc_text(result) == text) return result;
  }
  throw InputError("\"" + text + "\" is no time such as 2026-05-31T23:59:07Z");
}

}  // namespace delcert
