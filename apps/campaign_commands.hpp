#pragma once

#include <CLI/CLI.hpp>

#include "apps/exit_status.hpp"

namespace delcert {

/// The subcommands of `delcert campaign`, as those of the program (apps/commands.hpp).
void add_campaign_merge(CLI::App& campaign, Action& chosen);
void add_campaign_table(CLI::App& campaign, Action& chosen);
void add_campaign_status(CLI::App& campaign, Action& chosen);
void add_campaign_recheck(CLI::App& campaign, Action& chosen);

}  // namespace delcert
