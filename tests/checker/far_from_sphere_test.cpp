#include "proofs/checker/levels/far_from_sphere.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "proofs/checker/geometry/simplex.hpp"
#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

struct FarFromSphereOfChecker : testing::Test, test::Upwards {};

Rational fraction(long numerator, long denominator) {
  Rational result;
  fmpq_set_si(result.raw(), numerator, static_cast<ulong>(denominator));
  return result;
}

/// Points in a frame of dimension m that is skewed where `skewed`, some of them on a raster, some nearly, some with
/// all digits or with coordinates that are no doubles. They are often near a flat of dimension m - 2, so that errors
/// grow.
struct Points {
  Points(std::mt19937_64& random, std::size_t m, std::size_t number, bool skewed) {
    std::vector<Rational> gram;
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < m; ++k) gram.push_back(i == k ? Rational(1) : skewed ? fraction(1, 3) : Rational(0));
    }
    metric = Metric(static_cast<int>(m), gram);
    const bool thin = random() % 2 == 0;
    for (std::size_t i = 0; i < number; ++i) {
      const auto kind = random() % 4;
      for (std::size_t k = 0; k < m; ++k) {
        const long raster = static_cast<long>(random() % 9) - 4, scale = thin && k + 2 >= m ? 1L << 6 : 1;
        if (kind == 0) {
          texts.push_back(std::to_string(raster) + "/" + std::to_string(3 * scale));
        } else {
          // A raster, shifted by up to 2^-50 where it is only nearly one.
          const long shift = kind == 1 ? static_cast<long>(random() % 5) - 2 : 0;
          const long digits = static_cast<long>(random() % (1UL << 53)) - (1L << 52);
          const long numerator = (kind == 3 ? digits : raster * (1L << 50)) / scale + shift;
          texts.push_back(std::to_string(numerator) + "/" + std::to_string(1L << 50));
        }
      }
    }
    for (const std::string& text : texts) views.push_back(text);
    set = PointSet(metric, false, views);
  }
  Points(const Points&) = delete;
  Points& operator=(const Points&) = delete;
  Metric metric;
  std::vector<std::string> texts;
  std::vector<std::string_view> views;
  PointSet set;
};

Rational absolute(const Rational& x) { return x.sign() < 0 ? -x : x; }

/// What is said of all simplices that are met, compared with exact ones.
class Comparison {
 public:
  Comparison(const Points& points, std::size_t m, double too_large) : points_(points), m_(m), too_large_(too_large) {}

  template <class Seen>
  void go_on(const Seen& seen, const Vertices& vertices, const SeenFromVertex& near) {
    if (vertices.size() > m_) return;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      SeenFromSimplex next;
      next.choose(i, seen.size(), [](std::size_t) { return true; });
      Vertices longer = vertices;
      longer.push_back(near.vertex(seen.number(i)));
      const Simplex<Rational> exact_simplex(points_.metric, points_.set.positions<Rational>(longer));
      const AddedVertex vertex(seen, i);
      if (vertex.least_radius_squared() >= too_large_) {
        ++too_large_or_degenerate;
        EXPECT_TRUE(exact_simplex.complete != Verdict::proved ||
                    less(exact_simplex.radius_squared, exact(too_large_)) != Verdict::proved);
        continue;
      }
      next.see(seen, vertex);
      next.multiply(seen, vertex);
      for (std::size_t k = 0; k < next.size(); ++k) {
        // The bound for one point is not greater than that for all.
        for (const double small : {0.0, 0x1p-50}) EXPECT_TRUE(vertex.is_far(i + 1 + k, small) || !next.are_far(small));
      }
      if (exact_simplex.complete != Verdict::proved) {
        EXPECT_TRUE(std::isinf(next.error()));
        for (std::size_t k = i + 1; k < seen.size(); ++k) EXPECT_FALSE(vertex.is_far(k, 0));
        ++degenerate;
      } else {
        compare(next, exact_simplex, near, longer[0],
                [&](std::size_t k, double small) { return vertex.is_far(i + 1 + k, small); });
      }
      EXPECT_TRUE(next.size() == 0 || !next.are_far(0) || std::isfinite(next.error()));
      go_on(next, longer, near);
    }
  }

  int too_large_or_degenerate = 0, degenerate = 0, far = 0, open = 0, needed = 0, all_far = 0,
      all_but_for_the_bound = 0;

 private:
  template <class IsFar>
  void compare(const SeenFromSimplex& seen, const Simplex<Rational>& simplex, const SeenFromVertex& near,
               const Vertex& origin, const IsFar& is_seen_far) {
    EXPECT_NE(less(simplex.radius_squared, exact(seen.least_radius_squared())), Verdict::proved);
    if (std::isfinite(seen.error())) {
      EXPECT_NE(less(exact(seen.greatest_radius_squared()), simplex.radius_squared), Verdict::proved);
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const Vertex& q = near.vertex(seen.number(k));
      const Rational power = simplex.power(points_.set.position<Rational>(q) - points_.set.position<Rational>(origin));
      if (std::isfinite(seen.error())) {
        EXPECT_NE(less(exact(seen.error()), absolute(exact(seen.power(k)) - power)), Verdict::proved);
      }
      for (const double small : {0.0, 0x1p-50, enclosure(absolute(power)).upper()}) {
        const bool is_far = less(exact(small), absolute(power)) == Verdict::proved, found = is_seen_far(k, small);
        EXPECT_TRUE(is_far || !(found || seen.are_far(small)));
        all_far += seen.are_far(small) ? 1 : 0;
        all_but_for_the_bound += !is_far && seen.are_far(small - seen.error()) ? 1 : 0;
        far += found ? 1 : 0;
        open += is_far && !found ? 1 : 0;
        needed += !is_far && std::fabs(seen.power(k)) > small ? 1 : 0;
      }
    }
  }

  const Points& points_;
  std::size_t m_;
  double too_large_;
};

