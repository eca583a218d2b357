#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {
namespace {

const std::set<std::string> all_levels = {"0", "1", "2", "2s", "3", "4", "5", "6"};

Sample sample(Model model, std::set<std::string> levels, bool theory = false, int measured = 1 << 30) {
  const Margins margins = roomy(measure(model, measured));
  return {std::move(model), {std::move(levels), margins, theory}};
}

}  // namespace

const Sample& wide_torus() {
  static const Sample result = sample(kuhn_torus(2, 28, 1.9, 0.01, 1), all_levels);
  return result;
}

const Sample& narrow_torus() {
  static const Sample result = sample(kuhn_torus(2, 14, 1.005, 0.01, 2), all_levels, true);
  return result;
}

const Sample& skewed_torus() {
  static const Sample result = [] {
    Sample skewed = wide_torus();
    skewed.model = in_basis(skewed.model, {{1, 7}, {2, 15}}, {{15, -7}, {-2, 1}});
    return skewed;
  }();
  return result;
}

const Sample& circle() {
  static const Sample result = sample(kuhn_torus(1, 30, 2 / 1.95, 0.01, 3), all_levels);
  return result;
}

const Sample& cubic_torus() {
  // A hundredth of the spacing moves no margin by half.
  static const Sample result = sample(kuhn_torus(3, 16, 1.01, 0.01, 4), all_levels, false, 50);
  return result;
}

const Sample& disc() {
  static const Sample result = sample(staggered_disc(20, 0.01, 5), {"0", "1", "2", "2s", "3", "4"});
  return result;
}

const Sample& four_torus() {
  static const Sample result = sample(kuhn_torus(4, 4, 1.1, 0.01, 6), {"1", "2", "4", "5", "6"});
  return result;
}

}  // namespace delcert::checker_tests
