#include "kernel/sample/space_form_domain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/manifold/space_form_file.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
void expect_nearest_lifts(const std::string& name) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  const SpaceFormDomain<m> domain(form, 0.3);
  const Curvature curvature = domain.curvature();
  const auto metric = chart_metric<m>(form.form()).template on<PlainDouble>();
  ModelPoint<PlainDouble, m> origin{};
  origin[0] = PlainDouble(1);
  const auto squared = [&](const ModelPoint<PlainDouble, m>& x) {
    return squared_chord<PlainDouble, m>(curvature, metric, origin, x).lower();
  };
  for (std::uint32_t label = 0; label < 60; ++label) {
    CounterRandom random(1, RandomPurpose::darts, label, 0);
    const auto coordinates = domain.random_point(random);
    for (const double coordinate : coordinates) EXPECT_EQ(coordinate * 0x1p48, std::nearbyint(coordinate * 0x1p48));
    const auto x = domain.point(coordinates);
    for (std::uint32_t number = 0; number < domain.lifts().table().size(); ++number) {
      const auto other = applied(domain.matrix(number), x);
      EXPECT_GE(squared(other), squared(x) - 1e-9);
      // Every lift of the point is taken back to it, but where it is on the border.
      const auto back = domain.reduced(other);
      EXPECT_NEAR(squared(domain.point(back)), squared(x), 1e-6);
    }
  }
}

TEST(SpaceFormDomain, has_the_lifts_nearest_to_the_origin) {
  expect_nearest_lifts<2>("projective-plane");
  expect_nearest_lifts<2>("bolza-surface");
  expect_nearest_lifts<2>("klein-bottle");
  expect_nearest_lifts<3>("hantzsche-wendt");
  expect_nearest_lifts<3>("quaternion-space");
}

TEST(SpaceFormDomain, covers_a_sphere_about_uniformly) {
  const SpaceFormDomain<2> domain(verify_space_form(find_space_form("sphere-2")), 0.3);
  // By height in ten slices of equal area.
  std::array<int, 10> slices{};
  constexpr int count = 5000;
  for (std::uint32_t label = 0; label < count; ++label) {
    CounterRandom random(1, RandomPurpose::darts, label, 0);
    const auto x = domain.point(domain.random_point(random));
    ++slices[static_cast<std::size_t>((x[0].lower() + 1) * 4.999)];
  }
  for (const int slice : slices) EXPECT_NEAR(slice, count / 10, 100);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
