#include <gtest/gtest.h>

#include <optional>

#include "tests/checker/circle_oracle.hpp"
#include "tests/checker/mutation.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"
#include "tests/checker/weaker_claims.hpp"

namespace delcert::checker_tests {
namespace {

/// What the bytes say; nothing where they are malformed. A compressed file has bits on which its content does not
/// depend.
std::optional<std::string> content_of(std::string bytes) {
  try {
    return checker::decompressed(std::move(bytes));
  } catch (const checker::Malformed&) {
    return std::nullopt;
  }
}

void mutate(const std::string& name, const std::string& bytes, int times, std::uint64_t seed) {
  const std::optional<std::string> content = content_of(bytes);
  std::mt19937_64 random(seed);
  std::map<int, int> count;
  int unchanged = 0;
  for (int k = 0; k < times; ++k) {
    const std::string other = mutated(bytes, random);
    const int status = status_of(other);
    if (content_of(other) == content) {
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

/// What is accepted is decided by an oracle that shares nothing with the checker.
TEST_F(Mutations, sealed_anew_are_accepted_only_if_they_are_true) {
  ASSERT_EQ(fault_of_circle(text_), "");
  std::mt19937_64 random(3);
  std::map<int, int> count;
  for (int k = 0; k < 10000; ++k) {
    std::string other = mutated(text_, random);
    if (other.find(",\"sha256\":\"") != std::string::npos) other = resealed(other);
    const int status = soon_status_of(other);
    ++count[status];
    if (status == 0) {
      EXPECT_EQ(fault_of_circle(other), "") << other;
    }
  }
  print_count("10000 mutations", count);
  for (const int status : {0, 1, 3}) EXPECT_GT(count[status], 0) << status;
}

/// Digits of margins and points alone, so that documents stay well-formed.
TEST_F(Mutations, of_digits_sealed_anew_are_accepted_only_if_they_are_true) {
  std::mt19937_64 random(5);
  std::map<int, int> count;
  for (int k = 0; k < 10000; ++k) {
    std::string other = with_other_digits(text_, random);
    other = resealed(other);
    const int status = soon_status_of(other);
    ++count[status];
    if (status == 0) {
      EXPECT_EQ(fault_of_circle(other), "") << other;
    }
  }
  print_count("10000 mutations of digits", count);
  for (const int status : {0, 1, 3}) EXPECT_GT(count[status], 0) << status;
}

/// The oracle is no yes-man: what the checker rejects it finds false itself. The net simplices are left as they are:
/// they are a witness of density, which the oracle decides without one.
TEST_F(Mutations, that_the_checker_rejects_the_oracle_finds_false) {
  std::mt19937_64 random(6);
  const std::size_t witness = text_.find("\"net_simplices\""), end = text_.find("\"points\"");
  int rejected = 0;
  for (int k = 0; k < 5000; ++k) {
    std::string other = text_;
    const std::size_t place = random() % other.size();
    if (other[place] < '0' || other[place] > '9' || (witness < place && place < end)) continue;
    other[place] = static_cast<char>('0' + random() % 10);
    other = resealed(other);
    if (status_of(other) != 1) continue;
    ++rejected;
    EXPECT_NE(fault_of_circle(other), "") << other;
  }
  std::cout << rejected << " rejected, as by the oracle\n";
  EXPECT_GT(rejected, 100);
}

/// In the manifold block, the parameters and the levels, and the first points.
TEST_F(Mutations, of_the_head_of_a_space_form_sealed_anew_are_accepted_only_if_they_claim_less) {
  std::mt19937_64 random(4);
  std::map<int, int> count;
  for (const SpaceFormSample* sample : {&projective_space(), &klein_bottle()}) {
    const std::string text = sealed(sample->document());
    const std::size_t head = text.find("\"net\":") + 200;
    ASSERT_EQ(status_of(text), 0);
    for (int k = 0; k < 400; ++k) {
      const std::string other = resealed(mutated(text.substr(0, head), random) + text.substr(head));
      const int status = soon_status_of(other);
      ++count[status];
      if (status == 0) {
        EXPECT_EQ(stronger_claims(text, other), "") << other.substr(0, head);
      }
    }
  }
  print_count("800 mutations of space forms", count);
  EXPECT_GT(count[3], 0);
  EXPECT_GT(count[1], 0);
}

}  // namespace
}  // namespace delcert::checker_tests
