#include "proofs/certificate/sha256.hpp"

#include <nettle/sha2.h>

#include <array>

namespace delcert {

struct Sha256::State {
  sha256_ctx hash{};
};

Sha256::Sha256() : state_(std::make_unique<State>()) { sha256_init(&state_->hash); }
Sha256::~Sha256() = default;

void Sha256::update(std::string_view bytes) {
  sha256_update(&state_->hash, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

std::string Sha256::digest() const {
  sha256_ctx copy = state_->hash;
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
  sha256_digest(&copy, bytes.size(), bytes.data());
  std::string result;
  for (const std::uint8_t byte : bytes) {
    result += "0123456789abcdef"[byte >> 4U];
    result += "0123456789abcdef"[byte & 15U];
  }
  return result;
}

}  // namespace delcert
