#pragma once

#include <optional>

#include "kernel/number/strong.hpp"
#include "proofs/constants/power_product.hpp"

namespace delcert {

/// How many points a sampling radius means on the unit sphere of dimension m.
struct SphereSampleSize {
  /// Any set of points with this sampling radius has at least as many: they are the centres of geodesic balls that
  /// cover the sphere, and such a ball has at most the volume of a Euclidean ball of the same radius. Bounds of this
  /// proved number.
  Bounds at_least;
  /// The same number exactly: this product, times π for odd m.
  PowerProduct at_least_without_pi;
  bool has_factor_pi = false;
  /// Where its binary logarithm lies.
  Bounds at_least_log2;
  /// About as many as a maximal Poisson-disk net has: 0.697 area/ε² for m = 2, 0.743 volume/ε³ for m = 3. Both
  /// factors were measured on such nets; nothing is proved about them. Empty in other dimensions.
  std::optional<Bounds> measured_estimate;
};

/// Precondition: dimension >= 1.
[[nodiscard]] SphereSampleSize sphere_sample_size(Dimension dimension, const PowerProduct& sampling_radius);

}  // namespace delcert
