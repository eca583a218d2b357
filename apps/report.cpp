#include <fmt/chrono.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/checker_process.hpp"
#include "apps/commands.hpp"
#include "apps/other_programs.hpp"
#include "apps/progress_line.hpp"
#include "apps/witness_file.hpp"
#include "proofs/publication/certificate_page.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::vector<std::string> files;
  std::string output;
  bool is_checked = true;
};

std::string without_line_feed(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

CheckRecord checked(const std::string& path) {
  const fs::path checker = installed_checker();
  const CheckerRun version = run_checker_with(checker, {"--version"});
  const CheckerRun run = run_checker_on(checker, path);
  if (version.status != 0 || run.status > 3)
    throw std::runtime_error("delcert-check ended with status " +
                             std::to_string(version.status != 0 ? version.status : run.status));
  CheckRecord record;
  record.checker = "delcert-check " + without_line_feed(version.output);
  record.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()));
  record.result = nlohmann::ordered_json::parse(run.output);
  return record;
}

/// Of several the first in this list: what one reader must not miss.
ExitStatus worst(const std::vector<ExitStatus>& found) {
  for (const ExitStatus status : {ExitStatus::rejected, ExitStatus::malformed, ExitStatus::undecided}) {
    if (std::find(found.begin(), found.end(), status) != found.end()) return status;
  }
  return ExitStatus::verified;
}

bool is_about_claims(const std::string& file) { return witness_file(file) != WitnessFile::other; }

ExitStatus write_report(const ReportOptions& options) {
  if (is_left_to_claims(about_attack.name) && std::ranges::any_of(options.files, is_about_claims))
    hand_over_to(claims_program);
  ProgressLine line;
  const Progress progress = line.callback();
  std::vector<PageItem> items;
  std::vector<ExitStatus> statuses;
  std::size_t read = 0;
  for (const std::string& file : options.files) {
    progress("reading " + fs::path(file).filename().string(), read++, options.files.size());
    if (is_about_claims(file)) {
      std::ranges::move(witness_items(file, shown_file(file)), std::back_inserter(items));
      continue;
    }
    items.push_back(certificate_page_item(
        file, options.is_checked ? [&file] { return checked(file); } : std::function<CheckRecord()>()));
    const nlohmann::ordered_json& check = items.back().data.at("check");
    if (!check.is_null()) statuses.push_back(static_cast<ExitStatus>(check.at("result").at("exit").get<int>()));
  }
  progress("writing", read, options.files.size());
  write_file_atomically(options.output, html_page(items));
  return worst(statuses);
}

}  // namespace

void add_report(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = add_named(program, about_report);
  command
      ->add_option("FILE", options->files,
                   "Certificates, plain or compressed; witnesses of attacks, or what attack --json printed")
      ->required();
  command->add_option("--output", options->output, "The HTML file; it is all that a reader needs")
      ->required()
      ->type_name("FILE");
  command->add_flag("--check,!--no-check", options->is_checked,
                    "Run delcert-check on each certificate and show what it says (the default)");
  command->footer(
      "Exit status: 0 written, and every certificate verified (with --no-check: written), 1 one is rejected, 3 one is\n"
      "malformed, 2 one is undecided. In all of these cases the page is written, if the files can be read at all.\n\n"
      "Examples:\n"
      "  delcert report torus-3.json.zst --output torus-3.html\n"
      "  delcert report bolza.json.zst klein-bottle.json.zst found/my-claim.radius.json --output gallery.html");
  command->callback([options, &chosen] { chosen = [options] { return write_report(*options); }; });
}

}  // namespace delcert
