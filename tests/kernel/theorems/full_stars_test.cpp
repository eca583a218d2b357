#include "kernel/theorems/full_stars.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/theorems/torus_mesh.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FullStars, are_those_of_a_grid) {
  const Mesh<2> mesh = torus_mesh(16, 6);
  EXPECT_TRUE(check_full_stars<2>(mesh.charts, mesh.simplices).empty());
  // Around twice: every star is full.
  const Mesh<2> twice = torus_mesh(8, 6, 2);
  EXPECT_TRUE(check_full_stars<2>(twice.charts, twice.simplices).empty());
}

TEST(FullStars, lose_a_simplex) {
  Mesh<2> mesh = torus_mesh(16, 6);
  const LabelSimplex<2> lost = mesh.simplices[77];
  mesh.simplices.erase(mesh.simplices.begin() + 77);
  const auto failures = check_full_stars<2>(mesh.charts, mesh.simplices);
  ASSERT_EQ(failures.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(failures[k].label, Label(lost[k]));
    EXPECT_EQ(failures[k].reason, "a face in other than two simplices");
  }
}

TEST(FullStars, do_not_fold) {
  // A vertex that is pushed over an edge at it: simplices overlap.
  Mesh<2> mesh = torus_mesh(16, 6);
  const std::uint32_t pushed = 50;
  const std::uint32_t neighbour = 51;
  for (std::size_t axis = 0; axis < 3; ++axis)
    mesh.points[pushed][axis] = mesh.points[neighbour][axis] * ratio(3, 2) - mesh.points[pushed][axis] * ratio(1, 2);
  mesh.charts.clear();
  mesh.add_charts(Rational(1), ratio(1, 2));
  const auto failures = check_full_stars<2>(mesh.charts, mesh.simplices);
  ASSERT_FALSE(failures.empty());
  EXPECT_TRUE(std::any_of(failures.begin(), failures.end(), [](const StarFailure& failure) {
    return failure.reason == "two simplices on one side of a face, or a flat one";
  }));
}

/// The label 0 at the centre of a disc, others about it, and a fan of triangles between these.
std::vector<StarFailure> failures_of_fan(const std::vector<std::array<int, 2>>& places,
                                         const std::vector<std::uint32_t>& order) {
  std::vector<TangentChart> charts;
  const auto add = [&](const std::array<int, 2>& place) {
    ChartData data;
    data.centre = {Rational(place[0]), Rational(place[1]), Rational(0)};
    data.columns = {1, 2, 3};
    data.skew = {Rational(0), Rational(0), Rational(0)};
    data.preconditioner = {Rational(1)};
    charts.emplace_back(data, 2);
  };
  add({0, 0});
  for (const auto& place : places) add(place);
  std::vector<LabelSimplex<2>> simplices;
  for (std::size_t k = 0; k < order.size(); ++k) {
    LabelSimplex<2> simplex{0, order[k], order[(k + 1) % order.size()]};
    std::sort(simplex.begin(), simplex.end());
    simplices.push_back(simplex);
  }
  std::vector<StarFailure> result = check_full_stars<2>(charts, simplices);
  std::erase_if(result, [](const StarFailure& failure) { return failure.label != Label(0); });
  return result;
}

TEST(FullStars, go_around_once) {
  const std::vector<std::array<int, 2>> places{{4, 0}, {3, 3}, {0, 4}, {-3, 3}, {-4, 0}, {-3, -3}, {0, -4}, {3, -3}};
  EXPECT_TRUE(failures_of_fan(places, {1, 2, 3, 4, 5, 6, 7, 8}).empty());
  // Every third one: around three times.
  const auto thrice = failures_of_fan(places, {1, 4, 7, 2, 5, 8, 3, 6});
  ASSERT_EQ(thrice.size(), 1U);
  EXPECT_EQ(thrice[0].reason, "it goes around its label more than once");
}

TEST(FullStars, are_decided_where_doubles_cannot_tell) {
  // Three labels on a line through the fourth: a flat simplex, whatever the rounding.
  const auto flat = failures_of_fan({{3, 1}, {-6, -2}, {1, -3}}, {1, 2, 3});
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat[0].reason, "two simplices on one side of a face, or a flat one");
  EXPECT_TRUE(failures_of_fan({{3, 1}, {-6, -1}, {1, -3}}, {1, 2, 3}).empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
