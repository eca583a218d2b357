#include "properties/attack/tighten.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/attack_report.hpp"
#include "apps/claim_options.hpp"
#include "apps/commands.hpp"
#include "apps/progress_line.hpp"
#include "kernel/error.hpp"
#include "proofs/certificate/atomic_file.hpp"
#include "properties/attack/twins.hpp"

namespace delcert {

namespace {

struct TightenOptions {
  ClaimOptions claims;
  std::uint64_t evaluations = 4000;
  std::uint64_t seed = 0;
  std::string witnesses;
  bool json = false;
};

struct Row {
  std::string claim;
  std::string conclusion;
  Shape shape;
  std::optional<Tightest> found;
};

void write_witness(const Claim& claim, const Row& row, std::size_t conclusion, const std::string& folder) {
  const Witness witness = witness_of(claim, conclusion, row.found->bindings);
  const std::string name = fmt::format("{}.{}.{}-{}.json", claim.name, row.conclusion, row.shape.k, row.shape.m);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw InputError("--witnesses " + folder + ": " + failure.message());
  write_file_atomically(std::filesystem::path(folder) / name, witness_text(witness));
}

std::string note_of(const Tightest& found) {
  if (is_refuted(found.verdict)) return "REFUTED";
  if (found.is_equality) return "equality, exactly";
  return is_proved(found.verdict) ? "holds" : "undecided";
}

void print(const std::vector<Row>& rows, bool json) {
  if (!json) std::cout << "| claim / conclusion | shape | worst ratio found | evaluations | |\n|---|---|--:|--:|---|\n";
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    if (json) {
      nlohmann::ordered_json one{
          {"claim", row.claim}, {"conclusion", row.conclusion}, {"k", row.shape.k}, {"m", row.shape.m}};
      if (row.found) {
        one["lower"] = row.found->ratio.lower;
        one["upper"] = row.found->ratio.upper;
        one["evaluations"] = row.found->evaluations;
        one["note"] = note_of(*row.found);
      }
      list.push_back(std::move(one));
    } else {
      std::cout << fmt::format("| {} / {} | {} | {} | {} | {} |\n", row.claim, row.conclusion, text_of(row.shape),
                               row.found ? ratio_text(row.found->ratio) : "–", row.found ? row.found->evaluations : 0,
                               row.found ? note_of(*row.found) : "no instance with a ratio");
    }
  }
  if (json) std::cout << list.dump(1) << "\n";
}

ExitStatus run_tighten(const TightenOptions& options) {
  constexpr std::uint64_t most = 1000000000000;
  if (options.evaluations == 0 || options.evaluations > most) throw InputError("--evaluations wants 1 to 10^12");
  std::vector<Row> rows;
  bool refuted = false;
  {
    ProgressLine line;
    for (const Claim& claim : claims_about_instances(options.claims)) {
      for (const Shape& shape : shapes_of(options.claims, claim)) {
        const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(claim.instance).cost(shape));
        const std::uint64_t evaluations = std::max<std::uint64_t>(1, options.evaluations / cost);
        for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
          Row row{claim.name, claim.conclusions[at].name, shape,
                  tighten(claim, at, shape, evaluations, options.seed, line.callback())};
          refuted = refuted || (row.found && is_refuted(row.found->verdict));
          if (row.found && !options.witnesses.empty()) write_witness(claim, row, at, options.witnesses);
          rows.push_back(std::move(row));
        }
      }
    }
  }
  if (rows.empty()) throw InputError("no claim is about a class with this --shape");
  print(rows, options.json);
  return refuted ? ExitStatus::rejected : ExitStatus::verified;
}

}  // namespace

void add_tighten(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<TightenOptions>();
  CLI::App* command =
      program.add_subcommand("tighten", "Search for the instances that come nearest to refuting a claim");
  add_claim_options(*command, options->claims);
  command->add_option("--evaluations", options->evaluations,
                      "Instances to try for each conclusion and shape (default 4000; less where one is costly)");
  command->add_option("--seed", options->seed, "Seed of the search (default 0)");
  command->add_option("--witnesses", options->witnesses, "Folder for witness files of the worst instances");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "The ratio is that of the smaller side to the larger one as the conclusion has them, certified; above 1 the\n"
      "conclusion is refuted (exit status 1).\n\n"
      "Examples:\n"
      "  delcert tighten thickness-and-singular-value --shape 2,2\n"
      "  delcert tighten --all --evaluations 20000 --witnesses worst");
  command->callback([options, &chosen] { chosen = [options] { return run_tighten(*options); }; });
}

}  // namespace delcert
