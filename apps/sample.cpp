#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "apps/net_options.hpp"
#include "apps/progress_line.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certification/family.hpp"
#include "support/atomic_file.hpp"

namespace delcert {

namespace {

struct SampleOptions {
  NetSource source;
  std::string output;
  bool json = false;
};

ExitStatus sample(const SampleOptions& options) {
  ProgressLine line;
  StageClock clock;
  const std::unique_ptr<Family> family = family_of(find_any_manifold(options.source.manifold), clock);
  family->make_net(options.source, line.callback());
  const NetText net = family->net();
  const bool is_certified = net.covering_radius_lower.has_value();
  const std::string radius = exact_text(family->report.sampling_radius);
  const std::string separation = exact_text(family->report.parameters.algorithm.separation);
  line.clear();
  const std::string head = fmt::format("# manifold {}{}{}\n# {} radius {}\n# separation {}\n# seed {}\n",
                                       family->report.manifold, net.coordinates.empty() ? "" : ", ", net.coordinates,
                                       is_certified ? "sampling" : "nominal", radius, separation, options.source.seed);
  write_file_atomically(options.output, head + points_text(net.points));
  if (options.json) {
    nlohmann::ordered_json result;
    result["points"] = net.points.size();
    result[is_certified ? "sampling_radius" : "nominal_radius"] = radius;
    if (is_certified) result["covering_radius_lower"] = exact_text(*net.covering_radius_lower);
    if (net.covering_radius_about) result["covering_radius_about"] = *net.covering_radius_about;
    result["separation"] = separation;
    result["file"] = options.output;
    std::cout << result.dump(2) << "\n";
    return ExitStatus::verified;
  }
  std::cout << fmt::format("{} points in {}\n", net.points.size(), options.output);
  if (is_certified) {
    std::cout << fmt::format("sampling radius ε = {}, separation μ₀ = {}, both certified\n", radius, separation);
  } else {
    std::cout << fmt::format("radius {}, in the charts separation μ₀ = {}, certified", radius, separation);
    if (net.covering_radius_about)
      std::cout << fmt::format("; covering radius about {:.6g}, not certified", *net.covering_radius_about);
    std::cout << "\n";
  }
  return ExitStatus::verified;
}

}  // namespace

void add_sample(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<SampleOptions>();
  CLI::App* command = program.add_subcommand("sample", "Make a net of a manifold and measure it with certified bounds");
  add_net_options(*command, options->source, false);
  command->add_option("--output", options->output, "The point file to write")->required()->type_name("FILE");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "The sampling radius is certified to exceed the covering radius by at most 0.1 %\n(on space forms it is the "
      "nominal one, and certify bounds the covering radius).\n\n"
      "Examples:\n"
      "  delcert sample --manifold torus-3 --radius 1/24 --seed 1 --output net.txt\n"
      "  delcert sample --manifold torus-2 --lattice 30 --output square.txt\n"
      "  delcert sample --manifold sphere-2 --icosphere 24 --output icosphere.txt\n"
      "  delcert sample --manifold torus-3 --lattice 16 --centred --displace 60 --output nearly-bcc.txt");
  command->callback([options, &chosen] { chosen = [options] { return sample(*options); }; });
}

}  // namespace delcert
