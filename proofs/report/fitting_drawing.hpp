#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "proofs/drawing/drawing.hpp"
#include "proofs/report/packed_drawing.hpp"

namespace delcert {

/// How many bytes the data of one certificate may take in a page, by the number of its simplices, and how many of these
/// the page has at most.
struct PageBudget {
  std::size_t bytes_at_least = 600000;
  std::size_t bytes_a_simplex = 9;
  std::size_t bytes_at_most = 4800000;
  std::size_t simplices = 500000;
  [[nodiscard]] std::size_t bytes(std::size_t simplex_count) const {
    return std::min(bytes_at_least + bytes_a_simplex * simplex_count, bytes_at_most);
  }
};

struct FittingDrawing {
  PackedDrawing packed;
  std::vector<std::string> notes;  ///< what was left out, for the reader of the page
};

/// As much of a drawing as fits into the budget: first details are left out, from exact coordinates to circumradii,
/// then simplices, as in `decimated`. What is left at last are the stars around the worst simplices without details,
/// which a page has even where the budget is smaller. `exact`: the coordinates of each label, as `packed_drawing` takes
/// them.
[[nodiscard]] FittingDrawing fitting_drawing(const Drawing& whole, const std::vector<std::string>& exact,
                                             const PageBudget& budget = {});

}  // namespace delcert
