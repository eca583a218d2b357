#include "proofs/certification/family.hpp"

#include <fmt/format.h>

#include "proofs/certification/report_parts.hpp"
#include "support/error.hpp"

namespace delcert {

void Family::refuse_stars(std::initializer_list<std::vector<StarFailure>> failures,
                          const std::vector<Label>& disagreeing) const {
  constexpr std::size_t shown = 10;
  std::size_t count = 0;
  std::string first;
  for (const auto& some : failures) {
    for (const StarFailure& failure : some) {
      if (count++ < shown) first += fmt::format("\n  star of {}: {}", failure.label.value, failure.reason);
    }
  }
  std::string text = fmt::format("nothing is certified: {} failures in stars after {} repair rounds{}", count,
                                 report.repair_rounds, first);
  if (count > shown) text += fmt::format("\n  and {} more", count - shown);
  if (!disagreeing.empty()) text += fmt::format("\n{} stars are not in agreement with another:", disagreeing.size());
  for (const Label label : disagreeing) text += fmt::format(" {}", label.value);
  throw Rejection(text);
}

void Family::require_homology(const std::vector<std::string>& said) const {
  if (said.empty() || !report.claims.manifold) return;
  const std::vector<std::string> found = homology_texts(*report.claims.manifold);
  if (found == said) return;
  throw Rejection(
      fmt::format("the homology is {}, and not {} as the file says", fmt::join(found, ", "), fmt::join(said, ", ")));
}

std::unique_ptr<Family> family_of(const AnyManifold& manifold, StageClock& clock) {
  if (std::holds_alternative<SpaceFormDescription>(manifold)) clock.begin("verify the group");
  if (std::holds_alternative<MetricFieldDescription>(manifold)) clock.begin("verify the metric");
  if (std::holds_alternative<FormulaAtlasDescription>(manifold)) clock.begin("verify the gluing");
  return std::visit([](const auto& description) { return family_of(description); }, manifold);
}

}  // namespace delcert
