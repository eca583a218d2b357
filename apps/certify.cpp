#include <fmt/format.h>

#include <iostream>
#include <map>
#include <memory>
#include <sstream>

#include "apps/certify_complex.hpp"
#include "apps/certify_metric_field.hpp"
#include "apps/certify_options.hpp"
#include "apps/certify_space_form.hpp"
#include "apps/commands.hpp"
#include "apps/exact_option.hpp"
#include "apps/progress_line.hpp"
#include "apps/report_parts.hpp"
#include "apps/run_report.hpp"
#include "kernel/manifold/any_manifold.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/parallel/threads.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/flat_claims.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Throws Rejection naming the items of the input that do not hold.
void require_input(const std::vector<InputItem>& items) {
  std::string failed;
  for (const InputItem& item : items) {
    if (!is_proved(item.verdict))
      failed += fmt::format("\n  {} {} ({})", name_of(item.verdict), item.name, item.detail);
  }
  if (!failed.empty()) throw Rejection("the input does not satisfy Hypotheses 1:" + failed);
}

/// Throws Rejection naming the stars that are not certified.
template <int m>
void require_stars(const RunResult<m>& run) {
  if (run.is_certified()) return;
  std::vector<StarFailure> failures = run.protection.failures;
  failures.insert(failures.end(), run.combinatorial_failures.begin(), run.combinatorial_failures.end());
  throw Rejection(star_failures_text(failures, run.repair_rounds));
}

template <int m>
ExitStatus certify(const CertifyOptions& options, const ManifoldDescription& manifold) {
  ProgressLine line;
  StageClock clock;
  const Progress progress = clock.callback(line.callback());
  RunReport report;
  report.manifold = manifold.name;

  const FlatSpace<m> space = flat_space_of<m>(manifold);
  clock.begin("read or sample the net");
  PointSet<m> net(options.source.template points<m>(space, progress));
  const auto density = measure_density<m>(space, net, options.source.radius, progress);
  const FlatAtlas<m> atlas(space, std::move(net), density.sampling_radius);
  const Rational separation = measure_separation<m>(atlas);
  report.points = atlas.size();
  report.sampling_radius = atlas.sampling_radius();
  report.parameters = parameters_for(Dimension(m), separation, options.choice);
  report.input = check_input<m>(atlas, separation, report.parameters.algorithm.perturbation);
  require_input(report.input);

  RunRequest request;
  request.perturb = !options.no_perturbation;
  request.most_repair_rounds = options.repair_rounds;
  if (options.required_protection) request.required_protection = *options.required_protection * atlas.sampling_radius();
  const RunResult<m> run = run_algorithm<m>(atlas, report.parameters.algorithm, request, progress);
  line.clear();
  require_stars<m>(run);

  clock.begin("derive levels");
  report.claims = derive_claims<m>(atlas, report.parameters, run, options.levels, progress, report.reasons);
  if (report.claims.names().empty())
    throw Rejection("no level is reached: " + fmt::format("{}", fmt::join(report.reasons, "; ")));
  clock.begin("write the certificate");
  report.certificate = options.output.empty() ? manifold.name + ".delcert.json.zst" : options.output;
  write_certificate<m>(report.certificate,
                       content_of<m>(manifold, atlas, density.simplices, report.parameters, run, report.claims),
                       progress);

  report.perturbed = request.perturb;
  report.simplices = run.complex.simplices().size();
  report.statistics = run.statistics;
  report.repair_rounds = run.repair_rounds;
  report.repaired_points = run.repaired_points;
  report.stages = clock.finish();
  report.peak_memory_mib = peak_memory_in_mib();
  line.clear();
  std::cout << (options.json ? report_json(report) : report_text(report));
  return ExitStatus::verified;
}

LevelSelection parse_levels(const std::string& text) {
  LevelSelection result;
  std::istringstream in(text);
  for (std::string level; std::getline(in, level, ',');) {
    const auto& all = all_levels();
    if (std::find(all.begin(), all.end(), level) == all.end()) {
      throw CLI::ValidationError("--levels", "'" + level + "' is not one of 0,1,2,2s,3,4,5,6");
    }
    result.push_back(level);
  }
  return result;
}

/// --complex in the place of --manifold; what is about nets is not for it.
void add_complex_option(CLI::App& command, const std::shared_ptr<CertifyOptions>& options) {
  command.get_option("--manifold")->required(false);
  command
      .add_option("--complex", options->complex,
                  "A triangulation with group elements, in place of a manifold and a net (docs/complex-file.md)")
      ->type_name("FILE");
}

