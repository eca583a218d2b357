// GUDHI's tangential complex with its fix of inconsistencies by perturbation, which together are the whole job that the
// certified run does, and certify nothing; compared with that run on the same net of a sphere or of a built-in zero set
// of dimension 3, one thread:
//   tangential_complex sphere-2 1/84        (points on 𝕊² ⊂ ℝ³)
//   tangential_complex sphere-3 1/20        (points on 𝕊³ ⊂ ℝ⁴)
//   tangential_complex torus-3-in-r6 1/7    (points on 𝕋³ ⊂ ℝ⁶)
// Processor times. The net is not timed: both begin with it.

#include <CGAL/Epick_d.h>
#include <fmt/format.h>
#include <gudhi/Tangential_complex.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/manifold/submanifold_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/sample/submanifold_net.hpp"
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

/// In ℝᴺ, of dimension m.
template <int N, int m>
using Tangential = Gudhi::tangential_complex::Tangential_complex<CGAL::Epick_d<CGAL::Dimension_tag<N>>,
                                                                 CGAL::Dimension_tag<m>, CGAL::Sequential_tag>;

/// Coordinates in ℝᴺ.
template <int N>
using Place = std::array<double, static_cast<std::size_t>(N)>;

/// Of GUDHI.
struct Theirs {
  double of_complex = 0;
  double of_fix = 0;
  std::size_t simplices = 0;  ///< inconsistent ones, before the fix
  std::size_t stars = 0;      ///< inconsistent ones, before the fix
  std::size_t left = 0;       ///< and after it
  unsigned steps = 0;
};

/// `most`: how far a point may be moved.
template <int N, int m>
Theirs tangential(const std::vector<Place<N>>& places, double most) {
  typename Tangential<N, m>::Points points;
  for (const auto& place : places) points.emplace_back(place.begin(), place.end());
  Theirs result;
  Clock clock;
  Tangential<N, m> complex(points, m);
  complex.compute_tangential_complex();
  result.of_complex = clock.lap();
  result.simplices = complex.number_of_inconsistent_simplices(false).num_inconsistent_simplices;
  clock.lap();
  const auto info = complex.fix_inconsistencies_using_perturbation(most, longest_fix);
  result.of_fix = clock.lap();
  result.stars = info.initial_num_inconsistent_stars;
  result.left = info.final_num_inconsistent_stars;
  result.steps = info.num_steps;
  return result;
}

/// Stars that are not certified or do not agree with others.
template <int m>
std::size_t bad_stars(const ChartRun<m>& run) {
  std::set<std::uint32_t> labels;
  for (const Label label : run.agreement.labels) labels.insert(label.value);
  for (const StarFailure& failure : run.star_failures) labels.insert(failure.label.value);
  return labels.size();
}

/// Which levels the whole job is compared on: of spheres also the geodesic circumballs and the stars in other charts.
enum class Levels : unsigned char { stars_and_manifold, of_spheres };

template <int N, int m>
void compare(const std::string& name, const Atlas<m>& atlas, const ModelGeometry& geometry, const Rational& radius,
             const std::vector<Place<N>>& places, Levels levels) {
  const auto parameters = measured_parameters(Dimension(m), 1);
  const Theirs theirs = tangential<N, m>(places, approximate_double(parameters.perturbation * radius));
  const double both = theirs.of_complex + theirs.of_fix;
  fmt::print("| {}, {} points | s | ratio | |\n|---|--:|--:|---|\n", name, atlas.size());
  const auto line = [both](const char* what, double seconds, const std::string& remark) {
    fmt::print("| {} | {:.2f} | {:.2f} | {} |\n", what, seconds, seconds / both, remark);
  };
  line("tangential complex of the net, not certified", theirs.of_complex,
       fmt::format("{} inconsistent simplices", theirs.simplices));
  line("and its fix of inconsistencies", theirs.of_fix,
       fmt::format("{} inconsistent stars before, {} after {} steps", theirs.stars, theirs.left, theirs.steps));
  line("both", both, "");
  Clock clock;
  RunRequest raw;
  raw.perturb = false;
  const auto before = run_in_charts<m>(atlas, geometry, parameters, raw, no_progress());
  line("stars of the net, each certified in its chart", clock.lap(),
       fmt::format("{} simplices missing in a star, {} inconsistent stars", before.agreement.missing,
                   bad_stars<m>(before)));
  const auto run = run_in_charts<m>(atlas, geometry, parameters, {}, no_progress());
  const bool is_certified = levels == Levels::of_spheres ? run.is_certified() : bad_stars<m>(run) == 0;
  line(levels == Levels::of_spheres ? "perturbed, certified on levels 1, 2, 4" : "perturbed, certified on levels 1, 2",
       clock.lap(),
       fmt::format("{}, {} inconsistent stars", is_certified ? "certified" : "not certified", bad_stars<m>(run)));
  if (levels == Levels::stars_and_manifold) return;
  const auto stability = check_stability<m>(atlas, run.points, geometry, run.complex, no_progress());
  line("level 2s", clock.lap(), fmt::format("{} of {} pairs differ", stability.differing, stability.pairs));
}

/// The net in the linear model.
template <int m>
void compare_sphere(const SpaceForm& form, const Rational& radius) {
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, fitting_patch_factor(form, m, radius));
  std::vector<Place<m + 1>> places(atlas.size());
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    const auto x = model_point<Rational, m>(Curvature::positive, atlas.centre(Label(label)));
    for (std::size_t axis = 0; axis <= m; ++axis) places[label][axis] = approximate_double(x[axis]);
  }
  compare<m + 1, m>(form.description.name, atlas, geometry_of(atlas), radius, places, Levels::of_spheres);
}

/// The net in ℝᴺ.
template <int N>
void compare_zero_set(const SubmanifoldDescription& description, const Rational& radius) {
  const auto manifold = embedded_manifold(description);
  auto net = submanifold_net<3>(*manifold, radius, 1, no_progress());
  const SubmanifoldAtlas<3> atlas(manifold, std::move(net.charts), std::move(net.radii), no_progress());
  std::vector<Place<N>> places(atlas.size());
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    const auto& centre = atlas.chart(Label(label)).data().centre;
    for (std::size_t axis = 0; axis < N; ++axis) places[label][axis] = approximate_double(centre[axis]);
  }
  compare<N, 3>(description.name, atlas, geometry_of<3>(atlas), radius, places, Levels::stars_and_manifold);
}

void run(const std::string& name, const Rational& radius) {
  for (const BuiltinManifold& file : builtin_submanifolds()) {
    if (file.name != name) continue;
    const SubmanifoldDescription description = parse_submanifold(file.text, name);
    if (description.dimension != Dimension(3)) throw InputError(name + " has not the dimension 3");
    const std::size_t ambient = description.variables.size();
    if (ambient == 4) return compare_zero_set<4>(description, radius);
    if (ambient == 5) return compare_zero_set<5>(description, radius);
    if (ambient == 6) return compare_zero_set<6>(description, radius);
    throw InputError(name + " is in a space of more than 6 dimensions");
  }
  const SpaceForm form = verify_space_form(find_space_form(name));
  if (form.form().curvature() != Curvature::positive || !form.description.generators.empty())
    throw InputError(name + " is not a sphere");
  if (form.form().dimension() == 2) {
    compare_sphere<2>(form, radius);
  } else {
    compare_sphere<3>(form, radius);
  }
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: tangential_complex sphere-2|sphere-3|ZERO-SET RADIUS\n";
    return EXIT_FAILURE;
  }
  try {
    delcert::run(argv[1], delcert::parse_exact(argv[2]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
