#include "kernel/manifold/input_check.hpp"

#include "kernel/number/exact_text.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
std::vector<InputItem> items_of(const FlatSpace<m>& space, const ExactPoints<m>& points,
                                const Rational& sampling_radius, const Rational& separation,
                                const Rational& perturbation) {
  const FlatAtlas<m> atlas(space, PointSet<m>(points), sampling_radius);
  return check_input<m>(atlas, separation, perturbation);
}

const InputItem& item(const std::vector<InputItem>& items, const std::string& beginning) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const InputItem& candidate) { return candidate.name.rfind(beginning, 0) == 0; });
  EXPECT_NE(found, items.end()) << beginning;
  return *found;
}

bool all_proved(const std::vector<InputItem>& items) {
  return std::all_of(items.begin(), items.end(), [](const InputItem& one) { return is_proved(one.verdict); });
}

TEST(CheckInput, accepts_a_torus_whose_systole_is_exactly_24_sampling_radii) {
  const auto points = random_points<2>(5, 1);
  const Rational quarter = ratio(1, 4);
  EXPECT_TRUE(all_proved(items_of<2>(cubic_torus<2>(), points, ratio(1, 24), Rational(1), quarter)));
  EXPECT_TRUE(all_proved(items_of<2>(square_torus_in_a_long_basis(), points, ratio(1, 24), Rational(1), quarter)));
  EXPECT_TRUE(all_proved(items_of<3>(bcc_torus(), random_points<3>(5, 1), ratio(1, 24), Rational(1), quarter)));
}

TEST(CheckInput, refutes_patches_that_are_a_hair_too_large) {
  const Rational radius = ratio(1, 24) + Rational::power_of_two(-200);
  const auto items = items_of<2>(cubic_torus<2>(), random_points<2>(5, 1), radius, Rational(1), ratio(1, 4));
  for (const char* name : {"patches", "domains", "transitions"}) {
    EXPECT_EQ(item(items, name).verdict, Verdict::refuted) << name;
  }
  for (const char* name : {"separation", "density", "radius variation", "perturbation"}) {
    EXPECT_EQ(item(items, name).verdict, Verdict::proved) << name;
  }
  EXPECT_TRUE(mentions(item(items, "patches").detail, exact_text(square(Rational(24) * radius))));
  EXPECT_TRUE(mentions(item(items, "patches").detail, ": take a sampling radius of at most 1/24"));
}

TEST(CheckInput, advises_a_radius_that_is_not_refused) {
  const auto patches = [](const Rational& radius) {
    return item(items_of<3>(bcc_torus(), random_points<3>(5, 1), radius, Rational(1), ratio(1, 4)), "patches");
  };
  const std::string detail = patches(ratio(1, 2)).detail, words = "take a sampling radius of at most ";
  ASSERT_TRUE(mentions(detail, words));
  const Rational advised = parse_exact(detail.substr(detail.find(words) + words.size()));
  EXPECT_EQ(patches(advised).verdict, Verdict::proved);
  EXPECT_EQ(patches(advised * ratio(33, 32)).verdict, Verdict::refuted);
  EXPECT_FALSE(mentions(patches(advised).detail, words));
}

TEST(CheckInput, compares_the_perturbation_with_a_quarter_of_the_separation_exactly) {
  const auto points = random_points<2>(5, 1);
  const auto verdict = [&](const Rational& perturbation) {
    const auto items = items_of<2>(cubic_torus<2>(), points, ratio(1, 30), ratio(1, 3), perturbation);
    EXPECT_TRUE(mentions(item(items, "perturbation").detail, "1/12"));
    return item(items, "perturbation").verdict;
  };
  EXPECT_EQ(verdict(ratio(1, 12)), Verdict::proved);
  EXPECT_EQ(verdict(ratio(1, 12) + Rational::power_of_two(-100)), Verdict::refuted);
}

TEST(CheckInput, of_radii_that_vary_asks_for_wider_patches) {
  // b = 9·(1 + 1/3) = 12, 2b + 6 = 30.
  const auto points = random_points<2>(2, 1);
  const auto items_for = [&](const Rational& greatest, const Rational& variation, const Rational& perturbation) {
    const SamplingRadii radii = SamplingRadii(std::vector<double>{1, 0.75}).scaled_to(greatest);
    return check_input<2>(FlatAtlas<2>(cubic_torus<2>(), PointSet<2>(points), radii, variation), Rational(1),
                          perturbation);
  };
  EXPECT_TRUE(all_proved(items_for(ratio(1, 30), ratio(1, 3), ratio(3, 16))));
  const Rational hair = Rational::power_of_two(-100);
  EXPECT_EQ(item(items_for(ratio(1, 30) + hair, ratio(1, 3), ratio(3, 16)), "patches").verdict, Verdict::refuted);
  EXPECT_EQ(item(items_for(ratio(1, 30), ratio(1, 3), ratio(3, 16) + hair), "perturbation").verdict, Verdict::refuted);
  EXPECT_EQ(item(items_for(ratio(1, 60), Rational(1) + hair, ratio(1, 16)), "radius variation").verdict,
            Verdict::refuted);
  EXPECT_TRUE(
      mentions(item(items_for(ratio(1, 30), ratio(1, 3), ratio(3, 16)), "density").detail, "ε_i from 1/40 to 1/30"));
}

TEST(CheckInput, asks_a_ball_for_an_interior_label) {
  const ExactPoints<2> points{{Rational(0), Rational(0)}, {Rational(1), Rational(0)}};
  const auto small = items_of<2>(ball_of<2>(Rational(1)), points, ratio(1, 8), Rational(1), ratio(1, 4));
  EXPECT_TRUE(all_proved(small));
  EXPECT_TRUE(mentions(item(small, "patches").detail, "1 of 2"));
  const auto large = items_of<2>(ball_of<2>(Rational(1)), points, ratio(1, 7), Rational(1), ratio(1, 4));
  EXPECT_EQ(item(large, "patches").verdict, Verdict::refuted);
  EXPECT_TRUE(mentions(item(large, "patches").detail, "0 of 2"));
}

TEST(CheckInput, tells_the_measured_values) {
  const auto items = items_of<2>(cubic_torus<2>(), random_points<2>(5, 1), ratio(1, 31), ratio(7, 8), ratio(1, 5));
  EXPECT_EQ(items.size(), 7U);
  EXPECT_TRUE(mentions(item(items, "separation").detail, "7/8"));
  EXPECT_TRUE(mentions(item(items, "density").detail, "1/31"));
  EXPECT_TRUE(mentions(item(items, "perturbation").detail, "1/5"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
