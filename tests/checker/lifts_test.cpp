#include "proofs/checker/space_forms/lifts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "proofs/checker/core/around_simplex.hpp"
#include "proofs/checker/core/reader.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

double middle(const checker::Interval& x) { return (x.lower() + x.upper()) / 2; }

/// A sample as the checker reads it.
struct Read {
  explicit Read(const SpaceFormSample& of)
      : sample(of),
        text(sealed(of.document())),
        certificate(text),
        data(checker::core::data_of(certificate)),
        complex(data) {
    checker::Report report;
    checker::core::check_manifold(complex, report);
    EXPECT_TRUE(report.findings.empty());
  }
  /// A point in the coordinates of the core, in the linear model.
  Point linear_point(const checker::Vector<checker::Interval>& at) const {
    const SpaceFormModel& model = sample.model;
    Point x{};
    for (std::size_t k = 0; k <= model.m; ++k) x[k] = middle(at[k]);
    if (model.K == 0) {
      for (std::size_t k = model.m; k > 0; --k) x[k] = middle(at[k - 1]) * model.frame[k - 1];
      x[0] = 1;
    }
    return x;
  }
  /// cosh of the distance of a point from the image of p'_j, or half its square.
  double measure_from(const Point& p, std::size_t j, const Isometry& g) const {
    const SpaceFormModel& model = sample.model;
    const Point y = image(model.m, g, linear_point(complex.point<checker::Interval>(static_cast<checker::Label>(j))));
    double result = model.K == 0 ? 0 : p[0] * y[0];
    for (std::size_t k = 1; k <= model.m; ++k)
      result += model.K == 0 ? (p[k] - y[k]) * (p[k] - y[k]) / 2 : -p[k] * y[k];
    return result;
  }
  /// Of p_i.
  double measure(std::size_t i, std::size_t j, const Isometry& g) const {
    return measure_from(linear_of(sample.model.K, sample.model.m, sample.model.net[i]), j, g);
  }

  const SpaceFormSample& sample;
  std::string text;
  checker::Certificate certificate;
  checker::core::Data data;
  checker::core::Complex complex;
};

TEST(Lifts, are_those_that_are_found_by_trying_all_elements) {
  const test::Upwards upwards;
  for (const auto& [sample, radius] : {std::pair(&klein_bottle(), 0.2), {&bolza_surface(), 0.45}}) {
    Read read(*sample);
    const SpaceFormModel& model = sample->model;
    checker::Lifts lifts(read.certificate, read.complex, true), far(read.certificate, read.complex, false);
    const checker::Rational reach = checker::Rational(static_cast<int>(radius * 1000)) / checker::Rational(1000);
    const double bound = model.K == 0 ? radius * radius / 2 : std::cosh(radius);
    std::size_t shown = 0;
    for (std::size_t i = 0; i < model.size(); i += 29) {
      std::multiset<std::size_t> expected, found, found_far;
      for (std::size_t j = 0; j < model.size(); ++j) {
        for (const Isometry& g : model.elements) {
          if (read.measure(i, j, g) <= bound) expected.insert(j);
        }
      }
      for (const checker::Seen& seen : lifts.around(static_cast<checker::Label>(i), reach)) found.insert(seen.label);
      for (const checker::Seen& seen : far.around(static_cast<checker::Label>(i), reach)) found_far.insert(seen.label);
      EXPECT_EQ(found, expected);
      EXPECT_EQ(found_far, expected);
      shown += found.size();
    }
    EXPECT_GT(shown, 20 * model.size() / 29);
  }
}

