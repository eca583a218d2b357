#include "kernel/sample/covering.hpp"

#include "support/error.hpp"
#include "tests/kernel/stars/witness.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
struct Net {
  FlatSpace<m> space;
  ExactPoints<m> points;

  [[nodiscard]] std::vector<LiftedSimplex<m>> proposed() const {
    return propose_delaunay<m>(space, approximate_all<m>(points), 0.2);
  }
  [[nodiscard]] Covering<m> covering(const std::vector<LiftedSimplex<m>>& simplices) const {
    return certified_covering<m>(space, PointSet<m>(points), approximate_all<m>(points), simplices);
  }
  [[nodiscard]] std::string refusal(const std::vector<LiftedSimplex<m>>& simplices) const {
    return message_of<Rejection>([&] { (void)covering(simplices); });
  }
};

template <int m>
void check_torus(const Net<m>& net) {
  const auto proposed = net.proposed();
  const auto covering = net.covering(proposed);
  // The same simplices; oriented; in balls of the radius, which is that of one of them, up to rounding.
  EXPECT_EQ(covering.simplices.size(), proposed.size());
  Rational largest(0);
  for (std::size_t at = 0; at < proposed.size(); ++at) {
    auto sorted = covering.simplices[at];
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, proposed[at]);
    const auto vertices = all_at<m>(net.points, std::span<const Lift<m>>(covering.simplices[at]));
    EXPECT_GT(edge_determinant<m>(vertices), Rational(0));
    largest = maximum(largest, ball_of_simplex<m>(net.space, vertices)->squared_radius);
  }
  const Rational hair = Rational(1) + Rational::power_of_two(-30);
  EXPECT_EQ(complaint_of_torus_witness<m>(net.space, net.points, covering.simplices, covering.radius_upper * hair), "");
  EXPECT_LE(square(covering.radius_upper), largest * hair);
  // The farthest centre is so far from every point, nearly: what makes the radius the covering radius.
  Vector<Rational, m> centre;
  for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Rational::exactly(covering.farthest_centre[axis]);
  EXPECT_TRUE(lifts_within<m>(net.space, net.points, centre, covering.radius_upper / square(hair)).empty());
}

const Net<2> surface{hexagonal_torus(), random_points<2>(50, 1, 20, Rational(-1), Rational(2))};
const Net<3> solid{skewed_torus(), random_points<3>(40, 2, 20)};

TEST(CertifiedCovering, orients_simplices_and_bounds_their_balls) {
  check_torus<1>({cubic_torus<1>(), random_points<1>(20, 3, 20)});
  check_torus<2>(surface);
  check_torus<2>({square_torus_in_a_long_basis(), random_points<2>(50, 1, 20)});
  check_torus<3>(solid);
  // More than are measured in one thread.
  check_torus<2>({cubic_torus<2>(), random_points<2>(700, 4, 30)});
}

TEST(CertifiedCovering, notices_a_missing_simplex_and_names_a_neighbour) {
  auto simplices = surface.proposed();
  const auto removed = simplices[10];
  simplices.erase(simplices.begin() + 10);
  const std::string refusal = surface.refusal(simplices);
  EXPECT_TRUE(mentions(refusal, "has a free face"));
  // The simplex that it names has an edge of the missing one.
  const auto named = refusal.substr(refusal.find('{'));
  int shared = 0;
  for (const auto& vertex : removed) {
    const std::string label = std::to_string(vertex.index);
    for (const char* end : {",", "}"}) {
      shared += mentions(named, "{" + label + end) || mentions(named, " " + label + end) ? 1 : 0;
    }
  }
  EXPECT_GE(shared, 2) << refusal;

  auto solids = solid.proposed();
  solids.pop_back();
  EXPECT_TRUE(mentions(solid.refusal(solids), "has a free face"));
}

TEST(CertifiedCovering, notices_repeated_simplices) {
  auto simplices = surface.proposed();
  simplices.push_back(simplices[3]);
  EXPECT_TRUE(mentions(surface.refusal(simplices), "has a free face"));
  auto twice = surface.proposed();
  const auto once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  EXPECT_TRUE(mentions(surface.refusal(twice), "exactly once"));
}

