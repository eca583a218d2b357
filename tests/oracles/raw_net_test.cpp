// Nets as they were sampled, not perturbed: stars of different charts disagree, and nothing is certified. CGAL computes
// every star anew, from coordinates of 256 bits in the chart of its label, with exact predicates.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/oracles/arb_vector.hpp"
#include "tests/oracles/space_form_sample.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <int m>
struct Cgal;

template <>
struct Cgal<2> {
  using Base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Base>>;
  using Point = Kernel::Point_2;
  static Point point(const Vector<Rational, 2>& x) {
    return {cgal_number<Kernel::FT>(x[0]), cgal_number<Kernel::FT>(x[1])};
  }
  static Kernel::FT squared_radius(Delaunay::Face_handle cell) {
    return CGAL::squared_radius(cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point());
  }
  static std::vector<Delaunay::Face_handle> cells_at(const Delaunay& t, Delaunay::Vertex_handle v) {
    std::vector<Delaunay::Face_handle> result;
    auto face = t.incident_faces(v);
    const auto first = face;
    do result.push_back(face);
    while (++face != first);
    return result;
  }
};

template <>
struct Cgal<3> {
  using Base = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Base>>;
  using Point = Kernel::Point_3;
  static Point point(const Vector<Rational, 3>& x) {
    return {cgal_number<Kernel::FT>(x[0]), cgal_number<Kernel::FT>(x[1]), cgal_number<Kernel::FT>(x[2])};
  }
  static Kernel::FT squared_radius(Delaunay::Cell_handle cell) {
    return CGAL::squared_radius(cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
                                cell->vertex(3)->point());
  }
  static std::vector<Delaunay::Cell_handle> cells_at(const Delaunay& t, Delaunay::Vertex_handle v) {
    std::vector<Delaunay::Cell_handle> result;
    t.incident_cells(v, std::back_inserter(result));
    return result;
  }
};

/// Points of the sphere seen in the charts about each other, by Arb: no code is shared with the run but the net.
template <int m>
class SphereCharts {
 public:
  explicit SphereCharts(const SpaceFormAtlas<m>& atlas) {
    for (std::uint32_t label = 0; label < atlas.size(); ++label) {
      // (1 − D, a)/(1 + D), D = |a|²/4.
      const auto& a = atlas.centre(Label(label));
      Rational deviation(0);
      for (const auto& entry : a) deviation += entry * entry / Rational(4);
      ModelPoint<Rational, m> x;
      x[0] = (Rational(1) - deviation) / (Rational(1) + deviation);
      for (std::size_t axis = 0; axis < m; ++axis) x[axis + 1] = a[axis] / (Rational(1) + deviation);
      balls_.emplace_back(x);
      for (std::size_t axis = 0; axis <= m; ++axis) rounded_.push_back(approximate_double(x[axis]));
    }
  }

  /// The labels within this angle of a label, itself the first.
  [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t label, double angle) const {
    std::vector<std::uint32_t> result{label};
    for (std::uint32_t other = 0; other < balls_.size(); ++other) {
      double cosine = 0;
      for (std::size_t axis = 0; axis <= m; ++axis)
        cosine += rounded_[label * (m + 1) + axis] * rounded_[other * (m + 1) + axis];
      if (other != label && cosine > std::cos(angle)) result.push_back(other);
    }
    return result;
  }

  /// The point of `other` in the chart of `label`.
  [[nodiscard]] Vector<Rational, m> in_chart(std::uint32_t label, std::uint32_t other) const {
    if (other == label) return {};  // 0
    return balls_[other].template seen_from<m>(balls_[label]);
  }

 private:
  std::vector<ArbVector> balls_;
  std::vector<double> rounded_;
};

