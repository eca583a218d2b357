#include "proofs/certification/net_source.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/any_manifold.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

FlatSpace<2> square_torus() { return flat_space_of<2>(std::get<ManifoldDescription>(find_any_manifold("torus-2"))); }

std::string refusal_of(const NetSource& source) {
  try {
    (void)source.net<2>(square_torus(), no_progress());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(NetSource, a_lattice_has_its_points) {
  NetSource source;
  source.lattice = 5;
  EXPECT_EQ(source.net<2>(square_torus(), no_progress()).points.size(), 25U);
  source.centred = true;
  EXPECT_EQ(source.net<2>(square_torus(), no_progress()).points.size(), 50U);
}

TEST(NetSource, a_torus_that_is_sampled_comes_with_its_triangulation_and_what_may_be_cospherical_without) {
  NetSource source;
  source.radius = Rational(1, 10);
  const auto sampled = source.net<2>(square_torus(), no_progress());
  EXPECT_EQ(sampled.simplices.size(), 2 * sampled.points.size());
  source.lattice = 5;
  EXPECT_TRUE(source.net<2>(square_torus(), no_progress()).simplices.empty());
}

TEST(NetSource, a_file_has_its_points_exactly) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "net.txt", "1/3 0\n1/2 0x1p-7\n");
  NetSource source;
  source.points_file = (folder / "net.txt").string();
  const auto points = source.net<2>(square_torus(), no_progress()).points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0][0], Rational(1, 3));
  EXPECT_EQ(points[1][1], Rational(1, 128));
}

TEST(NetSource, what_a_flat_torus_does_not_have_is_refused) {
  NetSource source;
  EXPECT_NE(refusal_of(source).find("no net"), std::string::npos);
  source.radius = Rational(-1);
  EXPECT_NE(refusal_of(source).find("not above 0"), std::string::npos);
  source.radius = Rational(1, 4);
  EXPECT_EQ(refusal_of(source), "no refusal");
  source.relaxation_steps = 1;
  EXPECT_NE(refusal_of(source).find("--relax"), std::string::npos);
  source.icosphere_frequency = 2;
  EXPECT_NE(refusal_of(source).find("--icosphere"), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
