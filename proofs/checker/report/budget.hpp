#pragma once

#include <cstdint>

#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// How much work a check may take: what it does many times costs units, of some ten nanoseconds. A document that asks
/// for more than any honest one of its size ends undecided, and not in hours. Without a budget any work may be done.
class Budget {
 public:
  static constexpr std::uint64_t for_all = 200'000'000, for_each_point = 1'000'000;

  static void open(std::uint64_t points) { left_ = for_all + for_each_point * points; }
  /// Throws Undecided if so much is not left.
  static void spend(std::uint64_t units) {
    if (units > left_) throw Undecided("the check takes more work than a certificate of this size should");
    left_ -= units;
  }
  static std::uint64_t left() { return left_; }
  /// As it was when so much was left.
  static void restore(std::uint64_t left) { left_ = left; }

 private:
  static inline std::uint64_t left_ = ~std::uint64_t{0};
};

}  // namespace delcert::checker
