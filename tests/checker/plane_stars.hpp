#pragma once

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/checker/support/certificate_text.hpp"

// What oracles of curves and surfaces look at in charts, in doubles: falsehoods count above a relative 10⁻⁹.
namespace delcert::checker_tests::plane {

constexpr double slack = 1e-9;
constexpr double two_pi = 6.283185307179586;

using Flat = std::array<double, 2>;  // chart coordinates; on a curve the second is 0
inline double size(const Flat& a) { return std::hypot(a[0], a[1]); }
inline Flat minus(const Flat& a, const Flat& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline double turned(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }

using Place = std::array<double, 3>;
inline Place operator+(const Place& a, const Place& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Place operator-(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Place operator*(double t, const Place& a) { return {t * a[0], t * a[1], t * a[2]}; }
inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Place& a) { return std::sqrt(dot(a, a)); }
inline Place unit(const Place& a) { return (1 / length(a)) * a; }
/// The solid angle of the triangle on the unit sphere with these corners, above 0 in one order and below 0 in the
/// other.
inline double solid_angle(const Place& a, const Place& b, const Place& c) {
  return 2 * std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

using Simplex = std::vector<std::size_t>;

struct Circle {
  Flat centre{};
  double radius = 0;
};
Circle circle_through(const std::vector<Flat>& x);
double longest_side(const std::vector<Flat>& x);
double least_altitude(const std::vector<Flat>& x);

/// Chart of a label, and what it shows.
struct View {
  Flat home{};       // where its own label is
  double patch = 0;  // its radius
  std::map<std::size_t, Flat> shown;
};

/// The stars of a curve or a surface in the charts of its labels.
class Stars {
 public:
  /// The simplices are kept by reference.
  Stars(std::size_t m, const std::vector<Simplex>& simplices, std::size_t labels);

  std::vector<View> views;  // one for each label

  [[nodiscard]] const std::vector<const Simplex*>& star(std::size_t i) const { return stars_[i]; }
  /// The corners in chart i; none if it does not show all of them.
  [[nodiscard]] std::optional<std::vector<Flat>> corners(std::size_t i, const Simplex& simplex) const;

  // What a level claims that is false; nothing if nothing is found. `moved`: how far points may have been moved.
  [[nodiscard]] std::string fault_of_level_1(const Json& level, double moved) const;
  [[nodiscard]] std::string fault_of_level_2(const Json& level) const;
  [[nodiscard]] std::string fault_of_level_2s(const Json& level) const;

 private:
  [[nodiscard]] bool is_disturbed(std::size_t i, const Simplex& simplex, const Circle& ball, double protection,
                                  double reach) const;
  [[nodiscard]] static double angle_at(std::size_t i, const Simplex& simplex, const std::vector<Flat>& x);

  std::size_t m_;
  const std::vector<Simplex>& simplices_;
  std::vector<std::vector<const Simplex*>> stars_;
};

}  // namespace delcert::checker_tests::plane
