#pragma once

#include <string>
#include <string_view>

namespace delcert::checker {

/// The bytes of the file. Throws std::invalid_argument if it cannot be read, or Malformed if it is larger than a
/// certificate can be.
std::string read_bytes(const std::string& path);

/// The bytes, decompressed if they begin with the magic number of zstd. Throws Malformed if the compressed data is not
/// exactly one frame or grows more than a certificate does.
std::string decompressed(std::string bytes);

/// The SHA-256 of the text as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace delcert::checker
