#include "kernel/perturb/forbidden_search.hpp"

#include "kernel/perturb/perturbation.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/simplex/faces.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Γ₀² and α₀² chosen freely; ε and the edge bound as lengths.
ForbiddenPropertiesParameters<Rational> parameters_of(const Rational& squared_flake_parameter,
                                                      const Rational& squared_hoop_bound,
                                                      const Rational& sampling_radius) {
  return {squared_flake_parameter, squared_hoop_bound, sampling_radius, ratio(5, 2) * sampling_radius};
}

template <int m>
ForbiddenSearch search(const FlatSpace<m>& space, const ExactPoints<m>& points,
                       const ForbiddenPropertiesParameters<Rational>& parameters) {
  const PointSet<m> set(points);
  const FlatAtlas<m> atlas(space, set, parameters.sampling_radius);
  return search_forbidden<m>(atlas, set, parameters, Rational(0), no_progress());
}

template <int m>
bool is_forbidden(const FlatSpace<m>& space, const ExactPoints<m>& vertices,
                  const ForbiddenPropertiesParameters<Rational>& parameters) {
  return is_proved(has_forbidden_properties(simplex_in<m>(space, vertices), parameters));
}

/// Looks at all sets of 3 … m + 2 points of a ball.
template <int m>
bool has_forbidden_set(const FlatSpace<m>& space, const ExactPoints<m>& points,
                       const ForbiddenPropertiesParameters<Rational>& parameters) {
  for (std::size_t size = 3; size <= m + 2; ++size) {
    for (Faces faces(points.size(), size); faces.has_face(); faces.advance()) {
      ExactPoints<m> vertices;
      for (const std::size_t at : faces.vertices()) vertices.push_back(points[at]);
      if (is_forbidden<m>(space, vertices, parameters)) return true;
    }
  }
  return false;
}

/// Where radii vary: P2 and P3 by the least radius of a set.
TEST(ForbiddenSearch, counts_by_the_least_radius_of_a_set) {
  const auto space = ball_of<2>(Rational(1));
  const auto parameters = parameters_of(Rational::power_of_two(-8), ratio(1, 100), ratio(1, 4));
  const std::vector<double> units{1, 0.5, 0.25};
  int found = 0;
  int fewer = 0;
  for (std::uint64_t trial = 1; trial <= 240; ++trial) {
    const auto points = random_points<2>(9, trial, 8, Rational(0), ratio(5, 8));
    std::vector<double> lengths;
    for (std::size_t label = 0; label < points.size(); ++label) lengths.push_back(units[label % 3]);
    const SamplingRadii radii = SamplingRadii(lengths).scaled_to(parameters.sampling_radius);
    const PointSet<2> set(points);
    const auto result =
        search_forbidden<2>(FlatAtlas<2>(space, set, radii), set, parameters, Rational(0), no_progress());
    bool expected = false;
    for (std::size_t size = 3; size <= 4; ++size) {
      for (Faces faces(points.size(), size); faces.has_face(); faces.advance()) {
        ExactPoints<2> vertices;
        double unit = 1;
        for (const std::size_t at : faces.vertices()) {
          vertices.push_back(points[at]);
          unit = std::min(unit, radii.unit_of(at));
        }
        auto scaled = parameters;
        scaled.sampling_radius *= Rational::exactly(unit);
        scaled.edge_bound *= Rational::exactly(unit);
        expected = expected || is_forbidden<2>(space, vertices, scaled);
      }
    }
    EXPECT_EQ(result.found.has_value(), expected) << trial;
    found += expected ? 1 : 0;
    fewer += !expected && search<2>(space, points, parameters).found ? 1 : 0;
  }
  EXPECT_GT(found, 5);
  EXPECT_GT(fewer, 5);
}

/// What is found has the properties; and something is found exactly if a look at everything finds something.
template <int m>
int check_against_all(std::size_t count, const Rational& squared_flake_parameter, const Rational& squared_hoop_bound,
                      int trials) {
  int found = 0;
  const auto space = ball_of<m>(Rational(1));
  const auto parameters = parameters_of(squared_flake_parameter, squared_hoop_bound, ratio(1, 4));
  for (int trial = 0; trial < trials; ++trial) {
    const auto points = random_points<m>(count, static_cast<std::uint64_t>(trial) + 1, 8, Rational(0), ratio(5, 8));
    const auto result = search<m>(space, points, parameters);
    EXPECT_EQ(result.found.has_value(), (has_forbidden_set<m>(space, points, parameters)));
    if (!result.found) continue;
    ++found;
    ExactPoints<m> vertices;
    for (const Label label : *result.found) vertices.push_back(points[label.value]);
    EXPECT_TRUE((is_forbidden<m>(space, vertices, parameters)));
  }
  return found;
}

