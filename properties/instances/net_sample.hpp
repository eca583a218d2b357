#pragma once

#include <cstdint>
#include <vector>

#include "properties/instances/choices.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

template <int m>
using NetPoints = std::vector<Vector<Rational, m>>;

/// How a net of an instance is made.
enum class NetFamily : unsigned char {
  poisson,   ///< a maximal Poisson-disk set
  lattice,   ///< square, hexagonal up to 2⁻¹⁰, oblong; cubic, body- and face-centred cubic, oblong
  displaced  ///< a lattice, every coordinate moved by ±2^−k, in space by at most that
};

/// A net as it was made, before anything is certified.
template <int m>
struct NetSample {
  std::vector<Vector<Rational, m>> points;  ///< the first is the origin
  Rational radius;                          ///< about the covering radius
  NetFamily family = NetFamily::poisson;
};

/// A net of a ball of `factor` times its covering radius about the origin, with points to twice that radius beyond it.
/// Its covering radius is between 1/4 and 2, its coordinates have few digits. May have a few points very close to
/// others (as close as 2⁻¹² of the radius): nets that are sparse and not well separated.
template <int m>
[[nodiscard]] NetSample<m> draw_net(long factor, Choices& choices);

/// A lattice whose first point has cells that are nearly degenerate: in the plane nearly a rectangle, sheared by some
/// 2⁻¹ to 2⁻¹², in space nearly a box. There the stars depend on the metric most.
template <int m>
[[nodiscard]] NetSample<m> draw_nearly_degenerate_net(long factor, Choices& choices);

/// How points of a net are perturbed.
enum class NetMotion : unsigned char {
  random,   ///< uniformly in the ball
  none,     ///< not at all
  axis,     ///< by the whole length along a coordinate axis, this way or that
  outward,  ///< by nearly the whole length away from a centre
};

/// The points perturbed by at most `length`, on a grid of 2⁻³⁰ except for whole lengths. `centre` is for `outward`: the
/// points within `reach` of it move away from it, the others stay.
template <int m>
[[nodiscard]] std::vector<Vector<Rational, m>> moved_points(const std::vector<Vector<Rational, m>>& points,
                                                            const Rational& length, NetMotion motion,
                                                            const Vector<Rational, m>& centre, const Rational& reach,
                                                            std::uint64_t seed);

/// The squared least distance of two points. Precondition: there are two.
template <int m>
[[nodiscard]] Rational squared_separation(const std::vector<Vector<Rational, m>>& points);

/// The centre of the sphere through the points with these numbers, m + 1 of which are independent.
template <int m>
[[nodiscard]] Vector<Rational, m> centre_of(const std::vector<Vector<Rational, m>>& points,
                                            const std::vector<std::uint32_t>& cell);

}  // namespace delcert
