#include "proofs/certification/refinement.hpp"

#include <fmt/format.h>

#include <cmath>

namespace delcert {

bool Refinement::is_no_better(std::size_t round) const {
  return round > 0 && round < size() && rounds_[round].points > 0 && rounds_[round].stage == rounds_[round - 1].stage &&
         rounds_[round].places >= rounds_[round - 1].places;
}

bool Refinement::has_stalled() const {
  constexpr std::size_t few = 50;
  if (size() == 0 || !is_no_better(size() - 1)) return false;
  return rounds_.back().places * few > rounds_.back().points || is_no_better(size() - 2);
}

std::optional<std::size_t> Refinement::rounds_left() const {
  if (size() < 2 || is_no_better(size() - 1)) return std::nullopt;
  const FailedRound &last = rounds_.back(), &before = rounds_[size() - 2];
  if (last.stage != before.stage || last.points == 0 || last.places == 0) return std::nullopt;
  const double rate = std::log(static_cast<double>(before.places) / static_cast<double>(last.places));
  return static_cast<std::size_t>(std::ceil(std::log(2 * static_cast<double>(last.places)) / rate));
}

std::string Refinement::text() const {
  if (size() == 0) return "";
  const FailedRound& last = rounds_.back();
  if (last.points == 0) return fmt::format("refined {} times, charts did not fit", size());
  std::string result =
      fmt::format("refined {} times, {} failed at {} of {} points", size(), last.stage, last.places, last.points);
  if (size() > 1 && rounds_[size() - 2].stage == last.stage)
    result += fmt::format(", at {} the time before", rounds_[size() - 2].places);
  if (const auto left = rounds_left()) result += fmt::format(", some {} more rounds", *left);
  return result;
}

std::string Refinement::reason() const {
  const FailedRound& last = rounds_.back();
  return fmt::format(
      "refinement does not help any more: after {} rounds {} fails at {} of {} points, and failed at {} of {} the "
      "round "
      "before; a smaller --radius, or a smaller first number in --sizing, may",
      size() - 1, last.stage, last.places, last.points, rounds_[size() - 2].places, rounds_[size() - 2].points);
}

}  // namespace delcert
