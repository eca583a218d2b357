// What a run on a space form does from its net to levels 1, 2, 2s, 4 and 5, in one thread. Built twice:
// curved_certified has the real kernel, curved_plain plain doubles in place of intervals (then nothing is certified).
//   curved_certified sphere-2 1/84
// prints the processor seconds of every stage and what was found, in JSON. The group of the manifold is not timed.

#include <fmt/format.h>

#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/filter.hpp"
#include "kernel/parallel/threads.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/riemannian_simplices.hpp"

namespace delcert {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t seed = 1;

/// Processor seconds of this process by stage: a stage lasts until the next one begins.
class StageTimes {
 public:
  [[nodiscard]] Progress progress() {
    return [this](std::string_view stage, std::size_t, std::size_t) { begin(stage); };
  }
  void begin(std::string_view stage) {
    if (stage == stage_) return;
    finish();
    stage_ = stage;
  }
  void finish() {
    const std::clock_t now = std::clock();
    if (!stage_.empty())
      seconds_[stage_] = seconds_.value(stage_, 0.0) + static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    stage_.clear();
    last_ = now;
  }
  [[nodiscard]] const Json& seconds() const { return seconds_; }

 private:
  std::string stage_;
  std::clock_t last_ = 0;
  Json seconds_ = Json::object();
};

Json settled(const LadderStatistics& decisions) {
  return {{"intervals", decisions.settled[static_cast<std::size_t>(Rung::interval)]},
          {"bits", decisions.settled[static_cast<std::size_t>(Rung::big_interval)]},
          {"rationals", decisions.settled[static_cast<std::size_t>(Rung::rational)]},
          {"undecided", decisions.undecided}};
}

template <int m>
Json measure(const SpaceForm& form, const Rational& radius) {
  StageTimes times;
  times.begin("net");
  auto net = space_form_net<m>(form, radius, seed, times.progress());
  times.begin("atlas");
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, fitting_patch_factor(form, m, radius));
  const ModelGeometry geometry = geometry_of(atlas);
  const auto run = run_in_charts<m>(atlas, geometry, measured_parameters(Dimension(m), seed), {}, times.progress());
  const auto stability = check_stability<m>(atlas, run.points, geometry, run.complex, times.progress());
  const auto simplices = measure_riemannian_simplices<m>(atlas, run.points, geometry, run.complex, times.progress());
  times.finish();
  return {{"kernel", filter_is_rigorous ? "certified" : "plain doubles"},
          {"points", atlas.size()},
          {"levels 1, 2, 4", run.is_certified()},
          {"pairs", stability.pairs},
          {"pairs that differ", stability.differing},
          {"level 5", name_of(simplices.holds)},
          {"decisions", settled(ladder_statistics())},
          {"seconds", times.seconds()}};
}

Json measured(const std::string& name, const Rational& radius) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  return form.form().dimension() == 2 ? measure<2>(form, radius) : measure<3>(form, radius);
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " SPACE-FORM RADIUS\n";
    return EXIT_FAILURE;
  }
  try {
    const delcert::ThreadLimit one(1);
    std::cout << delcert::measured(argv[1], delcert::parse_exact(argv[2])).dump(1) << '\n';
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
