#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/submanifold/embedded_manifold.hpp"
#include "kernel/number/rational.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The radii of a net of a submanifold, as options of `delcert certify` have them.
struct RadiusAdvice {
  Rational radius;     ///< the greatest one
  std::string sizing;  ///< "curvature:k,ν"; empty: the same radius everywhere
  double points = 0;   ///< about how many there will be

  /// "--radius 2/65 --refine 8 should do, with some 6200 points".
  [[nodiscard]] std::string text() const;
};

/// What should do where these radii were too large: a heuristic, for messages. The radius is a part of the reach as
/// `survey_manifold` finds it, made less until charts fit at the points that look worst; where that takes many points,
/// and far fewer if radii follow the curvature, these are advised. `places`: where the radii failed. None if nothing is
/// known, as of meshes, or nothing is left to be advised. Precondition: rounding to nearest.
[[nodiscard]] std::optional<RadiusAdvice> advise_radius(const EmbeddedManifold& manifold, const Rational& radius,
                                                        const std::string& sizing,
                                                        const std::vector<std::vector<double>>& places,
                                                        std::uint64_t seed, const Progress& progress);

}  // namespace delcert
