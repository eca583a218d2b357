#include "kernel/theorems/piecewise_flat.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/kernel/stars/certified_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PiecewiseFlatReport report_of(const SphereSample& sample, const ChartComplex<2>& complex) {
  return measure_piecewise_flat<2>(sample.atlas, sample.run.points, unit_sphere, complex, sample.run.model.circumradius,
                                   no_progress());
}

double distance(const Vector<double, 3>& a, const Vector<double, 3>& b) {
  const auto step = difference(a, b);
  return 2 * std::asin(std::sqrt(pairing(step, step)) / 2);
}

/// The cotangent of the angle opposite the side c.
double cotangent(double a, double b, double c) {
  const double s = (a + b + c) / 2;
  return (a * a + b * b - c * c) / (4 * std::sqrt(s * (s - a) * (s - b) * (s - c)));
}

TEST(MeasurePiecewiseFlat, of_a_certified_sphere_is_self_delaunay_by_its_cotangents) {
  const auto sample = perturbed_sphere();
  const auto report = report_of(sample, sample.run.complex);
  EXPECT_TRUE(report.is_self_delaunay());
  EXPECT_EQ(report.hinges, 3 * sample.atlas.size() - 6);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> sums;
  for (const auto& triangle : sample.run.complex.simplices()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& a = sample.places[triangle[k]];
      const auto& b = sample.places[triangle[(k + 1) % 3]];
      const auto& c = sample.places[triangle[(k + 2) % 3]];
      const double side = distance(b, c);
      const auto edge = std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
      sums[edge] += cotangent(distance(a, b), distance(a, c), side);
    }
  }
  double least = 1;
  for (const auto& [edge, sum] : sums) least = std::min(least, sum);
  EXPECT_GT(least, 0);
  EXPECT_NEAR(report.least_weight, least, 1e-10);
  EXPECT_LE(report.least_weight, least + 1e-12);
}

TEST(MeasurePiecewiseFlat, counts_a_flipped_edge) {
  const auto sample = perturbed_sphere();
  const auto triangles = sample.run.complex.simplices();
  // The first triangle and its neighbour across the edge of its two smallest labels.
  const auto first = triangles.front();
  LabelSimplex<2> second{};
  for (const auto& other : triangles) {
    if (other != first && std::find(other.begin(), other.end(), first[0]) != other.end() &&
        std::find(other.begin(), other.end(), first[1]) != other.end()) {
      second = other;
    }
  }
  std::uint32_t across = second[0];
  for (const std::uint32_t label : second) across = label == first[0] || label == first[1] ? across : label;
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t i = 0; i < sample.atlas.size(); ++i) stars.push_back({Label(i), {}});
  const auto add = [&](LabelSimplex<2> triangle) {
    std::sort(triangle.begin(), triangle.end());
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<std::uint32_t, 2> others{triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
      std::sort(others.begin(), others.end());
      stars[triangle[k]].simplices.push_back({Sighting<2>{others[0], {}}, Sighting<2>{others[1], {}}});
    }
  };
  for (const auto& triangle : triangles) {
    if (triangle != first && triangle != second) add(triangle);
  }
  add({first[0], first[2], across});
  add({first[1], first[2], across});
  for (auto& star : stars) std::sort(star.simplices.begin(), star.simplices.end());
  const ChartComplex<2> flipped(std::move(stars), std::vector<bool>(sample.atlas.size(), true));
  ASSERT_TRUE(flipped.agreement().failures.empty());
  const auto report = report_of(sample, flipped);
  EXPECT_GE(report.not_delaunay, 1U);
  EXPECT_FALSE(report.is_self_delaunay());
  EXPECT_LT(report.least_weight, 0);
}

