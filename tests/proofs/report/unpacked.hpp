// What report/src/payload.js does, once more in C++: streams of a page as numbers.
#pragma once

#include <gtest/gtest.h>
#include <nettle/base64.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace delcert::test {

/// The bytes that a block was made of.
inline std::string unpacked(const std::string& block) {
  base64_decode_ctx context{};
  base64_decode_init(&context);
  std::string compressed(BASE64_DECODE_LENGTH(block.size()), '\0');
  std::size_t size = compressed.size();
  EXPECT_EQ(base64_decode_update(&context, &size, reinterpret_cast<std::uint8_t*>(compressed.data()), block.size(),
                                 block.data()),
            1);
  EXPECT_EQ(base64_decode_final(&context), 1);
  std::string bytes(std::size_t{1} << 24U, '\0');
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                       reinterpret_cast<const Bytef*>(compressed.data()), size),
            Z_OK);
  bytes.resize(length);
  return bytes;
}

inline std::string stream_of(const std::string& bytes, const nlohmann::ordered_json& entry) {
  return bytes.substr(entry.at("offset").get<std::size_t>(), entry.at("bytes").get<std::size_t>());
}

inline std::vector<std::uint32_t> from_planes(const std::string& stream, std::size_t width) {
  std::vector<std::uint32_t> result(stream.size() / width);
  for (std::size_t at = 0; at < stream.size(); ++at) {
    const auto byte = static_cast<std::uint32_t>(static_cast<unsigned char>(stream[at]));
    result[at % result.size()] |= byte << (8 * (at / result.size()));
  }
  return result;
}

inline std::vector<std::uint32_t> from_varints(const std::string& stream) {
  std::vector<std::uint32_t> result;
  std::uint32_t number = 0, shift = 0;
  for (const char letter : stream) {
    const auto byte = static_cast<unsigned char>(letter);
    number |= static_cast<std::uint32_t>(byte & 127U) << shift;
    shift += 7;
    if (byte < 128) {
      result.push_back(number);
      number = shift = 0;
    }
  }
  return result;
}

inline std::vector<double> from_codes(const std::string& stream, const nlohmann::ordered_json& entry) {
  const bool wide = entry.at("encoding") == "codes16";
  const double steps = wide ? 65534 : 254, low = entry.at("low").get<double>(), high = entry.at("high").get<double>();
  std::vector<double> result;
  for (const std::uint32_t code : from_planes(stream, wide ? 2 : 1)) {
    const double place = (code - 1.0) / steps;
    result.push_back(code == 0                       ? std::numeric_limits<double>::quiet_NaN()
                     : entry.at("scale") == "ratios" ? low * std::pow(high / low, place)
                                                     : low + (high - low) * place);
  }
  return result;
}

}  // namespace delcert::test
