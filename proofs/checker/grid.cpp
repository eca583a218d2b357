#include "proofs/checker/grid.hpp"

#include <algorithm>
#include <cmath>

namespace delcert::checker {

Grid::Grid(const PointSet& points) : points_(&points), dimension_(static_cast<std::size_t>(points.dimension())) {
  const Label n = points.size();
  std::array<double, 4> extent{1, 1, 1, 1};
  if (!points.periodic()) {
    std::array<double, 4> high{};
    for (Label i = 0; i < n; ++i) {
      const Vector<Interval> x = points.position<Interval>({i, {}});
      for (std::size_t k = 0; k < dimension_; ++k) {
        origin_[k] = i == 0 ? x[k].lower() : std::min(origin_[k], x[k].lower());
        high[k] = i == 0 ? x[k].upper() : std::max(high[k], x[k].upper());
      }
    }
    for (std::size_t k = 0; k < dimension_; ++k) extent[k] = std::max(high[k] - origin_[k], 0x1p-500);
  }
  // Cells as cubical in the metric as boxes of the frame can be, about as many as points.
  double volume = 1;
  for (std::size_t k = 0; k < dimension_; ++k) volume *= extent[k] / points.metric().stretch(k);
  const double width = std::pow(volume / std::max<double>(n, 1), 1.0 / static_cast<double>(dimension_));
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double wanted = extent[k] / (width * points.metric().stretch(k));
    cells_[k] = wanted >= 1 ? static_cast<std::int64_t>(std::min(wanted, std::min<double>(n, 0x1p20))) : 1;
  }
  const auto total = [this] {
    return static_cast<double>(cells_[0] * cells_[1]) * static_cast<double>(cells_[2] * cells_[3]);
  };
  while (total() > 64 + 4.0 * n) *std::max_element(cells_.begin(), cells_.end()) /= 2;
  for (std::size_t k = 0; k < dimension_; ++k) scale_[k] = static_cast<double>(cells_[k]) / extent[k];
  const auto number = static_cast<std::size_t>(total());

  std::vector<std::size_t> cell_of(n);
  std::vector<Vertex> stored(n);
  begin_.assign(number + 1, 0);
  for (Label i = 0; i < n; ++i) {
    const Vector<Interval> x = points.position<Interval>({i, {}});
    stored[i].label = i;
    for (std::size_t k = dimension_; k-- > 0;) {
      const double turns = points.periodic() ? std::floor(x[k].lower()) : 0;
      if (!(std::fabs(turns) < 0x1p30)) throw Undecided("a coordinate of label " + std::to_string(i) + " is too large");
      stored[i].lift[k] = -static_cast<std::int32_t>(turns);
      const Interval place = scaled(k, x[k] - Interval(static_cast<std::int32_t>(turns)));
      if (!(place.upper() - place.lower() < 0x1p-10))
        throw Undecided("the coordinates of label " + std::to_string(i) + " are too large");
      const double cell = std::clamp(std::floor(place.lower()), 0.0, static_cast<double>(cells_[k] - 1));
      cell_of[i] = cell_of[i] * static_cast<std::size_t>(cells_[k]) + static_cast<std::size_t>(cell);
    }
    ++begin_[cell_of[i] + 1];
  }
  for (std::size_t c = 0; c < number; ++c) begin_[c + 1] += begin_[c];
  vertices_.resize(n);
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (Label i = 0; i < n; ++i) vertices_[next[cell_of[i]]++] = stored[i];
}

}  // namespace delcert::checker
