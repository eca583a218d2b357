#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/growth.hpp"
#include "apps/interruption.hpp"
#include "apps/list_option.hpp"
#include "apps/other_programs.hpp"
#include "apps/progress_line.hpp"
#include "apps/search_options.hpp"
#include "kernel/number/recycled_limbs.hpp"
#include "proofs/publication/latex_table.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/ratio_guess.hpp"
#include "properties/attack/search_plan.hpp"
#include "properties/attack/twins.hpp"
#include "support/error.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

struct TightenOptions {
  SearchOptions search{4000};
  std::string log;
  bool latex = false;
  AlongOptions along;
};

const std::string& conclusion_of(const SearchTarget& target) {
  return target.claim.conclusions[target.conclusion].name;
}

std::string note_of(const Tightest& found) {
  if (is_refuted(found.verdict)) return "REFUTED";
  if (found.is_equality) return "equality, exactly";
  return is_proved(found.verdict) ? "holds" : "undecided";
}

/// What the supremum looks like; "" where both sides are the same number.
std::string guess_of(const Tightest& found) { return found.is_equality ? "" : ratio_guess(found.ratio); }

std::string note_and_guess(const Tightest& found) {
  const std::string guess = guess_of(found);
  return note_of(found) + (guess.empty() ? "" : "; " + guess + " (a guess)");
}

void print_table(const std::vector<SearchTarget>& targets, const std::vector<std::optional<Tightest>>& results) {
  std::cout << "| claim / conclusion | shape | worst ratio found | evaluations | |\n|---|---|--:|--:|---|\n";
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const auto& found = results[at];
    std::cout << fmt::format("| {} / {} | {} | {} | {} | {} |\n", targets[at].claim.name, conclusion_of(targets[at]),
                             text_of(targets[at].shape), found ? ratio_text(found->ratio) : "–",
                             found ? found->evaluations : 0,
                             found ? note_and_guess(*found) : "no instance with a ratio");
  }
}

void print_latex(const std::vector<SearchTarget>& targets, const std::vector<std::optional<Tightest>>& results) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const auto& found = results[at];
    rows.push_back({latex_label(targets[at].claim.name + " / " + conclusion_of(targets[at])),
                    latex_text(text_of(targets[at].shape)), latex_text(found ? ratio_text(found->ratio) : "–"),
                    std::to_string(found ? found->evaluations : 0),
                    found ? note_and_guess(*found) : "no instance with a ratio"});
  }
  std::cout << latex_table(
      {{"claim / conclusion", 116}, {"shape", 44}, {"worst ratio found", 60}, {"evaluations", 44}, {"", 57}}, rows);
}

void print_json(const std::vector<SearchTarget>& targets, const std::vector<std::optional<Tightest>>& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t at = 0; at < targets.size(); ++at) {
    nlohmann::ordered_json one{{"claim", targets[at].claim.name},
                               {"conclusion", conclusion_of(targets[at])},
                               {"k", targets[at].shape.k},
                               {"m", targets[at].shape.m}};
    if (const auto& found = results[at]) {
      one["lower"] = found->ratio.lower;
      one["upper"] = found->ratio.upper;
      one["evaluations"] = found->evaluations;
      one["note"] = note_of(*found);
      if (const std::string guess = guess_of(*found); !guess.empty()) one["guess"] = guess;
    }
    list.push_back(std::move(one));
  }
  std::cout << list.dump(1) << "\n";
}

std::vector<SearchTarget> targets_of(const SearchOptions& options) {
  std::vector<SearchTarget> result;
  for (const Claim& claim : claims_about_instances(options.claims)) {
    for (const Shape& shape : shapes_of(options.claims, claim)) {
      const std::uint64_t evaluations = evaluations_of(options, claim, shape);
      for (std::size_t at = 0; at < claim.conclusions.size(); ++at) result.push_back({claim, at, shape, evaluations});
    }
  }
  if (result.empty()) throw InputError("no claim is about a class with this --shape");
  return result;
}

ExitStatus run_tighten(const TightenOptions& options) {
  const RecycledLimbs recycled;
  require_evaluations(options.search);
  SearchPlan plan;
  plan.targets = targets_of(options.search);
  plan.seed = options.search.seed;
  plan.threads = threads_of(options.search);
  plan.log = options.log;
  std::vector<std::optional<Tightest>> results;
  const InterruptionDeadline deadline(options.log.empty() ? Interrupted().what()
                                                          : InterruptedWithLog(options.log).what());
  try {
    ProgressLine line;
    results = run_searches(plan, line.callback());
  } catch (const Interrupted&) {
    if (options.log.empty()) throw;
    throw InterruptedWithLog(options.log);
  }
  bool refuted = false;
  for (std::size_t at = 0; at < results.size(); ++at) {
    if (!results[at]) continue;
    refuted = refuted || is_refuted(results[at]->verdict);
    if (options.search.witnesses.empty()) continue;
    const SearchTarget& target = plan.targets[at];
    write_witness(
        options.search,
        fmt::format("{}.{}.{}-{}.json", target.claim.name, conclusion_of(target), target.shape.k, target.shape.m),
        witness_of(target.claim, target.conclusion, results[at]->bindings));
  }
  if (options.latex) {
    print_latex(plan.targets, results);
  } else {
    options.search.json ? print_json(plan.targets, results) : print_table(plan.targets, results);
  }
  return refuted ? ExitStatus::rejected : ExitStatus::verified;
}

}  // namespace

void add_tighten(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<TightenOptions>();
  CLI::App* command = add_named(program, about_tighten);
  CLI::Option* json =
      add_search_options(*command, options->search, "conclusion", "witness files of the worst instances");
  CLI::Option* log = command->add_option(
      "--log", options->log, "JSON lines, one for each finished search; the same command goes on from there");
  CLI::Option* latex =
      command->add_flag("--latex", options->latex, "Print the table in LaTeX (longtable, booktabs)")->excludes(json);
  CLI::Option* along = command->add_option("--along", options->along.quantity,
                                           "A quantity, such as thickness(s): how the worst ratio depends on it, with "
                                           "the exponent fitted; k: on the shapes");
  along->excludes(latex)->excludes(log);
  add_exact_list_option(*command, "--values", options->along.values, "The values of the quantity, such as 1/4,1/8,1/16")
      ->needs(along);
  command->footer(
      "The ratio is that of the side which the conclusion calls smaller to the other side. It is certified; above 1\n"
      "the conclusion is refuted (exit status 1).\n\n"
      "Examples:\n"
      "  delcert tighten thickness-and-singular-value --shape 2,2\n"
      "  delcert tighten --all --evaluations 20000 --log search.jsonl --witnesses worst\n"
      "  delcert tighten circumradius-under-distortion --shape 3,3 --along 'thickness(s)' --values 1/4,1/8,1/16");
  command->callback([options, &chosen] {
    chosen = [options] {
      return options->along.quantity.empty() ? run_tighten(*options) : run_growth(options->search, options->along);
    };
  });
}

}  // namespace delcert
