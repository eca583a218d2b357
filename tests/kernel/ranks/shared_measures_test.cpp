#include "kernel/ranks/shared_measures.hpp"

#include <gtest/gtest.h>

#include "kernel/sample/separation.hpp"
#include "tests/kernel/ranks/sphere_in_parts.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
void compare(const WholeSphere<m>& whole, std::size_t count) {
  const auto parameters = measured_parameters(Dimension(m), 1);
  const auto geometry = geometry_of<m>(whole.atlas);
  const auto alone = run_in_charts<m>(whole.atlas, parameters, {}, no_progress());
  ASSERT_TRUE(alone.is_certified());
  const Rational separation = measure_separation<m>(whole.atlas);
  const auto stability = check_stability<m>(whole.atlas, alone.points, geometry, alone.complex, no_progress());
  const auto simplices =
      measure_riemannian_simplices<m>(whole.atlas, alone.points, geometry, alone.complex, no_progress());
  const auto flat = measure_piecewise_flat<m>(whole.atlas, alone.points, geometry, alone.complex,
                                              alone.model.circumradius, no_progress());
  run_ranks_in_threads(count, [&](Communicator& ranks) {
    const PartOfSphere<m> part(ranks, whole);
    const auto run = run_shared<m>(ranks, part.labels, part.atlas, geometry_of<m>(part.atlas), parameters, {}, nullptr,
                                   no_progress());
    EXPECT_EQ(shared_separation<m>(ranks, part.labels, part.atlas, no_progress()), separation);
    const auto shared = shared_stability<m>(ranks, part.labels, part.atlas, run, no_progress());
    EXPECT_EQ(shared.pairs, stability.pairs);
    EXPECT_EQ(shared.differing, stability.differing);
    EXPECT_EQ(shared.stars, stability.stars);
    EXPECT_EQ(shared.occupied, stability.occupied);
    EXPECT_EQ(shared.margins.reach, stability.margins.reach);
    const auto riemannian = shared_riemannian_simplices<m>(ranks, part.labels, part.atlas, run, no_progress());
    EXPECT_EQ(riemannian.thickness, simplices.thickness);
    EXPECT_EQ(riemannian.star_radius, simplices.star_radius);
    EXPECT_EQ(riemannian.scale, simplices.scale);
    EXPECT_EQ(riemannian.holds, simplices.holds);
    const auto metric = shared_piecewise_flat<m>(ranks, part.labels, part.atlas, run, no_progress());
    EXPECT_EQ(metric.hinges, flat.hinges);
    EXPECT_EQ(metric.unrealised, flat.unrealised);
    EXPECT_EQ(metric.not_delaunay, flat.not_delaunay);
    EXPECT_EQ(metric.undecided, flat.undecided);
    EXPECT_EQ(metric.least_weight, flat.least_weight);
    EXPECT_EQ(metric.lower, flat.lower);
    EXPECT_EQ(metric.upper, flat.upper);
    const ComplexCount found = shared_count<m>(ranks, part.labels, run.complex);
    EXPECT_EQ(found.simplices, alone.complex.simplices().size());
    EXPECT_EQ(found.euler_characteristic, alone.complex.euler_characteristic());
  });
}

TEST(SharedMeasures, are_those_of_one_process) {
  const WholeSphere<2> whole(ratio(1, 14));
  compare<2>(whole, 1);
  compare<2>(whole, 3);
}

TEST(SharedMeasures, on_the_3_sphere_are_those_of_one_process) { compare<3>(WholeSphere<3>(ratio(1, 5)), 2); }

/// Sides that do not come are hinges that are not counted.
TEST(SharedMeasures, miss_the_hinges_whose_sides_are_left_out) {
  const WholeSphere<2> whole(ratio(1, 14));
  run_ranks_in_threads(2, [&](Communicator& ranks) {
    const PartOfSphere<2> part(ranks, whole);
    const auto run = run_shared<2>(ranks, part.labels, part.atlas, geometry_of<2>(part.atlas),
                                   measured_parameters(Dimension(2), 1), {}, nullptr, no_progress());
    bool is_first = true;
    AlteredMessages altered(ranks, [&](std::size_t, auto& messages) {
      if (is_first) messages[1 - ranks.rank()].clear();
      is_first = false;
    });
    const auto all = shared_piecewise_flat<2>(ranks, part.labels, part.atlas, run, no_progress());
    EXPECT_LT(shared_piecewise_flat<2>(altered, part.labels, part.atlas, run, no_progress()).hinges, all.hinges);
  });
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
