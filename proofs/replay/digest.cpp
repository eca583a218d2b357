#include "proofs/replay/digest.hpp"

#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <array>

namespace delcert::replay {

std::string sha256_of(std::string_view text) {
  sha256_ctx hash;
  sha256_init(&hash);
  sha256_update(&hash, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
  sha256_digest(&hash, bytes.size(), bytes.data());
  std::string result(BASE16_ENCODE_LENGTH(SHA256_DIGEST_SIZE), '0');
  base16_encode_update(result.data(), bytes.size(), bytes.data());
  return result;
}

}  // namespace delcert::replay
