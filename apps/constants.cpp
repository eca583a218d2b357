#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "apps/commands.hpp"
#include "apps/exact_option.hpp"
#include "apps/ledger_text.hpp"
#include "proofs/constants/ledger.hpp"

namespace delcert {

namespace {

struct ConstantsOptions {
  int dimension = 0;
  Rational separation;
  Rational perturbation;
  Rational radius_variation;
  Rational distortion;
  bool json = false;
  bool latex = false;
};

ExitStatus print_constants(const ConstantsOptions& options) {
  const Ledger ledger = constants_for(Dimension{options.dimension}, options.separation, options.perturbation,
                                      options.radius_variation, options.distortion);
  std::cout << (options.json ? ledger_json(ledger) : options.latex ? ledger_latex(ledger) : ledger_table(ledger));
  return ExitStatus::verified;
}

}  // namespace

void add_constants(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ConstantsOptions>();
  CLI::App* command = program.add_subcommand("constants", "Print the paper's constants for given parameters, exactly");
  command->add_option("--dim", options->dimension, "Dimension m of the manifold, 1 to 16")->required();
  add_exact_option(*command, "--separation", options->separation, "Separation μ₀, above 0 and at most 1")->required();
  add_exact_option(*command, "--perturbation", options->perturbation, "Perturbation ρ₀, above 0 and at most μ₀/4")
      ->required();
  add_exact_option(*command, "--radius-variation", options->radius_variation,
                   "Variation ε₀ of the sampling radii (default 0)");
  add_exact_option(*command, "--distortion", options->distortion,
                   "Distortion ξ₀ of the transition functions (default 0)");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--latex", options->latex, "Print a LaTeX table (booktabs)")->excludes(json);
  command->footer(
      "Numbers are exact: integers, fractions such as 1/4, or hexadecimal floats such as 0x1p-2.\n\n"
      "Examples:\n"
      "  delcert constants --dim 2 --separation 1 --perturbation 1/4\n"
      "  delcert constants --dim 3 --separation 1/2 --perturbation 1/10 --latex > constants.tex\n"
      "  delcert constants --dim 3 --separation 1 --perturbation 1/5 --json");
  command->callback([options, &chosen] { chosen = [options] { return print_constants(*options); }; });
}

}  // namespace delcert
