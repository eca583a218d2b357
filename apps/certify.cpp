#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>

#include "apps/certification.hpp"
#include "apps/certify_complex.hpp"
#include "apps/choice_option.hpp"
#include "apps/command_line.hpp"
#include "apps/commands.hpp"
#include "apps/exact_option.hpp"
#include "apps/net_options.hpp"
#include "support/build_commit.hpp"

namespace delcert {

namespace {

LevelSelection parse_levels(const std::string& text) {
  LevelSelection result;
  std::istringstream in(text);
  for (std::string level; std::getline(in, level, ',');) {
    const auto& all = all_levels();
    if (std::find(all.begin(), all.end(), level) == all.end()) {
      throw CLI::ValidationError("--levels", "'" + level + "' is not one of 0,1,1f,2,2s,3,4,5,5i,6");
    }
    result.push_back(level);
  }
  return result;
}

/// --complex in the place of --manifold; what is about nets is not for it.
void add_complex_option(CLI::App& command, const std::shared_ptr<CertifyCommand>& options) {
  command.get_option("--manifold")->required(false);
  command
      .add_option("--complex", options->complex,
                  "A triangulation with group elements, in place of a manifold and a net (docs/complex-file.md); "
                  "with --manifold a mesh, OFF or OBJ, of that surface in space")
      ->type_name("FILE");
}

void require_manifold_or_complex(const CLI::App& command) {
  const bool has_manifold = command.get_option("--manifold")->count() > 0;
  if (command.get_option("--complex")->count() == 0) {
    if (!has_manifold) throw CLI::RequiredError("--manifold");
    return;
  }
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool fits = name == "--complex" || name == "--levels" || name == "--output" || name == "--json" ||
                      (has_manifold && (name == "--manifold" || name == "--radius" || name == "--threads"));
    if (option->count() > 0 && !fits) throw CLI::ExcludesError("--complex", name);
  }
}

}  // namespace

void add_certify(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<CertifyCommand>();
  CLI::App* command =
      program.add_subcommand("certify", "Perturb a net, compute its Delaunay complex and write a certificate");
  add_net_options(*command, options->source, true);
  add_complex_option(*command, options);
  CLI::Option* mode = add_choice_option<RunMode>(
      *command, "--mode", options->choice.mode, {{"theory", RunMode::theory}, {"measured", RunMode::measured}},
      "theory: the paper's constants; measured: chosen tolerances (default theory; on space "
      "forms other than flat tori, metric fields, atlases and submanifolds measured)");
  add_choice_option<ParameterConstraints>(
      *command, "--hypotheses", options->choice.constraints,
      {{"printed", ParameterConstraints::printed}, {"sharper", ParameterConstraints::sharper}},
      "Theory mode: Hypotheses 2 as the paper has them (the default), or those of the sharper lemmas");
  add_choice_option<CandidateRule>(
      *command, "--candidates", options->choice.candidates,
      {{"pruned", CandidateRule::pruned}, {"whole", CandidateRule::whole}, {"printed", CandidateRule::printed}},
      "Which simplices perturbations are tested against");
  add_exact_option(*command, "--perturbation", options->choice.perturbation, "ρ₀ (default μ₀/4, the most)");
  add_exact_option(*command, "--tolerance", options->choice.tolerance, "Measured mode: tolerance in units of ε");
  add_exact_option(*command, "--clearance", options->choice.clearance,
                   "A second tolerance, for candidates that can become Delaunay, in units of ε");
  command
      ->add_option("--choices", options->choice.choices,
                   "Good perturbations of which the one with most clearance is taken")
      ->check(CLI::Range(1, 1000000));
  add_exact_option(*command, "--required-protection", options->required_protection,
                   "Repair simplices whose protection is not above this, in units of ε");
  command->add_option("--repair-rounds", options->repair_rounds, "Rounds of repair before giving up (default 20)")
      ->check(CLI::Range(0, 1000000));
  command
      ->add_option("--refine", options->refinement_rounds,
                   "Greatest number of rounds that halve radii where something fails, on submanifolds, or choose home "
                   "charts, on atlases (default 0)")
      ->check(CLI::Range(0, 100));
  command->add_flag("--no-perturbation", options->no_perturbation, "Take the net as it is");
  command->add_option_function<std::string>(
      "--levels", [options](const std::string& text) { options->levels = parse_levels(text); },
      "Claim at most these levels, e.g. 0,1,2,4,5 (default all)");
  command
      ->add_option("--output", options->output, "The certificate (default MANIFOLD.delcert.json.zst); .zst compresses")
      ->type_name("FILE");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Nothing is written unless every star is certified; then the certificate claims the levels that are reached\n"
      "(docs/levels/), for delcert check to verify.\n\n"
      "Examples:\n"
      "  delcert certify --manifold torus-3 --radius 1/24 --seed 1 --output torus-3.json.zst\n"
      "  delcert certify --manifold torus-2 --lattice 30 --mode measured --tolerance 1/64\n"
      "  delcert certify --manifold torus-3 --radius 1/24 --mode theory --hypotheses sharper\n"
      "  delcert certify --manifold my-torus.toml --points net.txt --levels 0,1,2,4,5,6\n"
      "  delcert certify --manifold torus-2 --radius 1/32 --sizing examples/sizings/torus-2.txt --seed 1\n"
      "  delcert certify --manifold bolza-surface --radius 1/10 --output bolza.json.zst\n"
      "  delcert certify --manifold sphere-2 --icosphere 24\n"
      "  delcert certify --complex examples/complexes/genus-2.toml\n"
      "  delcert certify --manifold torus-of-revolution --complex mesh.off\n"
      "  delcert certify --manifold torus-2-hills --radius 1/40 --seed 1\n"
      "  delcert certify --manifold torus-of-revolution --radius 1/10 --seed 1\n"
      "  delcert certify --manifold genus-2 --radius 1/16 --sizing curvature:1/10,1/10 --refine 4\n"
      "  delcert certify --manifold torus-2 --lattice 30 --no-perturbation      (exits 1, naming stars)");
  command->callback([options, command, mode, &chosen] {
    require_manifold_or_complex(*command);
    options->mode_is_given = mode->count() > 0;
    options->origin = {{"command", command_line("delcert", *command, {"--output", "--threads", "--json"})}};
    if (build_commit()[0] != '\0') options->origin.emplace_back("commit", build_commit());
    if (!options->complex.empty() && options->source.manifold.empty()) {
      chosen = [options] { return certify_complex(*options); };
      return;
    }
    chosen = [options] { return certify(*options); };
  });
}

}  // namespace delcert
