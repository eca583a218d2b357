#include "proofs/drawing/figure/figure_page.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

Figure wide() {
  Figure figure;
  figure.paths.push_back({{{{0, 0}, {2, 1}}}, false, std::nullopt});
  return figure;
}

TEST(FigurePage, is_720_pixels_in_the_longer_direction) {
  const FigurePage page(wide());
  EXPECT_DOUBLE_EQ(page.scale(), 348);
  EXPECT_DOUBLE_EQ(page.width(), 720);
  EXPECT_DOUBLE_EQ(page.height(), 372);
  EXPECT_EQ(page.place({0, 0}), (Figure::Point{12, 360}));
  EXPECT_EQ(page.place({2, 1}), (Figure::Point{708, 12}));
}

TEST(FigurePage, has_room_for_circles_and_dots) {
  Figure figure = wide();
  figure.circles.push_back({{1, 0}, 1, {}});
  figure.dots.push_back({{1, 2}, 3, {}});
  const FigurePage page(figure);
  EXPECT_DOUBLE_EQ(page.height(), 720);
  EXPECT_EQ(page.place({1, -1})[1], 708);
  EXPECT_EQ(page.place({1, 2})[1], 12);
}

TEST(FigurePage, has_the_bar_of_a_scale_below) {
  Figure figure = wide();
  const double without = FigurePage(figure).height();
  figure.scale = Figure::Scale{0.5, "0.5"};
  const FigurePage page(figure);
  const auto [from, to] = page.bar(0.5);
  EXPECT_DOUBLE_EQ(to[0] - from[0], 174);
  EXPECT_GT(from[1], without - 12);
  EXPECT_LT(from[1], page.height());
}

TEST(FigurePage, of_nothing_or_a_point_is_finite) {
  EXPECT_DOUBLE_EQ(FigurePage(Figure{}).width(), 24);
  Figure point;
  point.dots.push_back({{5, 7}, 1, {}});
  EXPECT_EQ(FigurePage(point).place({5, 7}), (Figure::Point{12, 12}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
