#pragma once

#include <array>

#include "proofs/drawing/figure/figure.hpp"

namespace delcert {

inline constexpr double figure_pixels = 720;      ///< the greater of width and height, without the scale
inline constexpr double figure_centimetres = 12;  ///< the same in print: 345 pt, a line of `article`, are 12.1 cm
inline constexpr double name_distance = 6;        ///< in pixels, of a name from its point

/// Where the things of a figure are on its page: in pixels, y downwards.
class FigurePage {
 public:
  explicit FigurePage(const Figure& figure);

  [[nodiscard]] double scale() const { return scale_; }  ///< pixels to a unit of the figure
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] Figure::Point place(const Figure::Point& point) const;
  /// The ends of a bar of this length, below all else. Precondition: the figure has a scale.
  [[nodiscard]] std::array<Figure::Point, 2> bar(double length) const;

 private:
  void include(const Figure::Point& point, double radius);

  Figure::Point lowest_{};
  Figure::Point highest_{};
  double scale_ = 1;
  double width_ = 0;
  double height_ = 0;
};

}  // namespace delcert
