#include "apps/certify_options.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace delcert {

std::string star_failures_text(const std::vector<StarFailure>& failures, int repair_rounds) {
  constexpr std::size_t shown = 10;
  std::string text =
      fmt::format("nothing is certified: {} failures in stars after {} repair rounds", failures.size(), repair_rounds);
  for (std::size_t at = 0; at < std::min(failures.size(), shown); ++at)
    text += fmt::format("\n  star of {}: {}", failures[at].label.value, failures[at].reason);
  if (failures.size() > shown) text += fmt::format("\n  and {} more", failures.size() - shown);
  return text;
}

std::string disagreement_text(const std::vector<Label>& labels) {
  if (labels.empty()) return {};
  std::string text = fmt::format("\n{} stars are not in agreement with another:", labels.size());
  for (const Label label : labels) text += fmt::format(" {}", label.value);
  return text;
}

}  // namespace delcert
