// The Euler characteristic of a surface by a second route: the number of extrema of a height function less that of its
// saddles. They are the zeros of three functions in a box, all of which interval Newton finds.

#include <deque>
#include <numeric>
#include <optional>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/submanifold/dense.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"
#include "kernel/number/middle.hpp"
#include "kernel/topology/abelian_group.hpp"
#include "tests/oracles/submanifold_sample.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Direction = std::array<int, 3>;
using Box = std::array<Interval, 3>;

/// Heights along a × b; the critical points are the zeros of f, Df·a and Df·b.
class Heights {
 public:
  Heights(const ZeroSet& zero_set, const Direction& a, const Direction& b)
      : f_(zero_set.map()), plane_{a, b}, gradient_(3), hessian_(9) {}

  struct Values {
    Box g;
    std::array<Box, 3> derivative;
    Interval determinant;  ///< of D²f on the plane of a and b
  };
  [[nodiscard]] Values on(const Box& x) {
    Values result;
    EXPECT_TRUE(f_.second(x.data(), &result.g[0], gradient_.data(), hessian_.data()));
    std::copy(gradient_.begin(), gradient_.end(), result.derivative[0].begin());
    std::array<std::array<Interval, 2>, 2> form;
    for (std::size_t k = 0; k < 2; ++k) {
      result.g[k + 1] = along(plane_[k], gradient_.data());
      for (std::size_t axis = 0; axis < 3; ++axis)
        result.derivative[k + 1][axis] = along(plane_[k], &hessian_[3 * axis]);
      for (std::size_t l = 0; l < 2; ++l) form[k][l] = along(plane_[l], result.derivative[k + 1].data());
    }
    result.determinant = form[0][0] * form[1][1] - form[0][1] * form[1][0];
    return result;
  }

 private:
  static Interval along(const Direction& direction, const Interval* v) {
    return Interval(direction[0]) * v[0] + Interval(direction[1]) * v[1] + Interval(direction[2]) * v[2];
  }
  FormulaEvaluation<Interval> f_;
  std::array<Direction, 2> plane_;
  std::vector<Interval> gradient_, hessian_;
};

bool contains_zero(const Interval& x) { return x.lower() <= 0 && x.upper() >= 0; }
bool are_disjoint(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a[axis].upper() < b[axis].lower() || b[axis].upper() < a[axis].lower()) return true;
  }
  return false;
}
bool lies_inside(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a[axis].lower() <= b[axis].lower() || a[axis].upper() >= b[axis].upper()) return false;
  }
  return true;
}

/// Krawczyk's operator; none if the derivative at the middle is nearly singular.
std::optional<Box> krawczyk(Heights& heights, const Box& x) {
  Box middle;
  for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = Interval::exactly(middle_of(x[axis]));
  const auto at_middle = heights.on(middle);
  const auto on_box = heights.on(x);
  Dense<double> rough;
  for (const Box& row : at_middle.derivative) {
    for (const Interval& entry : row) rough.push_back(middle_of(entry));
  }
  const auto inverse = inverse_of(rough, 3);
  if (!inverse) return std::nullopt;
  Box result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = middle[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval y = Interval::exactly((*inverse)[3 * i + k]);
      result[i] -= y * at_middle.g[k];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      Interval entry = i == j ? Interval(1) : Interval(0);
      for (std::size_t k = 0; k < 3; ++k) entry -= Interval::exactly((*inverse)[3 * i + k]) * on_box.derivative[k][j];
      result[i] += entry * (x[j] - middle[j]);
    }
  }
  return result;
}

struct CriticalPoints {
  std::vector<Box> places;
  int extrema = 0;
  int saddles = 0;
  bool is_complete = true;  ///< false: parts remained of which nothing is known
};

