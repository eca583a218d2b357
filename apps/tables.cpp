#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "apps/commands.hpp"
#include "kernel/error.hpp"
#include "proofs/tables/constant_table.hpp"
#include "properties/attack/attempt.hpp"

namespace delcert {

namespace {

struct TablesOptions {
  std::string slack;
  bool latex = false;
};

StepSlacks slacks_of(const TablesOptions& options) {
  if (options.slack.empty()) return {};
  std::ifstream stream(options.slack, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(options.slack + ": cannot be read");
  return parse_step_slacks(text, options.slack);
}

ExitStatus print_table(const TablesOptions& options) {
  const ConstantRows& rows = builtin_constant_rows();
  const auto entries = constant_entries(rows, builtin_files(), slacks_of(options));
  std::cout << (options.latex ? constant_table_latex(entries) : constant_table_markdown(entries, rows.without));
  return ExitStatus::verified;
}

}  // namespace

void add_tables(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<TablesOptions>();
  CLI::App* command = program.add_subcommand(
      "tables", "Print the constants of the lemmas: the paper's, provable by the same proof, shown necessary");
  command->add_option("--slack", options->slack, "What delcert prove --all --slack --json has printed (default: none)");
  command->add_flag("--latex", options->latex, "Print a LaTeX table (default: Markdown)");
  command->footer(
      "Examples:\n"
      "  delcert prove --all --slack --json > docs/tables/slack.json\n"
      "  delcert tables --slack docs/tables/slack.json > docs/tables/constants.md\n"
      "  delcert tables --slack docs/tables/slack.json --latex > docs/tables/constants.tex");
  command->callback([options, &chosen] { chosen = [options] { return print_table(*options); }; });
}

}  // namespace delcert
