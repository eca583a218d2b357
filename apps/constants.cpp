#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "apps/commands.hpp"
#include "apps/exact_option.hpp"
#include "apps/list_option.hpp"
#include "kernel/formula/formula_error.hpp"
#include "proofs/constants/ledger_entries.hpp"
#include "proofs/publication/ledger_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct ConstantsOptions {
  std::vector<int> dimensions;
  std::vector<Rational> separations;
  std::vector<Rational> perturbations;
  Rational radius_variation;
  Rational distortion;
  ParameterConstraints constraints = ParameterConstraints::printed;
  ConstantNames only;
  bool json = false;
  bool latex = false;

  [[nodiscard]] bool is_sweep() const {
    return dimensions.size() > 1 || separations.size() > 1 || perturbations.size() > 1;
  }
};

/// The printed Theorem 3 has one sampling radius for all that it says.
void require_all_there(const ConstantsOptions& options) {
  const std::string name = "self_delaunay_sampling_radius";
  if (options.constraints == ParameterConstraints::printed &&
      std::find(options.only.begin(), options.only.end(), name) != options.only.end())
    throw InputError("--only: " + name + " is a constant of the sharper hypotheses only (--hypotheses sharper)");
}

ExitStatus print_constants(const ConstantsOptions& options) {
  require_all_there(options);
  Sweep sweep{{},
              options.separations,
              options.perturbations,
              options.radius_variation,
              options.distortion,
              options.constraints};
  for (const int dimension : options.dimensions) sweep.dimensions.emplace_back(dimension);
  const SweptLedgers swept = ledgers_of(sweep);
  if (options.is_sweep()) {
    const auto print = options.json ? sweep_json : options.latex ? sweep_latex : sweep_table;
    std::cout << print(swept, options.only);
  } else {
    const auto print = options.json ? ledger_json : options.latex ? ledger_latex : ledger_table;
    std::cout << print(swept.ledgers.front(), options.only);
  }
  return ExitStatus::verified;
}

std::string complaint_about_name(const std::string& name) {
  const ConstantNames names = all_constant_names();
  if (std::find(names.begin(), names.end(), name) != names.end()) return "";
  return "no constant is called " + shortened(name) + suggestion(name, names);
}

}  // namespace

void add_constants(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ConstantsOptions>();
  CLI::App* command = program.add_subcommand("constants", "Print the paper's constants for given parameters, exactly");
  add_integer_list_option(*command, "--dim", options->dimensions, "Dimension m of the manifold, 1 to 16; or a list")
      ->required();
  add_exact_list_option(*command, "--separation", options->separations,
                        "Separation μ₀, above 0 and at most 1; or a list")
      ->required();
  add_exact_list_option(*command, "--perturbation", options->perturbations,
                        "Perturbation ρ₀, above 0 and at most μ₀/4 (default: the largest); or a list");
  add_exact_option(*command, "--radius-variation", options->radius_variation,
                   "Variation ε₀ of the sampling radii (default 0)");
  add_exact_option(*command, "--distortion", options->distortion,
                   "Distortion ξ₀ of the transition functions (default 0)");
  const auto choose = [options](const std::string& name) {
    if (name != "printed" && name != "sharper")
      throw CLI::ValidationError("--hypotheses", "no hypotheses are called " + shortened(name) +
                                                     suggestion(name, std::vector<std::string>{"printed", "sharper"}));
    options->constraints = name == "sharper" ? ParameterConstraints::sharper : ParameterConstraints::printed;
  };
  command
      ->add_option_function<std::string>("--hypotheses", choose,
                                         "Hypotheses 2: the paper's (the default), or those of the sharper lemmas")
      ->type_name("printed|sharper");
  command->add_option("--only", options->only, "Names of the constants to print (default: all)")
      ->delimiter(',')
      ->check(complaint_about_name, "", "");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--latex", options->latex, "Print a LaTeX table (longtable, booktabs)")->excludes(json);
  command->footer(
      "Numbers are exact: integers, fractions such as 1/4, or hexadecimal floats such as 0x1p-2. A list, 1/4,1/2,1 or\n"
      "2..6, makes a sweep: every dimension with every separation and every perturbation.\n\n"
      "Examples:\n"
      "  delcert constants --dim 2 --separation 1 --perturbation 1/4\n"
      "  delcert constants --dim 3 --separation 1/2 --perturbation 1/10 --latex > constants.tex\n"
      "  delcert constants --dim 3 --separation 1 --perturbation 1/5 --json\n"
      "  delcert constants --dim 2..6 --separation 1/4,1/2,1 --only flake_parameter,distortion_bound");
  command->callback([options, &chosen] { chosen = [options] { return print_constants(*options); }; });
}

}  // namespace delcert
