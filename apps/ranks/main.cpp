#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "apps/command_line.hpp"
#include "apps/exact_option.hpp"
#include "apps/exit_status.hpp"
#include "apps/ranks/mpi_communicator.hpp"
#include "delcert_version.hpp"
#include "kernel/number/self_test.hpp"
#include "kernel/parallel/threads.hpp"
#include "proofs/certification/shared_certification.hpp"
#include "support/build_commit.hpp"
#include "support/error.hpp"
#include "support/host.hpp"

namespace delcert {
namespace {

/// The certificate is that of `delcert certify`, and says so.
void add_shared_certify(CLI::App& program, SharedOptions& options) {
  CLI::App* command = program.add_subcommand("certify", "Certify a triangulation of a sphere and write it in chunks");
  command->add_option("--manifold", options.certify.source.manifold, "sphere-2, sphere-3, or the file of a sphere")
      ->required();
  add_exact_option(*command, "--radius", options.certify.source.radius, "Poisson-disk net of this radius");
  command->get_option("--radius")->required();
  command->add_option("--seed", options.certify.source.seed, "Seed of all random choices (default 0)")
      ->type_name("INTEGER");
  add_exact_option(*command, "--tolerance", options.certify.choice.tolerance, "Tolerance in units of ε");
  command
      ->add_option("--repair-rounds", options.certify.repair_rounds, "Rounds of repair before giving up (default 20)")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--chunks", options.chunks, "How many, at least 2; no matter how many ranks")
      ->required()
      ->check(CLI::Range(std::size_t{2}, std::size_t{1000000000}));
  command->add_option("--output", options.certify.output, "The folder of the chunks, which is made")
      ->required()
      ->type_name("FOLDER");
  command->add_option("--threads", options.certify.threads, "Threads of each rank (default 1)")
      ->check(CLI::Range(1, 1024));
  command->footer(
      "The files are those of delcert certify and delcert split, byte for byte, for any number of ranks.\n"
      "What is finished is kept in FOLDER.progress: if a rank ends, the same command goes on from there.\n\n"
      "Examples:\n"
      "  mpirun -n 4 delcert-ranks certify --manifold sphere-2 --radius 1/50 --seed 1 --chunks 16 --output sphere\n"
      "  delcert-check --chunk 1 --receipt 1.receipt sphere");
  command->callback([&options, command] {
    options.certify.origin = {{"command", command_line("delcert", *command, {"--chunks", "--output", "--threads"})}};
    if (build_commit()[0] != '\0') options.certify.origin.emplace_back("commit", build_commit());
  });
}

std::string report_of(const SharedReport& report, std::size_t ranks) {
  std::string text = fmt::format(
      "points       {}\nsimplices    {}\nranks        {}: each places at most {} labels and knows at most {}\n"
      "perturbed    in {} colours, {} found finished; {} repair rounds moved {} points\n"
      "levels       {}\nroot         {}\n",
      report.points, report.simplices, ranks, report.most_own, report.most_here, report.colours,
      report.restored_colours, report.repair_rounds, report.repaired_points, fmt::join(report.levels, " "),
      report.root);
  for (const std::string& reason : report.reasons) text += "not reached  " + reason + "\n";
  text += fmt::format(
      "sent         {} bytes of moved points\nmemory       {:.0f} MiB of a rank at most, {:.0f} until the net is "
      "divided\n",
      report.bytes_of_perturbation, report.most_memory_mib, report.memory_of_net_mib);
  for (const auto& stage : report.stages) {
    text += fmt::format("  {:26} [{:.2f} s], of one processor [{:.2f} s]\n", stage.name, stage.seconds,
                        stage.processor_seconds);
  }
  return text;
}

ExitStatus run_ranks(MpiCommunicator& ranks, int argc, char** argv) {
  CLI::App program("One certified Delaunay triangulation by several processes, with MPI.", "delcert-ranks");
  program.set_version_flag("--version", std::string("delcert-ranks ") + version);
  program.require_subcommand(1);
  SharedOptions options;
  options.certify.threads = 1;
  add_shared_certify(program, options);
  const bool is_first = ranks.rank() == 0;
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    if (is_first) program.exit(help_or_version);
    return ExitStatus::verified;
  } catch (const CLI::ParseError& error) {
    if (is_first) std::cerr << "delcert-ranks: error: " << error.what() << std::endl;
    return ExitStatus::usage;
  }
  const auto failures = arithmetic_self_test();
  if (!failures.empty()) throw std::runtime_error("arithmetic self-test: " + failures.front());
  const ThreadLimit limit(options.certify.threads);
  const SharedReport report = certify_shared(ranks, options, no_progress());
  if (is_first) std::cout << report_of(report, ranks.size()) << std::flush;
  return ExitStatus::verified;
}

ExitStatus status_of(const std::exception& error) {
  if (dynamic_cast<const Rejection*>(&error) != nullptr) return ExitStatus::rejected;
  if (dynamic_cast<const Undecided*>(&error) != nullptr) return ExitStatus::undecided;
  if (dynamic_cast<const InputError*>(&error) != nullptr) return ExitStatus::malformed;
  return ExitStatus::internal;
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  using namespace delcert;
  MpiCommunicator ranks(argc, argv);
  try {
    return static_cast<int>(run_ranks(ranks, argc, argv));
  } catch (const std::exception& error) {
    // The others wait for this one.
    std::cerr << fmt::format("delcert-ranks: error: rank {} of {} on {}: {}", ranks.rank(), ranks.size(), host_name(),
                             error.what())
              << std::endl;
    ranks.end_all(static_cast<int>(status_of(error)));
  }
}
