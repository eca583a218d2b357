#include "proofs/drawing/figure/figure_page.hpp"

#include <algorithm>
#include <limits>

namespace delcert {

namespace {

constexpr double figure_margin = 12;
constexpr double scale_band = 44;  ///< the bar and its text

}  // namespace

FigurePage::FigurePage(const Figure& figure) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  lowest_ = {infinity, infinity};
  highest_ = {-infinity, -infinity};
  for (const Figure::Path& path : figure.paths) {
    for (const auto& line : path.lines) {
      for (const Figure::Point& point : line) include(point, 0);
    }
  }
  for (const Figure::Circle& circle : figure.circles) include(circle.centre, circle.radius);
  for (const Figure::Dot& dot : figure.dots) include(dot.centre, 0);
  if (!(lowest_[0] <= highest_[0])) lowest_ = highest_ = {0, 0};
  const double size = std::max(highest_[0] - lowest_[0], highest_[1] - lowest_[1]);
  scale_ = size > 0 ? (figure_pixels - 2 * figure_margin) / size : 1;
  width_ = (highest_[0] - lowest_[0]) * scale_ + 2 * figure_margin;
  height_ = (highest_[1] - lowest_[1]) * scale_ + 2 * figure_margin + (figure.scale ? scale_band : 0);
}

Figure::Point FigurePage::place(const Figure::Point& point) const {
  return {figure_margin + (point[0] - lowest_[0]) * scale_, figure_margin + (highest_[1] - point[1]) * scale_};
}

std::array<Figure::Point, 2> FigurePage::bar(double length) const {
  const double y = height_ - scale_band / 2 - figure_margin / 2;
  return {{{figure_margin, y}, {figure_margin + length * scale_, y}}};
}

void FigurePage::include(const Figure::Point& point, double radius) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    lowest_[axis] = std::min(lowest_[axis], point[axis] - radius);
    highest_[axis] = std::max(highest_[axis], point[axis] + radius);
  }
}

}  // namespace delcert
