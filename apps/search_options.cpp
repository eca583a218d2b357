#include "apps/search_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>

#include "properties/instances/instance_class.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

CLI::Option* add_search_options(CLI::App& command, SearchOptions& options, const std::string& target,
                                const std::string& of_witnesses) {
  add_claim_options(command, options.claims);
  command.add_option("--evaluations", options.evaluations,
                     fmt::format("Instances to try for each {} and shape (default {}; fewer where one is costly)",
                                 target, options.evaluations));
  command.add_option("--seed", options.seed, "Seed of the search (default 0)");
  command.add_option("--threads", options.threads, "Threads (default: all; the result does not depend on it)");
  command.add_option("--witnesses", options.witnesses, "Folder for " + of_witnesses);
  return command.add_flag("--json", options.json, "Print JSON");
}

std::uint64_t evaluations_of(const SearchOptions& options, const Claim& claim, const Shape& shape) {
  const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(claim.instance).cost(shape));
  return std::max<std::uint64_t>(1, options.evaluations / cost);
}

void require_evaluations(const SearchOptions& options) {
  constexpr std::uint64_t most = 1000000000000;
  if (options.evaluations == 0 || options.evaluations > most) throw InputError("--evaluations takes 1 to 10^12");
}

unsigned threads_of(const SearchOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
}

void write_witness(const SearchOptions& options, const std::string& name, const Witness& witness) {
  std::error_code failure;
  std::filesystem::create_directories(options.witnesses, failure);
  if (failure) throw InputError("--witnesses " + options.witnesses + ": " + failure.message());
  write_file_atomically(std::filesystem::path(options.witnesses) / name, witness_text(witness));
}

}  // namespace delcert
