#include "proofs/checker/geometry/grid.hpp"

#include <algorithm>

namespace delcert::checker {

Grid::Grid(const PointSet& points)
    : points_(&points), dimension_(static_cast<std::size_t>(points.metric().dimension())) {
  const Label n = points.size();
  std::array<double, 4> extent{1, 1, 1, 1};
  for (std::size_t k = 0; k < dimension_ && !points.periodic(); ++k) {
    double last = origin_[k] = points.position<Interval>({0, {}})[k].lower();
    for (Label i = 0; i < n; ++i) {
      const Interval x = points.position<Interval>({i, {}})[k];
      origin_[k] = std::min(origin_[k], x.lower());
      last = std::max(last, x.upper());
    }
    extent[k] = last - origin_[k];
  }
  // About as many cells as points, as cubical in the metric as boxes of the frame can be.
  double volume = 1;
  for (std::size_t k = 0; k < dimension_; ++k) volume *= extent[k] / points.metric().stretch(k);
  const double width = std::pow(volume / n, 1.0 / static_cast<double>(dimension_));
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double wanted = extent[k] / (width * points.metric().stretch(k));
    cells_[k] = wanted >= 1 ? static_cast<std::int64_t>(std::min({wanted, 1.0 * n, 0x1p20})) : 1;
  }
  const auto total = [this] {
    return 1.0 * static_cast<double>(cells_[0] * cells_[1]) * static_cast<double>(cells_[2] * cells_[3]);
  };
  while (total() > 64 + 4.0 * n) *std::max_element(cells_.begin(), cells_.end()) /= 2;
  // Of a bounding box a single cell has everything, however flat the box is.
  for (std::size_t k = 0; k < 4; ++k)
    scale_[k] = points.periodic() || cells_[k] > 1 ? static_cast<double>(cells_[k]) / extent[k] : 0;

  std::vector<std::size_t> cell_of(n);
  begin_.assign(static_cast<std::size_t>(total()) + 1, 0);
  std::vector<Vertex> stored(n);
  for (Label i = 0; i < n; ++i) {
    const Vector<Interval> x = points.position<Interval>({i, {}});
    stored[i].label = i;
    for (std::size_t k = dimension_; k-- > 0;) {
      const double turns = points.periodic() ? std::floor(x[k].lower()) : 0;
      const Interval place = scaled(k, x[k] - Interval::between(turns, turns));
      if (!(std::fabs(turns) < 0x1p30 && place.upper() - place.lower() < 0x1p-10)) {
        throw Undecided("the coordinates of label " + std::to_string(i) + " are too large");
      }
      stored[i].lift[k] = -static_cast<std::int32_t>(turns);
      const double cell = std::clamp(std::floor(place.lower()), 0.0, static_cast<double>(cells_[k] - 1));
      cell_of[i] = cell_of[i] * static_cast<std::size_t>(cells_[k]) + static_cast<std::size_t>(cell);
    }
    ++begin_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  vertices_.resize(n);
  std::vector<std::size_t> next = begin_;
  for (const Vertex& v : stored) vertices_[next[cell_of[v.label]]++] = v;
}

}  // namespace delcert::checker
