#include "proofs/constants/riemannian_demand.hpp"

#include <gtest/gtest.h>

#include "proofs/constants/sphere_sample_size.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Rational ratio(long a, long b) { return Rational(a) / Rational(b); }

Ledger ledger_of(int dimension) { return constants_for(Dimension(dimension), Rational(1), ratio(1, 4)); }

TEST(RiemannianDemand, is_that_of_curvature_where_there_is_any) {
  for (const int curvature : {-1, 1}) {
    for (const int dimension : {2, 3}) {
      const Ledger ledger = ledger_of(dimension);
      const auto demand = riemannian_demand(ledger, {curvature, Rational(3), ratio(1, 10), 877});
      EXPECT_EQ(demand.printed_radius, ledger.riemannian_sampling_radius);
      EXPECT_EQ(demand.mended_radius, ledger.riemannian_sampling_radius);
      EXPECT_FALSE(demand.is_met);
    }
  }
}

TEST(RiemannianDemand, is_that_of_the_injectivity_radius_where_there_is_none) {
  const Ledger ledger = ledger_of(3);
  const auto coarse = riemannian_demand(ledger, {0, ratio(1, 2), ratio(1, 24), 1000});
  EXPECT_EQ(coarse.printed_radius, PowerProduct(ratio(1, 8)));
  EXPECT_EQ(coarse.mended_radius, PowerProduct(ratio(1, 40)));
  EXPECT_FALSE(coarse.is_met);
  EXPECT_TRUE(riemannian_demand(ledger, {0, ratio(1, 2), ratio(1, 40), 1000}).is_met);
  // 1000 balls of radius 1/48 are covered by no fewer of radius 1/8 than (1/48)³/(1/8)³ of 1000.
  EXPECT_EQ(coarse.least_points, PowerProduct(ratio(1000, 216)));
  EXPECT_FALSE(riemannian_demand(ledger, {0, Rational(21), ratio(1, 24), 1000}).printed_radius ==
               coarse.printed_radius);
}

/// Two ways: by the volume that the net itself shows, and by that of the unit sphere.
TEST(RiemannianDemand, of_a_sphere_is_no_more_than_its_volume_gives_and_not_much_less) {
  for (const int dimension : {2, 3}) {
    const Ledger ledger = ledger_of(dimension);
    const std::size_t points = dimension == 2 ? 877 : 15128;
    const auto demand = riemannian_demand(ledger, {1, Rational(3), ratio(1, 10), points});
    const auto sphere = sphere_sample_size(Dimension(dimension), ledger.riemannian_sampling_radius);
    EXPECT_LE(demand.least_points.log2().upper, sphere.at_least_log2.lower);
    EXPECT_GE(demand.least_points.log2().lower + Rational(3), sphere.at_least_log2.upper);
  }
}

TEST(RiemannianDemand, grows_with_the_points_of_the_net) {
  const Ledger ledger = ledger_of(2);
  const auto few = riemannian_demand(ledger, {-1, Rational(1), ratio(1, 10), 100});
  const auto many = riemannian_demand(ledger, {-1, Rational(1), ratio(1, 10), 200});
  EXPECT_EQ(many.least_points, few.least_points * PowerProduct(Rational(2)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
