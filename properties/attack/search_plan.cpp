#include "properties/attack/search_plan.hpp"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "properties/attack/identity.hpp"
#include "properties/attack/job_log.hpp"
#include "properties/attack/job_pool.hpp"
#include "properties/attack/twins.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;
using Results = std::map<std::size_t, std::optional<Tightest>>;

/// Thrown in a thread whose result nobody waits for any more.
class Stopped {};

std::string plan_identity(const SearchPlan& plan) {
  std::string contents;
  for (const SearchTarget& target : plan.targets) {
    const auto& base = target.claim.conclusions.at(target.conclusion).base;
    contents += contents_of(target.claim, target.shape) + std::to_string(target.conclusion) + " " +
                std::to_string(target.evaluations) + (base ? " base " + base->text : "") + "\n";
  }
  return identity_of(contents, plan.seed);
}

Json line_of(std::size_t number, const SearchTarget& target, const std::optional<Tightest>& found) {
  Json result{{"target", number}};
  if (found) {
    result["evaluations"] = found->evaluations;
    result["witness"] = Json::parse(witness_text(witness_of(target.claim, target.conclusion, found->bindings)));
  }
  return result;
}

/// Adds what a line of the log says, judged anew.
void read_line(const SearchPlan& plan, const Json& line, Results& results) {
  const auto number = line.at("target").get<std::size_t>();
  if (number >= plan.targets.size()) throw InputError("target " + std::to_string(number) + " is none of this search");
  auto& result = results[number];
  if (!line.contains("witness")) return;
  const SearchTarget& target = plan.targets[number];
  const Witness witness = parse_witness(line.at("witness").dump(), "witness");
  if (witness.conclusion != target.claim.conclusions[target.conclusion].name) {
    throw InputError("the witness of another conclusion than that of target " + std::to_string(number));
  }
  result = judged(target.claim, target.conclusion, witness.bindings);
  if (!result) throw InputError("the witness of target " + std::to_string(number) + " has no ratio");
  result->evaluations = line.at("evaluations").get<std::uint64_t>();
}

std::optional<Tightest> search(const SearchTarget& target, std::uint64_t seed, const Progress& progress) {
  try {
    return tighten(target.claim, target.conclusion, target.shape, target.evaluations, seed, progress);
  } catch (const InputError& error) {
    throw InputError(target.claim.name + " (k=" + std::to_string(target.shape.k) +
                     ", m=" + std::to_string(target.shape.m) + "): " + error.what());
  }
}

}  // namespace

std::vector<std::optional<Tightest>> run_searches(const SearchPlan& plan, const Progress& progress) {
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  Results results;
  JobLog log(plan.log, "search", plan_identity(plan),
             [&](const Json& line, std::size_t) { read_line(plan, line, results); });
  std::vector<std::size_t> missing;
  for (std::size_t number = 0; number < plan.targets.size(); ++number) {
    if (!results.contains(number)) missing.push_back(number);
  }
  const std::size_t done_before = results.size();
  if (!missing.empty()) log.begin();
  std::mutex mutex;
  std::atomic<std::size_t> done = done_before;
  const Job job = [&](std::size_t at, const std::atomic<bool>& stopping) {
    const SearchTarget& target = plan.targets[missing[at]];
    auto found = search(target, plan.seed, [&stopping](std::string_view, std::size_t, std::size_t) {
      if (stopping) throw Stopped();
    });
    const std::scoped_lock lock(mutex);
    log.append(line_of(missing[at], target, found));
    ++done;
    results[missing[at]] = std::move(found);
  };
  run_jobs(missing.size(), plan.threads, job, [&] { progress("tighten", done, plan.targets.size()); });

  std::vector<std::optional<Tightest>> result;
  for (auto& [number, found] : results) result.push_back(std::move(found));
  return result;
}

}  // namespace delcert
