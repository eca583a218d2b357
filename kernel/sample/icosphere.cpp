#include "kernel/sample/icosphere.hpp"

#include <array>
#include <cmath>
#include <string>

#include "kernel/chart/model_space.hpp"
#include "kernel/chart/net_grid.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Direction = std::array<double, 3>;

/// Corners: (0, ±1, ±φ), (±1, ±φ, 0), (±φ, 0, ±1).
std::array<Direction, 12> icosahedron_vertices() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const double length = std::sqrt(1 + golden * golden);
  std::array<Direction, 12> result{};
  std::size_t at = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double one : {-1.0, 1.0}) {
      for (const double other : {-golden, golden}) {
        result[at][axis] = one / length;
        result[at][(axis + 1) % 3] = other / length;
        ++at;
      }
    }
  }
  return result;
}

/// sin(k·θ/f) for k = 0 … f, θ the arc of an edge: cos θ = 1/√5.
std::vector<double> sines(std::uint32_t frequency) {
  const RoundingGuard guard;
  const Interval chord = Interval(2) - Interval(2) / square_root(Interval(5));
  const Interval arc = distance_of_chord(Curvature::positive, chord);
  std::vector<double> result;
  for (std::uint32_t k = 0; k <= frequency; ++k) {
    const Interval part = arc * Interval(static_cast<int>(k)) / Interval(static_cast<int>(frequency));
    // An end, not the middle: no sum of doubles under the guard.
    result.push_back((part * sine_ratio(Curvature::positive, square(part))).lower());
  }
  return result;
}

Direction normalised(const Direction& x) { return scaled(1 / std::sqrt(pairing(x, x)), x); }

Vector<double, 2> turned_coordinates(const Direction& x) {
  const Vector<PlainDouble, 2> turn{PlainDouble::exactly(0x1.3a7p-2), PlainDouble::exactly(0x1.59dp-3)};
  const auto rotation = model_frame<PlainDouble, 2>(Curvature::positive, turn);
  ModelPoint<PlainDouble, 2> point;
  for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = PlainDouble::exactly(x[axis]);
  const auto conformal = conformal_coordinates<PlainDouble, 2>(applied(rotation, point));
  Vector<double, 2> result;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    result[axis] = on_net_grid(conformal[axis].lower());
  }
  return result;
}

/// The points of a net of the icosahedron, each once: corners, then edges, then faces.
class Division {
 public:
  explicit Division(std::uint32_t frequency) : frequency_(frequency), sines_(sines(frequency)) {
    const auto corner = icosahedron_vertices();
    for (const Direction& x : corner) add({x, x, x}, frequency, 0);
    const auto adjacent = [&](std::size_t a, std::size_t b) { return pairing(corner[a], corner[b]) > 0.4; };
    for (std::size_t a = 0; a < 12; ++a) {
      for (std::size_t b = a + 1; b < 12; ++b) {
        if (!adjacent(a, b)) continue;
        for (std::uint32_t k = 1; k < frequency; ++k) add({corner[a], corner[b], corner[b]}, k, frequency - k);
        for (std::size_t c = b + 1; c < 12; ++c) {
          if (adjacent(a, c) && adjacent(b, c)) add_face({corner[a], corner[b], corner[c]});
        }
      }
    }
  }

  [[nodiscard]] const std::vector<Vector<double, 2>>& points() const { return points_; }

 private:
  void add_face(const std::array<Direction, 3>& face) {
    for (std::uint32_t first = 1; first + 1 < frequency_; ++first) {
      for (std::uint32_t second = 1; first + second < frequency_; ++second) add(face, first, second);
    }
  }

  /// The point with the weights first : second : rest on the arcs.
  void add(const std::array<Direction, 3>& face, std::uint32_t first, std::uint32_t second) {
    const std::array<double, 3> weights{sines_[first], sines_[second], sines_[frequency_ - first - second]};
    Direction x{};
    for (std::size_t corner = 0; corner < 3; ++corner) x = sum(x, scaled(weights[corner], face[corner]));
    points_.push_back(turned_coordinates(normalised(x)));
  }

  std::uint32_t frequency_;
  std::vector<double> sines_;
  std::vector<Vector<double, 2>> points_;
};

}  // namespace

std::vector<Vector<Rational, 2>> icosphere(std::uint32_t frequency) {
  constexpr std::uint32_t most = 600;
  if (frequency < 1 || frequency > most)
    throw InputError("the frequency of an icosphere is " + std::to_string(frequency) + ", expected 1 to " +
                     std::to_string(most));
  const Division division(frequency);
  std::vector<Vector<Rational, 2>> result;
  for (const std::uint32_t number : spatial_order_of_lifts<2>(Curvature::positive, division.points())) {
    const auto& point = division.points()[number];
    result.push_back({Rational::exactly(point[0]), Rational::exactly(point[1])});
  }
  return result;
}

}  // namespace delcert
