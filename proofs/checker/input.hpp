#pragma once

#include <string>
#include <string_view>

namespace delcert::checker {

/// The bytes of the file, decompressed if they begin with the magic number of zstd. Throws std::invalid_argument if it
/// cannot be read, or Malformed if the compressed data is not exactly one frame or grows more than a certificate can.
std::string read_document(const std::string& path);

/// What read_document does after reading the bytes.
std::string decompressed(std::string bytes);

/// The SHA-256 of the text as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace delcert::checker