TEST_F(FarFromSphereOfChecker, calls_no_point_far_that_is_not) {
  std::mt19937_64 random(1);
  int too_large_or_degenerate = 0, degenerate = 0, far = 0, open = 0, needed = 0, all_far = 0, all_but = 0;
  for (int k = 0; k < 600; ++k) {
    const std::size_t m = 1 + random() % 4;
    const Points points(random, m, m == 4 ? 7 : 6, random() % 2 == 0);
    SeenFromVertex near(points.set);
    near.open({0, {}}, 0x1p10);
    for (Label i = 1; i < points.set.size(); ++i) near.add({i, {}});
    near.close();
    ASSERT_EQ(near.size(), points.set.size() - 1);
    Comparison comparison(points, m, k % 2 == 0 ? 100 : 0x1p30);
    comparison.go_on(near, {{0, {}}}, near);
    too_large_or_degenerate += comparison.too_large_or_degenerate;
    degenerate += comparison.degenerate;
    far += comparison.far;
    open += comparison.open;
    needed += comparison.needed;
    all_far += comparison.all_far;
    all_but += comparison.all_but_for_the_bound;
  }
  std::printf("%d too large, %d degenerate; %d far, %d left open, %d only by the bound; %d all, %d all but for it\n",
              too_large_or_degenerate, degenerate, far, open, needed, all_far, all_but);
  EXPECT_GT(too_large_or_degenerate, 100);
  EXPECT_GT(degenerate, 20);
  EXPECT_GT(far, 10000);
  EXPECT_GT(open, 100);
  EXPECT_GT(needed, 100) << "the bound is never needed";
  EXPECT_GT(all_far, 1000);
  EXPECT_GT(all_but, 10) << "the bound for all is never needed";
}

TEST_F(FarFromSphereOfChecker, leaves_out_only_what_is_too_far) {
  std::mt19937_64 random(2);
  int left_out = 0, apart = 0, nearly = 0;
  for (int k = 0; k < 2000; ++k) {
    const std::size_t m = 1 + random() % 4;
    const Points points(random, m, 8, random() % 2 == 0);
    // Often just the distance of one of them.
    const Rational squared = points.set.between<Rational>({0, {}}, {1, {}});
    const double longest = enclosure(squared + fraction(static_cast<long>(random() % 3) - 1, 1L << 45)).upper();
    if (!(longest > 0)) continue;
    SeenFromVertex near(points.set);
    near.open({0, {}}, longest);
    for (Label i = 1; i < points.set.size(); ++i) {
      const std::size_t before = near.size();
      near.add({i, {}});
      const bool is_too_far = less(exact(longest), points.set.between<Rational>({0, {}}, {i, {}})) == Verdict::proved;
      EXPECT_TRUE(is_too_far || near.size() > before);
      left_out += near.size() == before ? 1 : 0;
      nearly += is_too_far && near.size() > before ? 1 : 0;
    }
    near.close();
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) {
        const Rational distance = points.set.between<Rational>(near.vertex(i), near.vertex(j));
        const bool found = near.are_apart(i, j);
        EXPECT_TRUE(!found || less(exact(longest), distance) == Verdict::proved);
        apart += found ? 1 : 0;
      }
    }
  }
  EXPECT_GT(left_out, 1000);
  EXPECT_GT(apart, 1000);
  EXPECT_GT(nearly, 10) << "the bound is never needed";
}

TEST_F(FarFromSphereOfChecker, leaves_open_what_is_not_bounded) {
  const Metric line(1, {});
  // Beyond the doubles; so large that squares are; so large that differences lose all digits.
  for (const std::string_view large : {"0x1p1100", "0x1p600", "0x1p60"}) {
    const std::vector<std::string_view> texts{large, "1", "2", "3"};
    const PointSet points(line, false, texts);
    for (const Label first : {Label{0}, Label{1}}) {
      SeenFromVertex near(points);
      near.open({first, {}}, 16);
      for (Label i = 0; i < 4; ++i) {
        if (i != first) near.add({i, {}});
      }
      near.close();
      if (first == 1 && near.error() < 1) {  // here what is far has no part in it
        EXPECT_EQ(near.size(), 2);
        continue;
      }
      ASSERT_EQ(near.size(), 3) << large;
      EXPECT_FALSE(near.are_apart(0, 1));
      const AddedVertex vertex(near, 0);
      EXPECT_FALSE(vertex.least_radius_squared() >= 1);
      EXPECT_FALSE(vertex.is_far(1, 0));
      EXPECT_FALSE(vertex.is_far(2, 0));
      SeenFromSimplex others;
      others.choose(0, 3, [](std::size_t) { return true; });
      others.see(near, vertex);
      EXPECT_FALSE(others.are_far(0));
    }
  }
}

}  // namespace
}  // namespace delcert::checker_tests
