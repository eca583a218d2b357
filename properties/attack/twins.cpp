#include "properties/attack/twins.hpp"

#include <algorithm>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/claim_text.hpp"
#include "properties/attack/claim_variants.hpp"
#include "properties/attack/power.hpp"
#include "properties/attack/shrink.hpp"
#include "properties/attack/tally.hpp"
#include "properties/attack/tighten.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// What to call a claim in a witness so that a replay finds it again.
std::string reference_of(const Claim& claim) {
  const std::string original = original_name(claim);
  return claim.file == "proofs/claims/" + original + ".toml" ? original : claim.file;
}

std::uint64_t part_of(std::uint64_t amount, const Claim& claim, const Shape& shape) {
  const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(claim.instance).cost(shape));
  return (amount + cost - 1) / cost;
}

std::size_t conclusion_called(const Claim& claim, const std::string& name) {
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    if (claim.conclusions[at].name == name) return at;
  }
  throw InputError("the claim " + claim.name + " has no conclusion " + name);
}

bool is_violated(const Claim& claim, std::size_t conclusion, const Bindings& bindings) {
  const Attempt result = attempt(claim, bindings);
  return is_proved(result.hypotheses) && is_refuted(result.conclusions[conclusion].verdict);
}

/// Twice as many samples in each round, so that a claim that is refuted in a later shape is not kept waiting.
std::optional<Witness> refute_at_random(const Claim& claim, const std::vector<Shape>& shapes, const Effort& effort,
                                        const Progress& progress) {
  constexpr std::uint64_t first_round = 8;
  for (std::uint64_t first = 0, end = first_round; first < effort.samples; first = end, end *= 2) {
    for (const Shape& shape : shapes) {
      const std::uint64_t last = std::min(end, part_of(effort.samples, claim, shape));
      for (std::uint64_t number = first; number < last; ++number) {
        progress("attack", std::min(number, effort.samples), effort.samples);
        const auto instance = sample_instance(claim, shape, effort.seed, number);
        if (!instance) continue;
        const Attempt result = attempt(claim, instance->bindings);
        for (std::size_t at = 0; at < result.conclusions.size(); ++at) {
          if (is_refuted(result.conclusions[at].verdict))
            return shrunk_witness(claim, at, instance->bindings, progress);
        }
      }
    }
  }
  return std::nullopt;
}

/// Where there is no ratio to climb: a path along which the bound of a hypothesis is reached after the conclusion
/// fails.
std::optional<Witness> refute_on_paths(const Claim& claim, std::size_t conclusion, const Shape& shape,
                                       std::uint64_t evaluations, std::uint64_t seed, const Progress& progress) {
  for (const PowerPlace& place : power_places(claim)) {
    if (!place.is_hypothesis) continue;
    const Power power = power_of({claim, place, conclusion, shape, evaluations}, seed, progress);
    if (power.scale == Rational(1)) return shrunk_witness(claim, conclusion, *power.witness, progress);
  }
  return std::nullopt;
}

