#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <random>
#include <string>

#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/run.hpp"
#include "tests/checker/support/certificate_text.hpp"

// Certificates that are changed at random, and what the checker says of them.
namespace delcert::checker_tests {

inline int status_of(std::string bytes) {
  try {
    return checker::check(checker::decompressed(std::move(bytes)), {}).status;
  } catch (const checker::Malformed&) {
    return 3;
  }
}

/// One to four changes: a byte replaced, a bit flipped, a byte inserted, a stretch erased or copied to another place.
inline std::string mutated(std::string bytes, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t place = below(bytes.size()), length = 1 + below(std::min<std::size_t>(20, bytes.size() - place));
    switch (below(5)) {
      case 0:
        bytes[place] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
        break;
      case 2:
        bytes.insert(place, 1, "0123456789,[]{}\"-/xp.ab"[below(23)]);
        break;
      case 3:
        bytes.erase(place, length);
        break;
      default:
        bytes.insert(below(bytes.size()), bytes.substr(place, length));
    }
    if (bytes.empty()) bytes = "{";
  }
  return bytes;
}

/// One or two digits are others, so that documents stay well-formed.
inline std::string with_other_digits(std::string bytes, std::mt19937_64& random) {
  for (std::size_t changes = 1 + random() % 2; changes > 0;) {
    char& c = bytes[random() % bytes.size()];
    if (c < '0' || c > '9') continue;
    c = static_cast<char>('0' + random() % 10);
    --changes;
  }
  return bytes;
}

inline std::string resealed_if_sealed(const std::string& bytes) {
  return bytes.find(",\"sha256\":\"") == std::string::npos ? bytes : resealed(bytes);
}

/// The status, which is known soon: in seconds of one processor.
inline int soon_status_of(const std::string& text, double most_seconds = 10) {
  const std::clock_t begin = std::clock();
  const int status = status_of(text);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, most_seconds) << text;
  return status;
}

inline void print_count(const std::string& name, const std::map<int, int>& count) {
  std::cout << name << " sealed anew:";
  for (const auto& [status, number] : count) std::cout << " " << number << " with status " << status;
  std::cout << "\n";
}

/// So many, or as many as DELCERT_MUTATIONS says.
inline int number_of_mutations(int few) {
  const char* many = std::getenv("DELCERT_MUTATIONS");
  return many == nullptr ? few : std::atoi(many);
}

}  // namespace delcert::checker_tests
