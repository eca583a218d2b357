#include "proofs/report/fitting_drawing.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "proofs/report/decimation.hpp"

namespace delcert {

namespace {

/// From the most to the least that a page says of each simplex, with the note that goes with it.
struct DetailChoice {
  PackingDetail detail;
  const char* note;
};

constexpr std::array<DetailChoice, 4> choices{{
    {{2, true, true}, ""},
    {{2, false, true}, "To keep this page small, exact coordinates are left out; the certificate has them."},
    {{1, false, true},
     "To keep this page small, exact coordinates are left out, and measures of single simplices are rounded to one of "
     "254 values; the certificate has what they come from."},
    {{1, false, false},
     "To keep this page small, exact coordinates, circumradii and hinges of single simplices are left out, and other "
     "measures are rounded to one of 254 values; the certificate has what they come from."},
}};

std::size_t size_of(const PackedDrawing& packed) { return packed.block.size() + packed.description.dump().size(); }

FittingDrawing noted(PackedDrawing packed, const char* note, std::size_t kept, std::size_t all) {
  FittingDrawing result{std::move(packed), {}};
  if (*note != '\0') result.notes.emplace_back(note);
  if (kept < all) {
    result.notes.push_back(
        fmt::format("To keep this page small, it has {} of the {} simplices: those that share a point with one of "
                    "the ten worst of each measure, so that their stars are whole, and an even part of the others, "
                    "whose stars are not. Levels and margins are those of all.",
                    kept, all));
  }
  return result;
}

}  // namespace

FittingDrawing fitting_drawing(const Drawing& whole, const std::vector<std::string>& exact, const PageBudget& budget) {
  const std::size_t allowed = budget.bytes(whole.simplex_count());
  std::size_t most = budget.simplices;
  while (true) {
    const Drawing part = decimated(whole, most);
    const std::size_t count = part.simplex_count();
    PackedDrawing packed;
    for (const auto& [detail, note] : choices) {
      // A part is left for want of room, so it has the least detail.
      if (most < budget.simplices && &note != &choices.back().note) continue;
      packed = packed_drawing(part, exact, detail);
      if (size_of(packed) <= allowed) return noted(std::move(packed), note, count, whole.simplex_count());
    }
    // More simplices than allowed: only the stars of the worst remain.
    if (count > most || most == 0) return noted(std::move(packed), choices.back().note, count, whole.simplex_count());
    // As many as would fit if each took as much, less a fortieth: fewer of them are farther from each other.
    const auto fitting =
        static_cast<double>(count) * static_cast<double>(allowed) / static_cast<double>(size_of(packed));
    most = std::min(count - 1, static_cast<std::size_t>(fitting * 39 / 40));
  }
}

}  // namespace delcert