CriticalPoints critical_points(const ZeroSet& zero_set, const Direction& a, const Direction& b,
                               std::size_t most_parts = 2'000'000) {
  const RoundingGuard guard;
  Heights heights(zero_set, a, b);
  std::deque<Box> parts(1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& [from, to] = zero_set.description().box[axis];
    parts[0][axis] = Interval::between(approximate_double(from), approximate_double(to));
  }
  CriticalPoints result;
  for (std::size_t count = 0; !parts.empty(); ++count) {
    if (count == most_parts) {
      result.is_complete = false;
      break;
    }
    const Box part = parts.front();
    parts.pop_front();
    if (std::any_of(result.places.begin(), result.places.end(),
                    [&](const Box& place) { return lies_inside(part, place); }))
      continue;
    const auto values = heights.on(part);
    if (!std::all_of(values.g.begin(), values.g.end(), contains_zero)) continue;
    // One zero in a box that is half as large again: those at the sides of parts are found too.
    Box larger;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double more = (part[axis].upper() - part[axis].lower()) / 4;
      larger[axis] = Interval::between(part[axis].lower() - more, part[axis].upper() + more);
    }
    if (const auto image = krawczyk(heights, larger); image && lies_inside(*image, larger)) {
      Box place = larger;
      for (int round = 0; round < 4; ++round) {
        if (const auto next = krawczyk(heights, place); next && lies_inside(*next, place)) place = *next;
      }
      // Both boxes have exactly one zero. If they meet where one of them has it, it is the same.
      const bool is_new = std::all_of(result.places.begin(), result.places.end(),
                                      [&](const Box& other) { return are_disjoint(place, other); });
      if (is_new) {
        const Interval determinant = heights.on(place).determinant;
        EXPECT_FALSE(contains_zero(determinant));
        ++(determinant.lower() > 0 ? result.extrema : result.saddles);
        result.places.push_back(place);
      }
      continue;
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (part[axis].upper() - part[axis].lower() > part[longest].upper() - part[longest].lower()) longest = axis;
    }
    Box lower = part;
    Box upper = part;
    const double cut = middle_of(part[longest]);
    lower[longest] = Interval::between(part[longest].lower(), cut);
    upper[longest] = Interval::between(cut, part[longest].upper());
    parts.push_back(lower);
    parts.push_back(upper);
  }
  return result;
}

/// Σ (−1)ᵏ rank H_k of what the file says.
int said_characteristic(const SubmanifoldDescription& manifold) {
  int result = 0;
  for (std::size_t degree = 0; degree < manifold.homology.size(); ++degree) {
    const std::string& group = manifold.homology[degree];
    int rank = 0;
    if (group == "Z") rank = 1;
    if (group.starts_with("Z^")) rank = std::stoi(group.substr(2));
    result += degree % 2 == 0 ? rank : -rank;
  }
  return result;
}

// A direction that is in no symmetry of the examples.
constexpr Direction first_direction = {13, -7, 2};
constexpr Direction second_direction = {4, 11, -9};

CriticalPoints of(const char* name) {
  return critical_points(ZeroSet(std::get<SubmanifoldDescription>(find_any_manifold(name))), first_direction,
                         second_direction);
}

TEST(CriticalPoints, give_the_euler_characteristic_that_the_files_say) {
  for (const char* name : {"torus-of-revolution", "ellipsoid", "two-spheres", "tanglecube", "genus-2"}) {
    const auto manifold = std::get<SubmanifoldDescription>(find_any_manifold(name));
    const CriticalPoints found = of(name);
    EXPECT_TRUE(found.is_complete) << name;
    ASSERT_FALSE(manifold.homology.empty()) << name;
    EXPECT_EQ(found.extrema - found.saddles, said_characteristic(manifold)) << name;
    EXPECT_GE(found.extrema, 2) << name;
  }
}

TEST(CriticalPoints, give_that_of_certified_complexes) {
  for (const auto& [name, radius] : {std::pair{"torus-of-revolution", ratio(1, 8)}, {"two-spheres", ratio(1, 17)}}) {
    const SubmanifoldSample<2> sample(name, radius);
    LabelComplex<1> edges;
    for (const auto& triangle : sample.simplices) {
      edges.push_back({triangle[0], triangle[1]});
      edges.push_back({triangle[0], triangle[2]});
      edges.push_back({triangle[1], triangle[2]});
    }
    sort_simplices<1>(edges);
    const CriticalPoints found = of(name);
    EXPECT_EQ(found.extrema - found.saddles, static_cast<int>(sample.size()) - static_cast<int>(edges.size()) +
                                                 static_cast<int>(sample.simplices.size()))
        << name;
  }
}

TEST(CriticalPoints, are_not_counted_where_they_are_whole_circles) {
  // Along its axis, the heights of the torus have circles of critical points.
  const ZeroSet torus(std::get<SubmanifoldDescription>(find_any_manifold("torus-of-revolution")));
  EXPECT_FALSE(critical_points(torus, {1, 0, 0}, {0, 1, 0}, 20'000).is_complete);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
