#pragma once

#include <cstdint>
#include <vector>

#include "kernel/number/filter.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// Enclosed points of ℝᵐ, to be found by boxes: most points of a patch are far from most balls in it.
template <int m>
class BoxIndex {
 public:
  /// Replaces the points; they are known by their positions in the list. Precondition: a `FilterGuard` is alive.
  void fill(const std::vector<Vector<Filter, m>>& points);

  /// Replaces `out` by all points whose enclosures meet the closed box, none missing, in the order of their first
  /// coordinates. Bounds may be infinite. Precondition: a `FilterGuard` is alive.
  void meeting(const Vector<double, m>& lowest, const Vector<double, m>& highest,
               std::vector<std::uint32_t>& out) const;

 private:
  struct Entry {
    Vector<double, m> lower;
    Vector<double, m> upper;
    std::uint32_t point;
  };

  std::vector<Entry> entries_;  // by their first lower ends
  double widest_ = 0;           // no enclosure is wider along the first axis
};

}  // namespace delcert
