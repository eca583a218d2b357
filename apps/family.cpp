#include "apps/family.hpp"

namespace delcert {

std::unique_ptr<Family> family_of(const AnyManifold& manifold, StageClock& clock) {
  if (std::holds_alternative<SpaceFormDescription>(manifold)) clock.begin("verify the group");
  if (std::holds_alternative<MetricFieldDescription>(manifold)) clock.begin("verify the metric");
  return std::visit([](const auto& description) { return family_of(description); }, manifold);
}

}  // namespace delcert
