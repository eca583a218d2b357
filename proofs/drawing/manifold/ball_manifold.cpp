#include "proofs/drawing/manifold/ball_manifold.hpp"

#include <cmath>

#include "proofs/drawing/manifold/manifold_json.hpp"

namespace delcert {

BallManifold::BallManifold(const CertificateSummary& certificate)
    : LinearManifold(certificate), radius_(number_of(manifold_json(certificate).at("radius"))) {
  place_in_frame(certificate);
}

std::optional<ApproximateManifold::ChartPlace> BallManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                      std::uint32_t element) const {
  const std::array<double, 4> result = cartesian(motions_.apply(element, points_.at(j)));
  // Charts of a ball are balls of radius 9ε.
  const std::array<double, 4> centre = cartesian(points_.at(i));
  double square = 0;
  for (std::size_t axis = 0; axis < m_; ++axis) square += (result[axis] - centre[axis]) * (result[axis] - centre[axis]);
  return square < 81 * unit_ * unit_ ? std::optional(result) : std::nullopt;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> BallManifold::domain() {
  std::vector<std::pair<Place, Place>> result;
  constexpr int pieces = 64;
  for (std::size_t first = 0; first < m_; ++first) {
    for (std::size_t second = first + 1; second < m_; ++second) {
      const auto at = [&](int piece) {
        const double angle = 2 * std::acos(-1.0) * piece / pieces;
        Place place{1};
        place[first + 1] = radius_ * std::cos(angle);
        place[second + 1] = radius_ * std::sin(angle);
        return place;
      };
      for (int piece = 0; piece < pieces; ++piece) result.emplace_back(at(piece), at(piece + 1));
    }
  }
  return result;
}

}  // namespace delcert
