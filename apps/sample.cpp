#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "apps/metric_field_net.hpp"
#include "apps/net_source.hpp"
#include "apps/progress_line.hpp"
#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/point_file.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/atomic_file.hpp"

namespace delcert {

namespace {

struct SampleOptions {
  NetSource source;
  std::string output;
  bool json = false;
};

template <int m>
ExitStatus sample(const SampleOptions& options, const ManifoldDescription& manifold) {
  ProgressLine line;
  const Progress progress = line.callback();
  const FlatSpace<m> space = flat_space_of<m>(manifold);
  const auto points = options.source.template points<m>(space, progress);
  const PointSet<m> net(points);
  const auto density = measure_density<m>(space, net, options.source.radius, progress);
  const FlatAtlas<m> atlas(space, net, density.sampling_radius);
  const Rational separation = measure_separation<m>(atlas);
  line.clear();

  PointList list;
  for (const auto& point : points) list.emplace_back(point.begin(), point.end());
  const std::string head =
      fmt::format("# manifold {}\n# sampling radius {}\n# separation {}\n# seed {}\n", manifold.name,
                  exact_text(density.sampling_radius), exact_text(separation), options.source.seed);
  write_file_atomically(options.output, head + points_text(list));

  if (options.json) {
    nlohmann::ordered_json result;
    result["points"] = points.size();
    result["sampling_radius"] = exact_text(density.sampling_radius);
    result["covering_radius_lower"] = exact_text(density.covering_radius_lower);
    result["separation"] = exact_text(separation);
    result["file"] = options.output;
    std::cout << result.dump(2) << "\n";
  } else {
    std::cout << fmt::format("{} points in {}\nsampling radius ε = {}, separation μ₀ = {}, both certified\n",
                             points.size(), options.output, exact_text(density.sampling_radius),
                             exact_text(separation));
  }
  return ExitStatus::verified;
}

template <int m>
ExitStatus sample_space_form(const SampleOptions& options, const SpaceForm& form) {
  ProgressLine line;
  auto [centres, radius] = options.source.template net_of<m>(form, line.callback());
  PointList list;
  for (const auto& point : centres) list.emplace_back(point.begin(), point.end());
  const double covering_radius = measured_net<m>(form, centres, radius).covering_radius;
  const SpaceFormAtlas<m> atlas(form, std::move(centres), radius, fitting_patch_factor(form, m, radius));
  const Rational separation = measure_separation<m>(atlas);
  line.clear();
  const std::string head =
      fmt::format("# manifold {}, conformal coordinates\n# nominal radius {}\n# separation {}\n# seed {}\n",
                  form.description.name, exact_text(radius), exact_text(separation), options.source.seed);
  write_file_atomically(options.output, head + points_text(list));
  if (options.json) {
    nlohmann::ordered_json result;
    result["points"] = list.size();
    result["nominal_radius"] = exact_text(radius);
    result["covering_radius_about"] = covering_radius;
    result["separation"] = exact_text(separation);
    result["file"] = options.output;
    std::cout << result.dump(2) << "\n";
  } else {
    std::cout << fmt::format(
        "{} points in {}\nradius {}, separation μ₀ = {}, certified; covering radius about {:.6g}, not certified\n",
        list.size(), options.output, exact_text(radius), exact_text(separation), covering_radius);
  }
  return ExitStatus::verified;
}

template <int m>
ExitStatus sample_metric_field(const SampleOptions& options, const MetricFieldDescription& description) {
  ProgressLine line;
  MetricField<m> field(description);
  auto centres = metric_field_net_of<m>(options.source, field, line.callback());
  PointList list;
  for (const auto& point : centres) list.emplace_back(point.begin(), point.end());
  const Rational radius = *options.source.radius;
  const MetricFieldAtlas<m> atlas(std::move(field), std::move(centres), radius);
  const Rational separation = measure_separation<m>(atlas);
  line.clear();
  const std::string head =
      fmt::format("# manifold {}, coordinates of the torus\n# nominal radius {}\n# separation {}\n# seed {}\n",
                  description.name, exact_text(radius), exact_text(separation), options.source.seed);
  write_file_atomically(options.output, head + points_text(list));
  if (options.json) {
    nlohmann::ordered_json result;
    result["points"] = list.size();
    result["nominal_radius"] = exact_text(radius);
    result["separation"] = exact_text(separation);
    result["file"] = options.output;
    std::cout << result.dump(2) << "\n";
  } else {
    std::cout << fmt::format("{} points in {}\nradius {}, in the charts separation μ₀ = {}, certified\n", list.size(),
                             options.output, exact_text(radius), exact_text(separation));
  }
  return ExitStatus::verified;
}

}  // namespace

void add_sample(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<SampleOptions>();
  CLI::App* command = program.add_subcommand("sample", "Make a net of a manifold and measure it, certified");
  options->source.add_options(*command, false);
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
  command->callback([options, &chosen] {
    chosen = [options] {
      const AnyManifold found = find_any_manifold(options->source.manifold);
      if (const auto* description = std::get_if<SpaceFormDescription>(&found)) {
        const SpaceForm form = verify_space_form(*description);
        if (form.form().dimension() == 2) return sample_space_form<2>(*options, form);
        return sample_space_form<3>(*options, form);
      }
      if (const auto* field = std::get_if<MetricFieldDescription>(&found)) {
        if (field->dimension == Dimension(2)) return sample_metric_field<2>(*options, *field);
        return sample_metric_field<3>(*options, *field);
      }
      const auto& manifold = std::get<ManifoldDescription>(found);
      return with_dimension(manifold.dimension, [&]<int m>() { return sample<m>(*options, manifold); });
    };
  });
}

}  // namespace delcert
