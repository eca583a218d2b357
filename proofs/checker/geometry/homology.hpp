#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "proofs/checker/geometry/point_set.hpp"

namespace delcert::checker {

using LabelSet = std::array<Label, 5>;  // the first labels count, increasing; the others are 0

/// Of all faces of m-simplices, each with its m + 1 labels in increasing order, those whose least label is in a range:
/// how many m-simplices, and the sum of (-1)^dimension. Ranges add up.
struct FaceCount {
  std::int64_t simplices = 0, euler_characteristic = 0;
};
FaceCount count_faces(std::size_t m, const std::vector<Label>& labels, Label begin, Label end);

/// The complex of all faces of m-simplices.
class FaceComplex {
 public:
  FaceComplex(int m, std::vector<LabelSet> simplices);

  /// H_0 ... H_m with integer coefficients: "0", "Z^2", "Z + Z/2", "(Z/5)^3". Throws Undecided for a coefficient beyond
  /// 64 bits.
  std::vector<std::string> homology() const;

 private:
  std::size_t m_;
  std::vector<std::size_t> size_;                     // how many faces, by dimension
  std::vector<std::vector<std::uint32_t>> boundary_;  // by dimension k: for each face, its facets without label 0 ... k
};

}  // namespace delcert::checker