/// star(i) among the points within `reach`, and whether no circumball of it leaves that: then it is the star among all.
template <int m>
LabelComplex<m> exact_star(const SphereCharts<m>& charts, std::uint32_t label, double reach) {
  using Delaunay = typename Cgal<m>::Delaunay;
  std::vector<std::pair<typename Cgal<m>::Point, std::uint32_t>> named;
  for (const std::uint32_t other : charts.within(label, reach))
    named.emplace_back(Cgal<m>::point(charts.in_chart(label, other)), other);
  const auto home = named.front().first;
  Delaunay triangulation;
  triangulation.insert(named.begin(), named.end());
  const auto vertex = triangulation.nearest_vertex(home);
  EXPECT_EQ(vertex->info(), label);
  LabelComplex<m> result;
  for (const auto& cell : Cgal<m>::cells_at(triangulation, vertex)) {
    if (triangulation.is_infinite(cell)) {
      ADD_FAILURE() << "the star of label " << label << " is not closed";
      return {};
    }
    LabelSimplex<m> simplex;
    for (int corner = 0; corner <= m; ++corner)
      simplex[static_cast<std::size_t>(corner)] = cell->vertex(corner)->info();
    result.push_back(simplex);
    // A ball through the centre of the chart reaches no farther than its diameter.
    const double squared = CGAL::to_double(Cgal<m>::squared_radius(cell));
    EXPECT_LT(2.02 * std::sqrt(squared), reach) << "label " << label;
  }
  sort_simplices<m>(result);
  return result;
}

/// For each simplex that some star misses: its labels whose stars miss it.
template <int m>
std::map<LabelSimplex<m>, std::vector<std::uint32_t>> missing_in(const std::vector<LabelComplex<m>>& stars) {
  std::map<LabelSimplex<m>, std::vector<std::uint32_t>> result;
  for (const auto& star : stars) {
    for (const auto& simplex : star) {
      std::vector<std::uint32_t> missing;
      for (const std::uint32_t label : simplex) {
        if (!std::binary_search(stars[label].begin(), stars[label].end(), simplex)) missing.push_back(label);
      }
      if (!missing.empty()) result[simplex] = missing;
    }
  }
  return result;
}

template <int m>
void expect_the_same_disagreement(const StarAgreement& ours, const std::vector<LabelComplex<m>>& stars) {
  const auto missing = missing_in<m>(stars);
  std::set<std::uint32_t> labels;
  std::size_t pairs = 0;
  std::set<LabelSimplex<m>> simplices;
  for (const auto& [simplex, of] : missing) {
    simplices.insert(simplex);
    labels.insert(of.begin(), of.end());
    pairs += of.size();
  }
  EXPECT_EQ(ours.missing, pairs);
  EXPECT_EQ(ours.labels, std::vector<Label>(labels.begin(), labels.end()));
  std::set<LabelSimplex<m>> named;
  for (const StarFailure& failure : ours.failures) {
    LabelSimplex<m> simplex;
    for (std::size_t at = 0; at <= m; ++at) simplex[at] = failure.concerned.at(at).value;
    std::sort(simplex.begin(), simplex.end());
    EXPECT_EQ(missing.count(simplex) == 1 ? missing.at(simplex).front() : 0U, failure.label.value);
    named.insert(simplex);
  }
  EXPECT_EQ(named, simplices);
}

template <int m>
void expect_refused(const std::string& manifold, const Rational& radius) {
  const auto sample = space_form_sample<m>(manifold, radius, false);
  EXPECT_FALSE(sample.run.is_certified());
  EXPECT_TRUE(sample.run.star_failures.empty());  // each star is certified in its own chart
  ASSERT_GT(sample.run.agreement.stars, 0U);
  const SphereCharts<m> charts(sample.atlas);
  std::vector<LabelComplex<m>> stars;
  for (std::uint32_t label = 0; label < sample.atlas.size(); ++label) {
    stars.push_back(exact_star<m>(charts, label, 2.7 * approximate_double(radius)));
    LabelComplex<m> ours;
    for (const auto& others : sample.run.complex.star(Label(label))) {
      LabelSimplex<m> simplex;
      std::copy(others.begin(), others.end(), simplex.begin());
      simplex[m] = label;
      ours.push_back(simplex);
    }
    sort_simplices<m>(ours);
    ASSERT_EQ(label_disagreement<m>(ours, stars.back()), "") << "star of " << label;
  }
  expect_the_same_disagreement<m>(sample.run.agreement, stars);
  // A star that lost a simplex, or has another one, is noticed.
  auto changed = stars;
  const Label concerned = sample.run.agreement.labels.front();
  changed[concerned.value].erase(changed[concerned.value].begin());
  EXPECT_NE(missing_in<m>(changed), missing_in<m>(stars));
}

TEST(RawNet, of_sphere_2_at_1_5_has_the_disagreeing_stars_that_are_named) {
  expect_refused<2>("sphere-2", Rational(Integer(1), Integer(5)));
}

TEST(RawNet, of_sphere_3_at_1_5_has_the_disagreeing_stars_that_are_named) {
  expect_refused<3>("sphere-3", Rational(Integer(1), Integer(5)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