TEST(SearchForbidden, agrees_with_a_look_at_all_sets) {
  // On a line α₀ = 2 is where triples of equal gaps begin.
  const int on_lines = check_against_all<1>(8, ratio(1, 4), ratio(41, 10), 40);
  EXPECT_GT(on_lines, 3);
  EXPECT_LT(on_lines, 37);
  const int in_planes = check_against_all<2>(8, ratio(1, 100), ratio(1, 2000), 40);
  EXPECT_GT(in_planes, 5);
  EXPECT_LT(in_planes, 35);
  const int in_space = check_against_all<3>(7, ratio(1, 100), ratio(1, 40), 25);
  EXPECT_GT(in_space, 1);
  EXPECT_LT(in_space, 24);
}

/// A Poisson-disk net of the disk, perturbed in measured mode with this tolerance.
ExactPoints<2> clean_points(const FlatSpace<2>& space, const Rational& radius, const Rational& tolerance) {
  const FlatAtlas<2> atlas(space, PointSet<2>(poisson_disk_net<2>(space, radius, 1, no_progress())), radius);
  PerturbationParameters parameters;
  parameters.separation = Rational(1);
  parameters.perturbation = ratio(1, 4);
  parameters.tolerance = tolerance;
  parameters.edge_bound = ratio(5, 2);
  parameters.circumradius_bound = Rational(2);
  Perturbation<2> perturbation(atlas, parameters);
  perturbation.place_all(no_progress());
  ExactPoints<2> points;
  for (std::uint32_t i = 0; i < atlas.size(); ++i) points.push_back(perturbation.points().exact(Label(i)));
  return points;
}

TEST(SearchForbidden, finds_a_cocircular_quadruple_planted_in_a_clean_net) {
  const auto space = cubic_torus<2>();
  const Rational radius = ratio(1, 12);
  const Rational tolerance = ratio(1, 64);
  // α₀R ≤ 2α₀ε is the tolerance.
  const auto parameters = parameters_of(ratio(1, 1000000), square(tolerance / Rational(2)), radius);
  auto points = clean_points(space, radius, tolerance);
  const auto clean = search<2>(space, points, parameters);
  EXPECT_FALSE(clean.found.has_value());
  EXPECT_GT(clean.configurations, 10 * points.size());
  EXPECT_GT(clean.simplices, 10 * points.size());
  EXPECT_LT(clean.decided_exactly, clean.configurations / 10);

  // Three neighbours of a triangle, and a fourth point put on their circle, almost.
  const auto near = lifts_within<2>(space, points, points[5], ratio(3, 2) * radius);
  ASSERT_GE(near.size(), 4U);
  Lifts<2> triangle;
  for (const auto& lift : near) {
    if (lift.shift == Shift<2>{} && triangle.size() < 3) triangle.push_back(lift);
  }
  ASSERT_EQ(triangle.size(), 3U);
  const auto ball = ball_of_simplex<2>(space, all_at<2>(points, std::span<const Lift<2>>(triangle)));
  ASSERT_LT(ball->squared_radius, Rational(2) * square(radius));
  const auto spoke = difference(points[triangle[0].index], ball->centre);
  // A quarter turn, and a hair outwards: near-cocircular, not cocircular.
  const Rational hair = Rational(1) + Rational::power_of_two(-30);
  points.push_back(sum(ball->centre, scaled(hair, Vector<Rational, 2>{-spoke[1], spoke[0]})));
  const auto planted = search<2>(space, points, parameters);
  ASSERT_TRUE(planted.found.has_value());
  EXPECT_TRUE(std::find(planted.found->begin(), planted.found->end(), Label(points.size() - 1)) !=
              planted.found->end());
}

