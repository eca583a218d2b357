#include "kernel/manifold/gluing/piecewise_cells.hpp"

#include <algorithm>

namespace delcert {

PiecewiseCells::PiecewiseCells(const std::vector<CellMap>& pieces) : m_(pieces.front().dimension()) {
  for (const CellMap& piece : pieces) evaluations_.emplace_back(piece);
}

MapOnCell PiecewiseCells::on(const Cell& cell) {
  if (evaluations_.size() == 1) return evaluations_.front().on(cell);
  MapOnCell result;
  bool is_first = true;
  for (CellMapEvaluation& evaluation : evaluations_) {
    MapOnCell found = evaluation.on(cell);
    if (found.is_elsewhere) continue;
    if (!is_first) {
      found.is_positive = found.is_positive && result.is_positive;
      found.is_regular = found.is_regular && result.is_regular;
      found.is_excluded = found.is_excluded && result.is_excluded;
      found.has_image = found.has_image && result.has_image;
      for (std::size_t axis = 0; axis < m_; ++axis)
        found.image[axis] = Interval::between(std::min(found.image[axis].lower(), result.image[axis].lower()),
                                              std::max(found.image[axis].upper(), result.image[axis].upper()));
    }
    found.is_here = true;
    result = found;
    is_first = false;
  }
  return result;
}

bool PiecewiseCells::are_unrelated(const Cell& here, const Cell& there) {
  return std::all_of(evaluations_.begin(), evaluations_.end(), [&](CellMapEvaluation& evaluation) {
    const MapOnCell found = evaluation.on(here);
    if (found.is_elsewhere) return true;
    for (std::size_t axis = 0; axis < m_; ++axis) {
      const Interval rest = found.denominators[axis] * there[axis] - found.numerators[axis];
      if (rest.lower() > 0 || rest.upper() < 0) return true;
    }
    return false;
  });
}

}  // namespace delcert
