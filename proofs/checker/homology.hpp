#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "proofs/checker/point_set.hpp"

namespace delcert::checker {

using LabelSet = std::array<Label, 5>;  // the first labels count, increasing; the others are 0

/// The complex of all faces of m-simplices.
class FaceComplex {
 public:
  FaceComplex(int m, std::vector<LabelSet> simplices);

  /// Sum of (-1)^dimension over all faces.
  std::int64_t euler_characteristic() const;
  /// H_0 ... H_m with integer coefficients: "0", "Z^2", "Z + Z/2", "(Z/5)^3". Throws Undecided for a coefficient beyond
  /// 64 bits.
  std::vector<std::string> homology() const;

 private:
  int m_;
  std::size_t labels_ = 0;                    // all are less
  std::vector<std::vector<LabelSet>> faces_;  // by dimension, sorted
};

}  // namespace delcert::checker