std::optional<Witness> refute_by_search(const Claim& claim, const std::vector<Shape>& shapes, const Effort& effort,
                                        const Progress& progress) {
  for (const Shape& shape : shapes) {
    for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
      const std::uint64_t evaluations = part_of(effort.evaluations, claim, shape);
      const auto found = tighten(claim, at, shape, evaluations, effort.seed, progress);
      if (found && is_refuted(found->verdict)) return shrunk_witness(claim, at, found->bindings, progress);
      if (found) continue;
      auto witness = refute_on_paths(claim, at, shape, evaluations, effort.seed, progress);
      if (witness) return witness;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Claim> twins_of(const Claim& claim) {
  std::vector<Claim> result;
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    if (claim.conclusions[at].twin) result.push_back(twin_of_conclusion(claim, at));
  }
  for (std::size_t at = 0; at < claim.hypotheses.size(); ++at) {
    if (claim.hypotheses[at].no_twin.empty()) result.push_back(twin_of_hypothesis(claim, at));
  }
  return result;
}

std::vector<std::string> conclusions_without_twin(const Claim& claim) {
  std::vector<std::string> result;
  for (const Conclusion& conclusion : claim.conclusions) {
    if (!conclusion.twin && conclusion.no_twin.empty()) result.push_back(conclusion.name);
  }
  return result;
}

std::string original_name(const Claim& claim) { return claim.name.substr(0, claim.name.find('/')); }

std::string twin_name(const Claim& claim) {
  const std::size_t slash = claim.name.find('/');
  return slash == std::string::npos ? "" : claim.name.substr(slash + 1);
}

Witness witness_of(const Claim& claim, std::size_t conclusion, Bindings bindings) {
  return {reference_of(claim), claim.conclusions.at(conclusion).name,
          twin_name(claim),    claim.instance,
          std::move(bindings), statement_of(claim)};
}

std::string witness_file_name(const Claim& claim, const std::string& conclusion) {
  const std::string twin = twin_name(claim);
  return original_name(claim) + "." + (twin.empty() ? conclusion : twin) + ".json";
}

void require_witness_of(const Claim& claim, const Witness& witness) {
  if (claim.instance != witness.instance_class) {
    throw InputError("the claim " + claim.name + " is about the class " + claim.instance + ", not " +
                     witness.instance_class);
  }
  (void)conclusion_called(claim, witness.conclusion);
  require_names_of(claim, witness.bindings);
}

std::string statement_of(const Claim& claim) {
  Claim named = claim;
  named.name = original_name(claim);
  return claim_text(named);
}

Claim claim_in(const Witness& witness) {
  Claim result = parse_claim(witness.text, "the text in the witness", full_vocabulary(), all_signatures());
  if (!witness.twin.empty()) result.name += "/" + witness.twin;
  require_witness_of(result, witness);
  return result;
}

Claim claim_of(const Witness& witness, const std::string& claim) {
  Claim result = find_claim(claim.empty() ? witness.claim : claim);
  if (!witness.twin.empty()) {
    std::vector<Claim> twins = twins_of(result);
    const auto twin =
        std::find_if(twins.begin(), twins.end(), [&](const Claim& one) { return twin_name(one) == witness.twin; });
    if (twin == twins.end()) throw InputError("the claim " + result.name + " has no twin " + witness.twin);
    result = std::move(*twin);
  }
  require_witness_of(result, witness);
  return result;
}

Verdict decide_witness(const Claim& claim, const Witness& witness) {
  const Attempt result = attempt(claim, witness.bindings);
  if (!is_proved(result.hypotheses)) return negation(result.hypotheses);
  return result.conclusions[conclusion_called(claim, witness.conclusion)].verdict;
}

Witness shrunk_witness(const Claim& claim, std::size_t conclusion, const Bindings& bindings, const Progress& progress) {
  const auto refutes = [&](const Bindings& candidate) {
    progress("shrink", 0, 0);
    return is_violated(claim, conclusion, candidate);
  };
  return witness_of(claim, conclusion, shrunk(instance_class(claim.instance), bindings, refutes));
}

std::optional<Witness> refute(const Claim& claim, const std::vector<Shape>& shapes, const Effort& effort,
                              const Progress& progress) {
  auto witness = refute_at_random(claim, shapes, effort, progress);
  return witness ? witness : refute_by_search(claim, shapes, effort, progress);
}

bool is_refuted_by_stored_witness(const Claim& twin, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / witness_file_name(twin, twin.conclusions.at(0).name);
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return false;
  const Witness witness = read_witness(file.string());
  try {
    if (witness.twin != twin_name(twin)) throw InputError("the witness is of another twin, " + witness.twin);
    require_witness_of(twin, witness);
    const Verdict verdict = decide_witness(twin, witness);
    if (!is_refuted(verdict)) throw InputError("does not refute " + twin.name + ": " + std::string(name_of(verdict)));
    return true;
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

}  // namespace delcert