TEST(SearchForbidden, finds_a_flat_configuration) {
  // k = 1: a point within α₀R of an end of the opposite edge, for each of the three: a tiny triangle will not do, as
  // R is that of the edge; nearly doubled points do not either; with α₀ large, three collinear points do.
  const auto space = ball_of<2>(Rational(9));
  const ExactPoints<2> collinear{{Rational(0), Rational(0)}, {ratio(1, 2), Rational(0)}, {Rational(1), Rational(0)}};
  const auto loose = parameters_of(ratio(1, 1000000), Rational(4), Rational(1));
  EXPECT_TRUE((is_forbidden<2>(space, collinear, loose)));
  const auto result = search<2>(space, collinear, loose);
  ASSERT_TRUE(result.found.has_value());
  EXPECT_EQ(*result.found, (std::vector<Label>{Label(0), Label(1), Label(2)}));
  EXPECT_GT(result.decided_exactly, 0U);
  // Not with a small α₀.
  EXPECT_FALSE(search<2>(space, collinear, parameters_of(ratio(1, 1000000), ratio(1, 100), Rational(1))).found);
}

TEST(SearchForbidden, finds_a_flat_square_in_space_though_it_is_degenerate) {
  // Four points of a square are a degenerate tetrahedron with good facets, each vertex on the circle of the others.
  const auto space = ball_of<3>(Rational(9));
  const Rational half = ratio(1, 2);
  const Rational zero(0);
  const ExactPoints<3> square_in_space{{zero, zero, zero}, {half, zero, zero}, {half, half, zero}, {zero, half, zero}};
  const auto parameters = parameters_of(ratio(1, 1000000), Rational::power_of_two(-60), Rational(1));
  const auto result = search<3>(space, square_in_space, parameters);
  ASSERT_TRUE(result.found.has_value());
  EXPECT_EQ(result.found->size(), 4U);
  auto lifted = square_in_space;
  lifted[3][2] = ratio(1, 10);
  EXPECT_FALSE(search<3>(space, lifted, parameters).found.has_value());
}

TEST(SearchForbidden, sees_configurations_across_the_boundary_of_the_unit_cell) {
  const auto space = cubic_torus<2>();
  const Rational radius = ratio(1, 24);
  const Rational step = ratio(1, 48);
  // A square about the corner of the cell.
  const ExactPoints<2> points{
      {step, step}, {Rational(1) - step, step}, {Rational(1) - step, Rational(1) - step}, {step, Rational(1) - step}};
  const auto parameters = parameters_of(ratio(1, 1000000), Rational::power_of_two(-60), radius);
  const auto result = search<2>(space, points, parameters);
  ASSERT_TRUE(result.found.has_value());
  EXPECT_EQ(result.found->size(), 4U);
  auto moved_points = points;
  moved_points[2][0] += ratio(1, 500);
  EXPECT_FALSE(search<2>(space, moved_points, parameters).found.has_value());
}

TEST(SearchForbidden, looks_as_far_as_perturbed_points_can_be_from_their_originals) {
  // Seen from the originals, the points of the square are farther apart than the edge bound.
  const auto space = ball_of<2>(Rational(9));
  const Rational radius(1);
  const auto square_at = [](const Rational& side) {
    return ExactPoints<2>{{Rational(0), Rational(0)}, {side, Rational(0)}, {side, side}, {Rational(0), side}};
  };
  const FlatAtlas<2> atlas(space, PointSet<2>(square_at(Rational(2))), radius);
  const PointSet<2> perturbed(square_at(ratio(7, 4)));
  const auto parameters = parameters_of(ratio(1, 1000000), Rational::power_of_two(-60), radius);
  EXPECT_TRUE(search_forbidden<2>(atlas, perturbed, parameters, ratio(1, 2), no_progress()).found.has_value());
}

TEST(SearchForbidden, tells_its_progress) {
  const auto space = cubic_torus<2>();
  const PointSet<2> points(random_points<2>(1100, 1));
  const FlatAtlas<2> atlas(space, points, ratio(1, 1000));
  std::vector<std::size_t> reports;
  (void)search_forbidden<2>(atlas, points, parameters_of(ratio(1, 1000000), ratio(1, 1000000), ratio(1, 1000)),
                            Rational(0), [&](std::string_view stage, std::size_t done, std::size_t total) {
                              EXPECT_EQ(stage, "search forbidden configurations");
                              EXPECT_EQ(total, 1100U);
                              reports.push_back(done);
                            });
  EXPECT_EQ(reports, (std::vector<std::size_t>{0, 1024, 1100}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
