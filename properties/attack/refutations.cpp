#include "properties/attack/refutations.hpp"

#include <set>
#include <utility>

#include "properties/attack/twins.hpp"

namespace delcert {

std::vector<FoundRefutation> refutations_in(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                            std::uint64_t seed, const Progress& progress) {
  std::vector<FoundRefutation> result;
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const Claim& claim = targets[at].claim;
    for (std::size_t conclusion = 0; conclusion < tallies[at].conclusions.size(); ++conclusion) {
      const ConclusionTally& tally = tallies[at].conclusions[conclusion];
      if (tally.violated == 0 || !seen.emplace(claim.name, claim.conclusions[conclusion].name).second) continue;
      const auto instance = sample_instance(claim, targets[at].shape, seed, tally.first_violation);
      result.push_back({at, conclusion, tally.first_violation,
                        shrunk_witness(claim, conclusion, instance.value().bindings, progress)});
    }
  }
  return result;
}

}  // namespace delcert
