#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>

#include "proofs/checker/input.hpp"
#include "proofs/checker/run.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

int status_of(std::string bytes) {
  try {
    return checker::check(checker::decompressed(std::move(bytes)), {}).status;
  } catch (const checker::Malformed&) {
    return 3;
  }
}

/// One to four changes: a byte replaced, a bit flipped, a byte inserted, a stretch erased or copied to another place.
std::string mutated(std::string bytes, std::mt19937_64& random) {
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

void mutate(const std::string& name, const std::string& bytes, int times, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<int, int> count;
  int unchanged = 0;
  for (int k = 0; k < times; ++k) {
    const std::string other = mutated(bytes, random);
    const int status = status_of(other);
    if (other == bytes) {
      ++unchanged;
      EXPECT_EQ(status, 0);
    } else {
      ++count[status];
      EXPECT_NE(status, 0) << "accepted: " << other;
    }
  }
  std::cout << times << " mutations of " << name << ": " << unchanged << " unchanged";
  for (const auto& [status, number] : count) std::cout << ", " << number << " with status " << status;
  std::cout << "\n";
}

class Mutations : public testing::Test {
 protected:
  const test::Upwards upwards;
  std::string text_ = sealed(circle().document());
};

TEST_F(Mutations, of_ten_thousand_random_ones_none_verifies) {
  ASSERT_EQ(status_of(text_), 0);
  mutate("a certificate", text_, 10000, 1);
}

TEST_F(Mutations, of_compressed_bytes_never_verify) {
  mutate("a compressed certificate", zstd_compressed(text_), 2000, 2);
}

TEST_F(Mutations, sealed_anew_never_crash) {
  std::mt19937_64 random(3);
  std::map<int, int> count;
  for (int k = 0; k < 5000; ++k) {
    std::string other = mutated(text_, random);
    if (other.find(",\"sha256\":\"") != std::string::npos) other = resealed(other);
    ++count[status_of(other)];
  }
  std::cout << "5000 mutations sealed anew:";
  for (const auto& [status, number] : count) std::cout << " " << number << " with status " << status;
  std::cout << "\n";
  EXPECT_GT(count[3], 0);
  EXPECT_GT(count[1], 0);
}

/// In the manifold block, the parameters and the levels, and the first points.
TEST_F(Mutations, of_the_head_of_a_space_form_sealed_anew_never_crash) {
  std::mt19937_64 random(4);
  std::map<int, int> count;
  for (const SpaceFormSample* sample : {&projective_space(), &klein_bottle()}) {
    const std::string text = sealed(sample->document());
    const std::size_t head = text.find("\"net\":") + 200;
    ASSERT_EQ(status_of(text), 0);
    for (int k = 0; k < 400; ++k)
      ++count[status_of(resealed(mutated(text.substr(0, head), random) + text.substr(head)))];
  }
  std::cout << "800 mutations of space forms sealed anew:";
  for (const auto& [status, number] : count) std::cout << " " << number << " with status " << status;
  std::cout << "\n";
  EXPECT_GT(count[3], 0);
  EXPECT_GT(count[1], 0);
}

}  // namespace
}  // namespace delcert::checker_tests