TEST(MeasurePiecewiseFlat, bounds_how_the_natural_map_stretches) {
  const auto sample = perturbed_sphere();
  const auto report = report_of(sample, sample.run.complex);
  ASSERT_GT(report.lower, 0.9);
  ASSERT_LT(report.lower, 1);
  ASSERT_GT(report.upper, 1);
  ASSERT_LT(report.upper, 1.1);
  // Short steps inside of flat triangles, and how long they are on the sphere.
  double least = 2;
  double greatest = 0;
  for (const auto& triangle : sample.run.complex.simplices()) {
    const auto& a = sample.places[triangle[0]];
    const auto& b = sample.places[triangle[1]];
    const auto& c = sample.places[triangle[2]];
    const double ab = distance(a, b);
    const double ac = distance(a, c);
    const double bc = distance(b, c);
    const double inner = (ab * ab + ac * ac - bc * bc) / 2;
    const auto place = [&](double s, double t) {
      const auto x = sum(sum(scaled(1 - s - t, a), scaled(s, b)), scaled(t, c));
      return scaled(1 / std::sqrt(pairing(x, x)), x);
    };
    for (int corner = 0; corner < 4; ++corner) {
      const double s = corner == 1 ? 0.98 : corner == 3 ? 0.33 : 0.005;
      const double t = corner == 2 ? 0.98 : corner == 3 ? 0.33 : 0.005;
      for (int direction = 0; direction < 8; ++direction) {
        const double ds = 1e-4 * std::cos(direction * 0.4);
        const double dt = 1e-4 * std::sin(direction * 0.4);
        const double flat = std::sqrt(ds * ds * ab * ab + 2 * ds * dt * inner + dt * dt * ac * ac);
        const double factor = distance(place(s, t), place(s + ds, t + dt)) / flat;
        least = std::min(least, factor);
        greatest = std::max(greatest, factor);
      }
    }
  }
  EXPECT_LE(report.lower, least + 1e-6);
  EXPECT_GE(report.upper, greatest - 1e-6);
  // And not much more than that.
  EXPECT_GE(report.lower, 1 - 3 * (1 - least));
  EXPECT_LE(report.upper, 1 + 3 * (greatest - 1));
}

/// The least factor by which squares of lengths differ in a triangle of chords and the flat one with the arcs for
/// edges.
double least_squared_factor(const Vector<double, 3>& a, const Vector<double, 3>& b, const Vector<double, 3>& c) {
  const auto gram = [](double ab, double ac, double bc) {
    return std::array{ab * ab, (ab * ab + ac * ac - bc * bc) / 2, ac * ac};
  };
  const auto chord = [](const auto& p, const auto& q) { return 2 * std::sin(distance(p, q) / 2); };
  const auto flat = gram(distance(a, b), distance(a, c), distance(b, c));
  const auto chords = gram(chord(a, b), chord(a, c), chord(b, c));
  // det(chords − λ·flat) = 0.
  const double two = flat[0] * flat[2] - flat[1] * flat[1];
  const double one = chords[0] * flat[2] + chords[2] * flat[0] - 2 * chords[1] * flat[1];
  const double none = chords[0] * chords[2] - chords[1] * chords[1];
  return (one - std::sqrt(one * one - 4 * two * none)) / (2 * two);
}

TEST(MeasurePiecewiseFlat, bounds_chords_by_the_first_step_of_its_list_that_is_one) {
  const auto sample = perturbed_sphere();
  double least = 1;
  for (const auto& triangle : sample.run.complex.simplices()) {
    least = std::min(least, least_squared_factor(sample.places[triangle[0]], sample.places[triangle[1]],
                                                 sample.places[triangle[2]]));
  }
  const auto measured = measure_flat_simplices<2>(sample.atlas, sample.run.points, unit_sphere, sample.run.complex,
                                                  all_labels_of(sample.run.complex), no_progress());
  // With balls so small that nothing else counts.
  const auto report = piecewise_flat_report(measured.stretch, measured.hinges, Curvature::positive, 0x1p-40);
  const double squared = report.lower * report.lower;
  EXPECT_LE(squared, least + 1e-12);
  // Steps are at most a quarter wide.
  EXPECT_GE(squared, 1 - 1.26 * (1 - least));
}

