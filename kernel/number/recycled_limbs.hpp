#pragma once

namespace delcert {

/// While one of these lives, threads keep the short blocks that GMP and MPFR give back, and hand them out again: GMP
/// says how long a block is that it gives back, which the C library has to look up. Small rational numbers take a fifth
/// less time so. Values do not depend on it.
///
/// A block is of the length that was asked for, from the functions that were there before, and goes back to them when
/// its thread ends: one that is older than the guard, or younger than its end, is as good as any.
/// Precondition: no other thread uses GMP while a guard begins or ends; guards end in the opposite order.
class [[nodiscard]] RecycledLimbs {
 public:
  RecycledLimbs();
  ~RecycledLimbs();
  RecycledLimbs(const RecycledLimbs&) = delete;
  RecycledLimbs& operator=(const RecycledLimbs&) = delete;

  /// How many blocks this thread keeps.
  [[nodiscard]] static unsigned kept();
};

}  // namespace delcert
