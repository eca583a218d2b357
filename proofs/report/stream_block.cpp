#include "proofs/report/stream_block.hpp"

#include <nettle/base64.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

/// Byte 0 of all numbers, then byte 1 of all: bytes of one meaning side by side, which compresses better.
template <class Unsigned>
std::string planes(const std::vector<Unsigned>& numbers) {
  std::string result;
  result.reserve(sizeof(Unsigned) * numbers.size());
  for (std::size_t plane = 0; plane < sizeof(Unsigned); ++plane)
    for (const Unsigned number : numbers) result.push_back(static_cast<char>((number >> (8 * plane)) & 255U));
  return result;
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range range_of(const std::vector<double>& numbers) {
  Range range;
  for (const double number : numbers) {
    if (std::isnan(number)) continue;
    range.low = std::min(range.low, number);
    range.high = std::max(range.high, number);
  }
  return range.low <= range.high ? range : Range{1, 1};
}

/// 0 for NaN, 1 for low, `most` for high.
std::uint32_t code_of(double number, const Range& range, bool by_ratios, std::uint32_t most) {
  if (std::isnan(number)) return 0;
  if (range.low == range.high) return 1;
  const double place = by_ratios ? std::log(number / range.low) / std::log(range.high / range.low)
                                 : (number - range.low) / (range.high - range.low);
  return 1 + static_cast<std::uint32_t>(std::lround(std::clamp(place, 0.0, 1.0) * (most - 1)));
}

}  // namespace

Json StreamBlock::add(const char* encoding, std::string_view bytes) {
  Json entry{{"encoding", encoding}, {"offset", bytes_.size()}, {"bytes", bytes.size()}};
  bytes_ += bytes;
  return entry;
}

Json StreamBlock::add_floats(const std::vector<double>& numbers) {
  std::vector<std::uint32_t> bits;
  bits.reserve(numbers.size());
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(number)));
  return add("floats", planes(bits));
}

Json StreamBlock::add_varints(const std::vector<std::uint32_t>& numbers) {
  std::string bytes;
  for (std::uint32_t number : numbers) {
    for (; number >= 128; number >>= 7U) bytes.push_back(static_cast<char>(number | 128U));
    bytes.push_back(static_cast<char>(number));
  }
  return add("varints", bytes);
}

Json StreamBlock::add_codes(const std::vector<double>& numbers, std::size_t bytes) {
  const Range range = range_of(numbers);
  const bool by_ratios = range.low > 0;
  std::vector<std::uint16_t> codes;
  codes.reserve(numbers.size());
  for (const double number : numbers)
    codes.push_back(static_cast<std::uint16_t>(code_of(number, range, by_ratios, bytes == 1 ? 255 : 65535)));
  Json entry = bytes == 1 ? add("codes8", std::string(codes.begin(), codes.end())) : add("codes16", planes(codes));
  entry["low"] = range.low;
  entry["high"] = range.high;
  entry["scale"] = by_ratios ? "ratios" : "differences";
  return entry;
}

Json StreamBlock::add_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (&line == lines.data() ? "" : "\n") + line;
  return add("lines", text);
}

std::string StreamBlock::base64() const {
  uLongf size = compressBound(bytes_.size());
  std::string compressed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(bytes_.data()),
                bytes_.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot compress the data of the page");
  std::string result(BASE64_ENCODE_RAW_LENGTH(size), '\0');
  base64_encode_raw(result.data(), size, reinterpret_cast<const std::uint8_t*>(compressed.data()));
  return result;
}

std::vector<std::vector<std::uint32_t>> columns_of_sorted_rows(const std::vector<std::vector<std::uint32_t>>& rows) {
  std::vector<std::vector<std::uint32_t>> columns(rows.empty() ? 0 : rows.front().size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    bool same = row > 0;
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const std::uint32_t before = same ? rows[row - 1][column] : column > 0 ? rows[row][column - 1] : 0;
      columns[column].push_back(rows[row][column] - before);
      same = same && columns[column].back() == 0;
    }
  }
  return columns;
}

}  // namespace delcert
