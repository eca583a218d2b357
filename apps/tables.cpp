#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "apps/other_programs.hpp"
#include "proofs/tables/constant_table.hpp"
#include "properties/attack/claim_library.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct TablesOptions {
  std::string slack;
  std::string ratios;
  std::string power;
  bool places = false;
  bool latex = false;
};

std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(file + ": cannot be read");
  return text;
}

ExitStatus print_table(const TablesOptions& options) {
  const ConstantRows& rows = builtin_constant_rows();
  const auto slacks =
      options.slack.empty() ? StepSlacks() : parse_step_slacks(content_of(options.slack), options.slack);
  const auto ratios =
      options.ratios.empty() ? WorstRatios() : parse_worst_ratios(content_of(options.ratios), options.ratios);
  const auto powers =
      options.power.empty() ? std::vector<PowerOfPlace>() : parse_powers(content_of(options.power), options.power);
  if (options.places) {
    std::cout << power_page(powers);
    return ExitStatus::verified;
  }
  const auto entries = constant_entries(rows, builtin_files(), slacks, ratios, powers);
  std::cout << (options.latex ? constant_table_latex(entries) : constant_table_markdown(entries, rows.without));
  return ExitStatus::verified;
}

}  // namespace

void add_tables(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<TablesOptions>();
  CLI::App* command = add_named(program, about_tables);
  command->add_option("--slack", options->slack, "What delcert prove --all --slack --json has printed (default: none)");
  command->add_option("--ratios", options->ratios, "What delcert tighten --all --json has printed (default: none)");
  command->add_option("--power", options->power, "What delcert power --json has printed (default: none)");
  command->add_flag("--places", options->places, "Print the powers of all places in the file of --power instead")
      ->needs("--power");
  command->add_flag("--latex", options->latex, "Print a LaTeX table, longtable and booktabs (default: Markdown)");
  command->footer(
      "Examples:\n"
      "  delcert prove --all --slack --json > docs/tables/slack.json\n"
      "  delcert tighten --all --json > docs/tables/tightness.json\n"
      "  delcert tables --slack docs/tables/slack.json --ratios docs/tables/tightness.json \\\n"
      "    --power docs/tables/power.json > docs/tables/constants.md\n"
      "  delcert tables --slack docs/tables/slack.json --latex > constants.tex");
  command->callback([options, &chosen] { chosen = [options] { return print_table(*options); }; });
}

}  // namespace delcert
