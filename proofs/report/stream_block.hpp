#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace delcert {

/// Numbers for a page that is read by a browser: streams of bytes, one after the other, compressed together (zlib) and
/// written as base64. Each `add_…` returns where the stream is and how it is to be read, as report/src/payload.js reads
/// it: {"encoding":…,"offset":bytes,"bytes":count} and what the encoding needs.
class StreamBlock {
 public:
  /// Rounded to the nearest float. Encoding "floats": byte 0 of all numbers, then byte 1 of all, and so on.
  nlohmann::ordered_json add_floats(const std::vector<double>& numbers);
  /// Encoding "varints": seven bits a byte, the lowest first, the highest bit set in all bytes but the last.
  nlohmann::ordered_json add_varints(const std::vector<std::uint32_t>& numbers);
  /// NaN is "not measured". Encoding "codes16" or "codes8": code 0 for NaN, the others from `low` to `high`, in equal
  /// "ratios" where all numbers are above 0, else in equal "differences": the error is at most half a step.
  /// Precondition: `bytes` is 1 or 2; no number is infinite.
  nlohmann::ordered_json add_codes(const std::vector<double>& numbers, std::size_t bytes);
  /// Texts without line feeds. Encoding "lines".
  nlohmann::ordered_json add_lines(const std::vector<std::string>& lines);

  /// All streams. Throws std::runtime_error if zlib fails.
  [[nodiscard]] std::string base64() const;

 private:
  nlohmann::ordered_json add(const char* encoding, std::string_view bytes);

  std::string bytes_;
};

/// Rows of one width, in lexicographic order, by columns: each number as its difference to the one above where the row
/// begins like the one above, else to the one on its left, and in the first column to the one above.
/// Precondition: rows are increasing from left to right and sorted.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> columns_of_sorted_rows(
    const std::vector<std::vector<std::uint32_t>>& rows);

}  // namespace delcert
