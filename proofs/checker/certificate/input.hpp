#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace delcert::checker {

/// A file that cannot be opened or read.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of the file. Throws Unreadable if it cannot be read, or Malformed if it is larger than a
/// certificate can be.
std::string read_bytes(const std::string& path);

/// The bytes, decompressed if they begin with the magic number of zstd. Throws Malformed if the compressed data is not
/// exactly one frame or grows more than a certificate does.
std::string decompressed(std::string bytes);

/// The SHA-256 of the text as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view text);

/// The SHA-256 of the first so many bytes of a text.
struct DigestOfBeginning {
  std::size_t length = 0;
  std::string digest;
};
using KnownDigest = std::function<DigestOfBeginning()>;
/// The same, and that of the whole, which is read once. Precondition: it has so many bytes.
std::string sha256(std::string_view text, std::size_t length, DigestOfBeginning& beginning);

}  // namespace delcert::checker