TEST(CertifiedCovering, notices_a_flipped_diagonal_only_by_its_larger_balls) {
  // Two triangles on an edge {a, b} replaced by those on the other diagonal {c, d}: still a covering, if the
  // quadrilateral is convex, but with larger balls.
  const auto simplices = surface.proposed();
  const auto radius = surface.covering(simplices).radius_upper;
  int flips = 0;
  for (std::size_t first = 0; first < simplices.size() && flips < 3; ++first) {
    for (std::size_t second = first + 1; second < simplices.size(); ++second) {
      std::vector<Lift<2>> all(simplices[first].begin(), simplices[first].end());
      std::vector<Lift<2>> common;
      std::vector<Lift<2>> apexes;
      for (const auto& vertex : simplices[first]) {
        const bool shared = std::count(simplices[second].begin(), simplices[second].end(), vertex) > 0;
        (shared ? common : apexes).push_back(vertex);
      }
      for (const auto& vertex : simplices[second]) {
        if (std::count(all.begin(), all.end(), vertex) == 0) apexes.push_back(vertex);
      }
      if (common.size() != 2) continue;
      const auto side = [&](const Lift<2>& of) {
        return edge_determinant<2>(
            {at<2>(surface.points, apexes[0]), at<2>(surface.points, apexes[1]), at<2>(surface.points, of)});
      };
      if (side(common[0]) * side(common[1]) >= Rational(0)) continue;
      auto flipped = simplices;
      flipped[first] = canonical<2>({apexes[0], apexes[1], common[0]});
      flipped[second] = canonical<2>({apexes[0], apexes[1], common[1]});
      EXPECT_GE(surface.covering(flipped).radius_upper, radius);
      ++flips;
      break;
    }
  }
  EXPECT_EQ(flips, 3);
}

TEST(CertifiedCovering, refuses_nothing_at_all) { EXPECT_TRUE(mentions(surface.refusal({}), "no simplex")); }

// --- balls

const Net<2> disk{ball_of<2>(Rational(1)), random_points<2>(150, 4, 20, Rational(-2), Rational(4))};

TEST(CertifiedCovering, leaves_out_what_a_ball_does_not_need) {
  const auto proposed = disk.proposed();
  const auto covering = disk.covering(proposed);
  EXPECT_LT(covering.simplices.size(), proposed.size());
  for (const auto& simplex : covering.simplices) {
    const auto vertices = all_at<2>(disk.points, std::span<const Lift<2>>(simplex));
    EXPECT_GT(edge_determinant<2>(vertices), Rational(0));
    EXPECT_TRUE(lies_in_an_open_ball<2>(disk.space, vertices,
                                        covering.radius_upper * (Rational(1) + Rational::power_of_two(-30))));
  }
  // Random places of the ball are in one of the simplices.
  for (const auto& place : random_points<2>(300, 5, 12, Rational(-1), Rational(2))) {
    if (squared_norm<2>(disk.space, place) > Rational(1)) continue;
    EXPECT_TRUE(std::any_of(covering.simplices.begin(), covering.simplices.end(), [&](const auto& simplex) {
      auto vertices = all_at<2>(disk.points, std::span<const Lift<2>>(simplex));
      for (std::size_t corner = 0; corner < 3; ++corner) {
        auto replaced = vertices;
        replaced[corner] = place;
        if (edge_determinant<2>(replaced) < Rational(0)) return false;
      }
      return true;
    }));
  }
}

TEST(CertifiedCovering, of_a_ball_needs_every_simplex_in_it) {
  auto simplices = disk.proposed();
  const auto central = std::find_if(simplices.begin(), simplices.end(), [](const auto& simplex) {
    return std::all_of(simplex.begin(), simplex.end(), [](const auto& vertex) {
      return squared_norm<2>(disk.space, disk.points[vertex.index]) < Rational(1);
    });
  });
  ASSERT_NE(central, simplices.end());
  simplices.erase(central);
  EXPECT_TRUE(mentions(disk.refusal(simplices), "does not reach beyond the ball at net simplex {"));
}

TEST(CertifiedCovering, of_a_ball_notices_inverted_simplices) {
  // Oriented as a mirror image of the points proposed for: inverted, every one of them.
  auto mirrored = approximate_all<2>(disk.points);
  for (auto& point : mirrored) point[0] = -point[0];
  const std::string refusal = message_of<Rejection>(
      [&] { (void)certified_covering<2>(disk.space, PointSet<2>(disk.points), mirrored, disk.proposed()); });
  EXPECT_TRUE(mentions(refusal, "is inverted")) << refusal;
}

TEST(CertifiedCovering, of_a_ball_notices_that_no_simplex_starts_in_it) {
  // One triangle around the ball, with vertices far outside: its ball is that of the covering, and it covers, but
  // nothing shows that from a vertex within.
  const Net<2> around{ball_of<2>(Rational(1)),
                      {{Rational(-4), Rational(-3)}, {Rational(4), Rational(-3)}, {Rational(0), Rational(5)}}};
  EXPECT_TRUE(mentions(around.refusal(around.proposed()), "no net simplex has a vertex in the ball"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
