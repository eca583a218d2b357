#include "apps/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/interruption.hpp"
#include "apps/other_programs.hpp"
#include "delcert_version.hpp"
#include "kernel/number/self_test.hpp"
#include "support/spelling.hpp"

namespace delcert {
namespace {

/// Rigour rests on rounding that is really directed, on no contraction, on the libraries: refuse to go on without.
bool arithmetic_is_sound() {
  const std::vector<std::string> failures = arithmetic_self_test();
  for (const std::string& failure : failures) report_error(std::cerr, "internal: arithmetic self-test: " + failure);
  return failures.empty();
}

ExitStatus usage_error(const std::string& message) {
  report_error(std::cerr, message);
  std::cerr << "delcert: see delcert --help" << std::endl;
  return ExitStatus::usage;
}

/// Names the subcommand that was probably meant, if the first argument is not one.
std::string hint_for(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return "";
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), arguments[0]) != names.end()) return "";
  return "there is no subcommand " + shortened(arguments[0]) + suggestion(arguments[0], names);
}

bool asks_for_help(std::string_view argument) { return argument == "--help" || argument == "-h"; }

}  // namespace

ExitStatus run_program(int argc, char** argv, std::span<const AddCommand> commands) {
  CLI::App program("Certified Delaunay triangulations of manifolds, with every constant re-checked.", "delcert");
  program.set_version_flag("--version", std::string("delcert ") + version);
  program.require_subcommand(1);
  program.footer(
      "Exit status: 0 done or verified, 1 rejected, 2 undecided, 3 malformed input, 64 usage, 70 internal,\n"
      "130 interrupted.\n\n"
      "Examples:\n"
      "  delcert constants --dim 2 --separation 1 --perturbation 1/4\n"
      "  delcert check certificates/torus-3.json.zst\n"
      "  delcert constants --help");
  Action chosen;
  for (const AddCommand add : commands) add(program, chosen);

  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() > 1 && arguments[0] == "check" && !asks_for_help(arguments[1])) {
    chosen = [&]() -> ExitStatus { run_checker({arguments.begin() + 1, arguments.end()}); };
  } else if (!arguments.empty() && is_left_to_publishing(arguments[0])) {
    chosen = []() -> ExitStatus { hand_over_to(publishing_program); };
  } else if (!arguments.empty() && is_left_to_claims(arguments[0])) {
    chosen = []() -> ExitStatus { hand_over_to(claims_program); };
  } else {
    try {
      program.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
      program.exit(help_or_version);
      return ExitStatus::verified;
    } catch (const CLI::ParseError& error) {
      const std::string hint = hint_for(program, arguments);
      return usage_error(hint.empty() ? error.what() : hint);
    }
  }

  if (!arithmetic_is_sound()) return ExitStatus::internal;
  catch_interruptions();
  const ExitStatus status = run_reporting(chosen, std::cerr);
  if (!std::cout.flush()) {
    report_error(std::cerr, "internal: cannot write to standard output");
    return ExitStatus::internal;
  }
  return status;
}

}  // namespace delcert
