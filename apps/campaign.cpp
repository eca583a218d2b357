#include <CLI/CLI.hpp>

#include "apps/campaign_commands.hpp"
#include "apps/other_programs.hpp"

namespace delcert {

void add_campaign(CLI::App& program, Action& chosen) {
  CLI::App* command = add_named(program, about_campaign);
  command->require_subcommand(1);
  add_campaign_merge(*command, chosen);
  add_campaign_table(*command, chosen);
  add_campaign_status(*command, chosen);
  add_campaign_recheck(*command, chosen);
  command->footer(
      "A campaign is an attack with a log: delcert attack … --log FILE, with --part i/n one of several parts of it.\n\n"
      "Examples:\n"
      "  delcert campaign merge part-1.jsonl part-2.jsonl --output whole.jsonl\n"
      "  delcert campaign table whole.jsonl\n"
      "  delcert campaign status part-*.jsonl\n"
      "  delcert campaign recheck whole.jsonl --share 1/100");
}

}  // namespace delcert