TEST(Lifts, near_a_circumcentre_are_those_that_are_found_by_trying_all_elements) {
  const test::Upwards upwards;
  for (const SpaceFormSample* sample : {&klein_bottle(), &bolza_surface()}) {
    Read read(*sample);
    const SpaceFormModel& model = sample->model;
    checker::Lifts lifts(read.certificate, read.complex, true);
    std::size_t shown = 0, none = 0;
    for (std::size_t s = 0; s < read.data.simplices(); s += 7) {
      const checker::core::Circumball<checker::Interval> ball(read.data, lifts.form<checker::Interval>(),
                                                              read.complex.lifts<checker::Interval>(s));
      std::vector<checker::Seen> vertices;
      std::multiset<std::size_t> corners;
      for (std::size_t k = 0; k < read.complex.vertices(); ++k) {
        vertices.push_back({read.complex.label(s, k), read.complex.element(s, k)});
        corners.insert(vertices.back().label);
      }
      const checker::Vector<checker::Interval> centre = ball.centre();
      const double chord =
          middle(lifts.form<checker::Interval>().squared(lifts.point<checker::Interval>(vertices[0]) - centre));
      for (const double factor : {1.001, 1.5, 4.0}) {
        const double squared = factor * chord, bound = model.K == 0 ? squared / 2 : 1 + squared / 2;
        std::multiset<std::size_t> expected, found = corners;
        for (std::size_t j = 0; j < model.size(); ++j) {
          for (const Isometry& g : model.elements) {
            if (read.measure_from(read.linear_point(centre), j, g) <= bound) expected.insert(j);
          }
        }
        for (const auto& near : lifts.around_circumcentre(centre, vertices, squared)) found.insert(near.seen.label);
        EXPECT_EQ(found, expected) << "simplex " << s << ", " << factor;
        shown += found.size() - corners.size();
        none += found == corners ? 1U : 0U;
      }
    }
    EXPECT_GT(shown, 100U);
    EXPECT_GT(none, 10U);
  }
}

/// The walk goes along edges only: without those of the first point it finds nothing but that.
TEST(Lifts, are_not_found_without_edges) {
  const test::Upwards upwards;
  Read read(klein_bottle());
  checker::Lifts lifts(read.certificate, read.complex, true);
  const checker::Rational reach = checker::Rational(1) / checker::Rational(5);
  EXPECT_GT(lifts.around(0, reach).size(), 20U);
  auto& [begin, items] = read.complex.neighbours;
  const std::uint64_t first = begin[1];
  items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] -= first;
  EXPECT_EQ(lifts.around(0, reach).size(), 1U);
}

/// While it lives, a chunk has all labels, and of all but one all simplices have been read.
class AllButOneRead {
 public:
  AllButOneRead(checker::Label size, checker::Label one) {
    checker::chunk_items.emplace();
    checker::chunk_items->whole.assign(size, true);
    if (one < size) checker::chunk_items->whole[one] = false;
  }
  ~AllButOneRead() { checker::chunk_items.reset(); }
  AllButOneRead(const AllButOneRead&) = delete;
  AllButOneRead& operator=(const AllButOneRead&) = delete;
};

/// A walk that comes to a label of which simplices are missing finds nothing, not less.
TEST(Lifts, of_a_chunk_need_all_simplices_that_the_walk_comes_to) {
  const test::Upwards upwards;
  Read read(klein_bottle());
  const checker::Label size = read.complex.size();
  checker::Lifts lifts(read.certificate, read.complex, true);
  const checker::Rational reach = checker::Rational(1) / checker::Rational(5);
  std::set<checker::Label> near;
  for (const checker::Seen& seen : lifts.around(0, reach)) near.insert(seen.label);
  const std::size_t found = lifts.around(0, reach).size();
  std::size_t thrown = 0;
  for (checker::Label one = 0; one <= size; ++one) {
    const AllButOneRead chunk(size, one);
    try {
      EXPECT_EQ(lifts.around(0, reach).size(), found);
      EXPECT_FALSE(near.contains(one)) << one;
    } catch (const checker::NotRead&) {
      ++thrown;
    }
  }
  EXPECT_GE(thrown, near.size());
  EXPECT_LT(thrown, size);
}

/// So do the points beside a simplex.
TEST(AroundSimplex, in_a_chunk_needs_all_simplices_of_its_vertices) {
  const test::Upwards upwards;
  Read read(klein_bottle());
  const checker::Label size = read.complex.size();
  checker::core::AroundSimplex around(read.complex);
  std::set<checker::Label> needed;
  for (checker::Label one = 0; one <= size; ++one) {
    const AllButOneRead chunk(size, one);
    try {
      around.visit(5, [](checker::Label, checker::core::Elements::Id) {});
    } catch (const checker::NotRead&) {
      needed.insert(one);
    }
  }
  std::set<checker::Label> vertices;
  for (std::size_t k = 0; k < read.complex.vertices(); ++k) vertices.insert(read.complex.label(5, k));
  EXPECT_EQ(needed, vertices);
}

}  // namespace
}  // namespace delcert::checker_tests
