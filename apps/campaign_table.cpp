#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/attack_outcome.hpp"
#include "apps/campaign_commands.hpp"
#include "apps/campaign_options.hpp"
#include "apps/interruption.hpp"
#include "apps/progress_line.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/campaign.hpp"
#include "properties/attack/campaign_merge.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct TableOptions {
  std::string log;
  std::string witnesses;
  std::uint64_t least = usual_least_instances;
  unsigned threads = 0;
  bool is_short = false;
  bool json = false;
  bool latex = false;
};

ExitStatus run_table(const TableOptions& options) {
  const CampaignRecord log = read_campaign(options.log);
  if (!(log.plan.part == Part{})) {
    throw InputError(options.log + ": the log of part " + text_of(log.plan.part) +
                     ": a table is of all parts, which delcert campaign merge puts together");
  }
  const std::vector<Block> missing = missing_blocks(log);
  if (!missing.empty()) throw Undecided(options.log + ": " + missing_text(log.plan, missing));
  const InterruptionDeadline deadline;
  ProgressLine line;
  decide_anew(options.log, log.plan, log.finished, threads_or_all(options.threads), line.callback());
  line.clear();
  const OutcomeOptions outcome{log.plan.seed,    options.least, options.witnesses,
                               options.is_short, options.json,  options.latex};
  return report_outcome(log.plan.targets, tallies_of(log.plan, log.finished), outcome, line.callback());
}

}  // namespace

void add_campaign_table(CLI::App& campaign, Action& chosen) {
  const auto options = std::make_shared<TableOptions>();
  CLI::App* command = campaign.add_subcommand("table", "Print what a finished campaign found, from its log");
  command->add_option("log", options->log, "A log of delcert attack, or of delcert campaign merge")->required();
  command->add_option("--least,--least-instances", options->least,
                      "What fewer instances have not refuted counts as hardly attacked (default 100)");
  command->add_option("--witnesses", options->witnesses, "Folder for witness files of what is refuted");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_flag("--short", options->is_short, "A row of the table for all shapes of the same k");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--latex", options->latex, "Print the table in LaTeX (longtable, booktabs), and nothing else")
      ->excludes(json);
  command->footer(
      "Prints byte for byte what the single delcert attack prints, with its exit status; 2 also if a block is "
      "missing.\n\n"
      "Example:\n"
      "  delcert campaign table whole.jsonl --short --witnesses found");
  command->callback([options, &chosen] { chosen = [options] { return run_table(*options); }; });
}

}  // namespace delcert