void require_manifold_or_complex(const CLI::App& command) {
  if (command.get_option("--complex")->count() == 0) {
    if (command.get_option("--manifold")->count() == 0) throw CLI::RequiredError("--manifold");
    return;
  }
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool fits = name == "--complex" || name == "--levels" || name == "--output" || name == "--json";
    if (option->count() > 0 && !fits) throw CLI::ExcludesError("--complex", name);
  }
}

}  // namespace

void add_certify(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* command =
      program.add_subcommand("certify", "Perturb a net, compute its Delaunay complex and write a certificate");
  options->source.add_options(*command, true);
  add_complex_option(*command, options);
  const std::map<std::string, RunMode> modes{{"theory", RunMode::theory}, {"measured", RunMode::measured}};
  const std::map<std::string, CandidateRule> rules{
      {"pruned", CandidateRule::pruned}, {"whole", CandidateRule::whole}, {"printed", CandidateRule::printed}};
  CLI::Option* mode =
      command
          ->add_option("--mode", options->choice.mode,
                       "theory: the paper's constants; measured: chosen tolerances (default theory, on space forms "
                       "other than flat tori and on metric fields measured)")
          ->transform(CLI::CheckedTransformer(modes))
          ->type_name("theory|measured");
  command->add_option("--candidates", options->choice.candidates, "Which simplices perturbations are tested against")
      ->transform(CLI::CheckedTransformer(rules))
      ->type_name("pruned|whole|printed");
  add_exact_option(*command, "--perturbation", options->choice.perturbation, "ρ₀ (default μ₀/4, the most)");
  add_exact_option(*command, "--tolerance", options->choice.tolerance, "Measured mode: tolerance in units of ε");
  add_exact_option(*command, "--clearance", options->choice.clearance,
                   "A second tolerance, for candidates that can become Delaunay, in units of ε");
  command->add_option("--choices", options->choice.choices, "Of so many good perturbations the one with most clearance")
      ->check(CLI::Range(1, 1000000));
  add_exact_option(*command, "--required-protection", options->required_protection,
                   "Repair simplices that are not more protected than this, in units of ε");
  command->add_option("--repair-rounds", options->repair_rounds, "Rounds of repair before giving up (default 20)")
      ->check(CLI::Range(0, 1000000));
  command->add_flag("--no-perturbation", options->no_perturbation, "Take the net as it is");
  command->add_option_function<std::string>(
      "--levels", [options](const std::string& text) { options->levels = parse_levels(text); },
      "Levels to claim at most, e.g. 0,1,2,4,5 (default all)");
  command
      ->add_option("--output", options->output, "The certificate (default MANIFOLD.delcert.json.zst); .zst compresses")
      ->type_name("FILE");
  command
      ->add_option("--threads", options->threads,
                   "Space forms: threads (default: all; the result does not depend on it)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Nothing is written unless every star is certified; then the certificate claims the levels that are reached\n"
      "(docs/levels/), for delcert check to verify.\n\n"
      "Examples:\n"
      "  delcert certify --manifold torus-3 --radius 1/24 --seed 1 --output torus-3.json.zst\n"
      "  delcert certify --manifold torus-2 --lattice 30 --mode measured --tolerance 1/64\n"
      "  delcert certify --manifold my-torus.toml --points net.txt --levels 0,1,2,4,5,6\n"
      "  delcert certify --manifold bolza-surface --radius 1/10 --output bolza.json.zst\n"
      "  delcert certify --manifold sphere-2 --icosphere 24\n"
      "  delcert certify --complex examples/complexes/genus-2.toml\n"
      "  delcert certify --manifold torus-2-hills --radius 1/40 --seed 1\n"
      "  delcert certify --manifold torus-2 --lattice 30 --no-perturbation      (exits 1, naming stars)");
  command->callback([options, command, mode, &chosen] {
    require_manifold_or_complex(*command);
    options->mode_is_given = mode->count() > 0;
    if (!options->complex.empty()) {
      chosen = [options] { return certify_complex(*options); };
      return;
    }
    chosen = [options] {
      const ThreadLimit limit(options->threads);
      options->choice.seed = options->source.seed;
      if (options->no_perturbation) options->choice.mode = RunMode::none;
      const AnyManifold found = find_any_manifold(options->source.manifold);
      if (const auto* form = std::get_if<SpaceFormDescription>(&found)) return certify_space_form(*options, *form);
      if (const auto* field = std::get_if<MetricFieldDescription>(&found))
        return certify_metric_field(*options, *field);
      const auto& manifold = std::get<ManifoldDescription>(found);
      return with_dimension(manifold.dimension, [&]<int m>() { return certify<m>(*options, manifold); });
    };
  });
}

}  // namespace delcert