TEST(MeasurePiecewiseFlat, by_parts_leaves_sides_between_them) {
  const auto sample = perturbed_sphere();
  const auto measured = [&](LabelRange labels) {
    return measure_flat_simplices<2>(sample.atlas, sample.run.points, unit_sphere, sample.run.complex, labels,
                                     no_progress());
  };
  const LabelRange all = all_labels_of(sample.run.complex);
  const auto whole = measured(all);
  EXPECT_TRUE(whole.sides.empty());
  EXPECT_EQ(2 * whole.hinges.hinges, 3 * sample.run.complex.simplices().size());
  HingeCount hinges;
  std::vector<FlatSide<2>> sides;
  for (const LabelRange part : {LabelRange{0, all.last / 3}, LabelRange{all.last / 3, all.last}}) {
    const auto found = measured(part);
    EXPECT_FALSE(found.sides.empty());
    hinges.include(found.hinges);
    sides.insert(sides.end(), found.sides.begin(), found.sides.end());
  }
  EXPECT_LT(hinges.hinges, whole.hinges.hinges) << "without those between them";
  hinges.include(count_hinges<2>(std::move(sides)));
  EXPECT_EQ(hinges.hinges, whole.hinges.hinges);
  EXPECT_EQ(hinges.not_delaunay + hinges.undecided, 0U);
  EXPECT_EQ(hinges.least_weight, whole.hinges.least_weight);
}

TEST(MeasurePiecewiseFlat, of_a_flat_torus_is_the_metric_itself) {
  const auto sample = perturbed_torus();
  const auto report = measure_piecewise_flat<2>(sample.atlas, sample.run.points, unit_torus, sample.run.complex,
                                                sample.run.model.circumradius, no_progress());
  EXPECT_EQ(report.lower, 1);
  EXPECT_EQ(report.upper, 1);
  EXPECT_TRUE(report.is_self_delaunay());
  EXPECT_EQ(report.hinges, sample.run.complex.label_complex().count(1));
}

TEST(MeasurePiecewiseFlat, notices_that_a_sliver_has_no_flat_likeness) {
  // Four points around a great circle of a great sphere, nearly: their flat tetrahedron would be more than flat.
  const CurvedPatch<3> atlas(Curvature::positive, std::vector<Vector<Rational, 3>>(4), ratio(1, 4));
  const auto report_at_height = [&](const Rational& height) {
    const ExactPoints<3> points{{ratio(1, 4), Rational(0), height},
                                {ratio(-1, 4), Rational(0), height},
                                {Rational(0), ratio(1, 4), -height},
                                {Rational(0), ratio(-1, 4), -height}};
    std::vector<ChartStar<3>> stars;
    for (std::uint32_t label = 0; label < 4; ++label) stars.push_back({Label(label), {}});
    stars[0].simplices = {{Sighting<3>{1, {}}, Sighting<3>{2, {}}, Sighting<3>{3, {}}}};
    const ChartComplex<3> complex(std::move(stars), std::vector<bool>(4, true));
    return measure_piecewise_flat<3>(atlas, PointSet<3>(points), unit_sphere, complex, 0.3, no_progress());
  };
  const auto sliver = report_at_height(ratio(1, 100));
  EXPECT_EQ(sliver.unrealised, 1U);
  EXPECT_EQ(sliver.upper, 0);
  EXPECT_FALSE(sliver.is_self_delaunay());
  const auto thick = report_at_height(ratio(1, 8));
  EXPECT_EQ(thick.unrealised, 0U);
  EXPECT_GT(thick.upper, 1);
  EXPECT_LT(thick.upper, 1.3);
}

TEST(MeasurePiecewiseFlat, of_nothing_claims_nothing) {
  const auto sample = perturbed_torus();
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t i = 0; i < sample.atlas.size(); ++i) stars.push_back({Label(i), {}});
  const ChartComplex<2> empty(std::move(stars), std::vector<bool>(sample.atlas.size(), true));
  const auto report = measure_piecewise_flat<2>(sample.atlas, sample.run.points, unit_torus, empty, 0.1, no_progress());
  EXPECT_FALSE(report.is_self_delaunay());
  EXPECT_EQ(report.lower, 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
