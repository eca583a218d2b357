#include "support/duration.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::int64_t minute = 60;
constexpr std::int64_t hour = 60 * minute;
constexpr std::int64_t day = 24 * hour;
constexpr std::int64_t longest = 366 * day;
constexpr std::array<std::pair<std::string_view, std::int64_t>, 4> units{
    {{"s", 1}, {"min", minute}, {"h", hour}, {"d", day}}};

}  // namespace

std::chrono::seconds parse_duration(const std::string& text) {
  std::int64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const auto& [unit, seconds] : units) {
    if (error == std::errc{} && rest == unit && count > 0 && count <= longest / seconds) {
      return std::chrono::seconds(count * seconds);
    }
  }
  throw InputError(text + ": a time was expected, such as 90s, 45min, 8h or 2d, at most 366d");
}

std::string duration_text(std::chrono::milliseconds duration) {
  const std::int64_t seconds = (duration.count() + 999) / 1000;
  if (seconds < 2 * minute) return std::to_string(seconds) + " s";
  if (seconds < 2 * hour) return std::to_string(seconds / minute) + " min";
  return std::to_string(seconds / hour) + " h " + std::to_string(seconds / minute % minute) + " min";
}

}  // namespace delcert
