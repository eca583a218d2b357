#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace delcert {

/// A figure in the plane, in doubles, for the eye: what is later lies above, and circles, dots and names above paths.
struct Figure {
  using Point = std::array<double, 2>;
  using Colour = std::array<int, 3>;  ///< red, green, blue, 0 to 255

  /// Lines through points, each closed if `is_closed`; the stroke's width is in pixels of a figure 720 wide.
  struct Path {
    std::vector<std::vector<Point>> lines;
    bool is_closed = true;
    std::optional<Colour> fill;
    Colour stroke{28, 49, 68};
    double width = 0.8;
    bool is_dashed = false;
  };
  struct Circle {
    Point centre;
    double radius;
    Colour stroke;
    double width = 1.5;
  };
  /// A filled disk whose radius is in pixels.
  struct Dot {
    Point centre;
    double radius;
    Colour fill;
  };
  /// Plain text, above and to the right of a point.
  struct Name {
    Point at;
    std::string text;
    Colour ink;
  };
  /// A length, drawn below all else.
  struct Scale {
    double length;
    std::string text;
  };

  std::vector<Path> paths;
  std::vector<Circle> circles;
  std::vector<Dot> dots;
  std::vector<Name> names;
  std::optional<Scale> scale;
  std::string description;  ///< plain text: for readers who do not see it, and comments
};

/// As SVG, 720 pixels wide or high.
[[nodiscard]] std::string svg_of(const Figure& figure);

/// As a tikzpicture (package tikz), 12 cm wide or high: 345 pt are 12.1 cm.
[[nodiscard]] std::string tikz_of(const Figure& figure);

/// 1, 2 or 5 times a power of ten: the greatest that is not above x, as a number and as text. Precondition: x > 0,
/// finite.
[[nodiscard]] Figure::Scale round_scale(double x);

}  // namespace delcert
