// GUDHI's tangential complex with its fix of inconsistencies by perturbation, which together are the whole job that the
// certified run does, and certify nothing; beside that run, on the same net of a sphere, one thread:
//   tangential_complex sphere-2 1/84        (points on 𝕊² ⊂ ℝ³)
//   tangential_complex sphere-3 1/20        (points on 𝕊³ ⊂ ℝ⁴)
// Processor times. The net is not timed: both begin with it.

#include <CGAL/Epick_d.h>
#include <fmt/format.h>
#include <gudhi/Tangential_complex.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "support/error.hpp"

namespace delcert {
namespace {

/// Seconds that GUDHI's perturbation may take.
constexpr double longest_fix = 60;

class Clock {
 public:
  /// Seconds of this process since the last call, or the construction.
  double lap() {
    const std::clock_t now = std::clock();
    const double result = static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    last_ = now;
    return result;
  }

 private:
  std::clock_t last_ = std::clock();
};

template <int m>
using Tangential = Gudhi::tangential_complex::Tangential_complex<CGAL::Epick_d<CGAL::Dimension_tag<m + 1>>,
                                                                 CGAL::Dimension_tag<m>, CGAL::Sequential_tag>;

/// Of the net, in the linear model.
template <int m>
typename Tangential<m>::Points points_of(const SpaceFormAtlas<m>& atlas) {
  typename Tangential<m>::Points result;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    const auto x = model_point<Rational, m>(Curvature::positive, atlas.centre(Label(label)));
    std::array<double, static_cast<std::size_t>(m) + 1> rounded;
    for (std::size_t axis = 0; axis <= m; ++axis) rounded[axis] = approximate_double(x[axis]);
    result.emplace_back(rounded.begin(), rounded.end());
  }
  return result;
}

template <int m>
void compare(const SpaceForm& form, const Rational& radius) {
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, fitting_patch_factor(form, m, radius));
  const auto points = points_of<m>(atlas);
  Clock clock;
  double of_complex = 0;
  double of_fix = 0;
  std::size_t inconsistent = 0;
  std::string fixed;
  {
    Tangential<m> complex(points, m);
    complex.compute_tangential_complex();
    of_complex = clock.lap();
    inconsistent = complex.number_of_inconsistent_simplices(false).num_inconsistent_simplices;
    clock.lap();
    // As far as the certified run may move a point.
    const double most = approximate_double(measured_parameters(Dimension(m), 1).perturbation * radius);
    const auto info = complex.fix_inconsistencies_using_perturbation(most, longest_fix);
    of_fix = clock.lap();
    fixed = fmt::format("{} inconsistent stars before, {} after {} steps", info.initial_num_inconsistent_stars,
                        info.final_num_inconsistent_stars, info.num_steps);
  }
  const double theirs = of_complex + of_fix;
  fmt::print("| {}, {} points | s | ratio | |\n|---|--:|--:|---|\n", form.description.name, atlas.size());
  const auto line = [theirs](const char* what, double seconds, const std::string& remark) {
    fmt::print("| {} | {:.2f} | {:.2f} | {} |\n", what, seconds, seconds / theirs, remark);
  };
  line("tangential complex of the net, not certified", of_complex,
       fmt::format("{} inconsistent simplices", inconsistent));
  line("and its fix of inconsistencies", of_fix, fixed);
  line("both", theirs, "");
  clock.lap();
  RunRequest raw;
  raw.perturb = false;
  const auto parameters = measured_parameters(Dimension(m), 1);
  const auto before = run_in_charts<m>(atlas, parameters, raw, no_progress());
  line("stars of the net, each certified in its chart", clock.lap(),
       fmt::format("{} simplices missing in a star", before.agreement.missing));
  const auto run = run_in_charts<m>(atlas, parameters, {}, no_progress());
  line("perturbed, certified on levels 1, 2, 4", clock.lap(), run.is_certified() ? "certified" : "not certified");
  const auto stability = check_stability<m>(atlas, run.points, geometry_of(atlas), run.complex, no_progress());
  line("level 2s", clock.lap(), fmt::format("{} of {} pairs differ", stability.differing, stability.pairs));
}

void run(const std::string& name, const Rational& radius) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  if (form.form().curvature() != Curvature::positive || !form.description.generators.empty())
    throw InputError(name + " is not a sphere");
  if (form.form().dimension() == 2) {
    compare<2>(form, radius);
  } else {
    compare<3>(form, radius);
  }
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: tangential_complex sphere-2|sphere-3 RADIUS\n";
    return EXIT_FAILURE;
  }
  try {
    delcert::run(argv[1], delcert::parse_exact(argv[2]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
