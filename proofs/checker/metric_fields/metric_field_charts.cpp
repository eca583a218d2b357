#include "proofs/checker/metric_fields/metric_field_charts.hpp"

#include <algorithm>
#include <numeric>

#include "proofs/checker/certificate/metric_field.hpp"

namespace delcert::checker {

TorusCells::TorusCells(std::size_t m, const std::vector<Vector<Interval>>& points, const std::array<double, 4>& widths)
    : m_(m) {
  std::size_t number = 1;
  for (std::size_t k = 0; k < m; ++k) {
    const double most = std::floor(std::pow(4 * static_cast<double>(points.size()) + 1, 1 / static_cast<double>(m)));
    cells_[k] = static_cast<std::int64_t>(std::clamp(std::floor(1 / widths[k]), 1.0, std::clamp(most, 1.0, 1024.0)));
    number *= static_cast<std::size_t>(cells_[k]);
  }
  std::vector<std::size_t> cell_of(points.size());
  vertices_.resize(points.size());
  begin_.assign(number + 1, 0);
  std::vector<Lift> lifts(points.size());
  for (std::size_t j = 0; j < points.size(); ++j) {
    for (std::size_t k = 0; k < m; ++k) {
      const Interval& x = points[j][k];
      if (!(x.upper() - x.lower() < slack / 4 && std::fabs(x.upper()) < 0x1p20))
        throw Undecided("label " + std::to_string(j) + " is not known well enough or too far away");
      const double turn = std::floor(x.lower());
      const double place = std::floor((x.lower() - turn) * static_cast<double>(cells_[k]));
      const auto cell = std::clamp<std::int64_t>(static_cast<std::int64_t>(place), 0, cells_[k] - 1);
      lifts[j][k] = -static_cast<std::int32_t>(turn);
      cell_of[j] = cell_of[j] * static_cast<std::size_t>(cells_[k]) + static_cast<std::size_t>(cell);
    }
    ++begin_[cell_of[j] + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t j = 0; j < points.size(); ++j) vertices_[next[cell_of[j]]++] = {static_cast<Label>(j), lifts[j]};
}

FieldCharts::FieldCharts(const Certificate& c) : AffineCharts(c) {
  for (Label i = 0; i < c.n; ++i) originals_.push_back(c.net.position<Interval>({i, {}}));
  cells_.emplace_back(c.m_size(), enclosed_points(), cell_widths());
  cells_.emplace_back(c.m_size(), originals_, cell_widths());
}

std::array<double, 4> FieldCharts::cell_widths() const {
  std::array<double, 4> sum{};
  for (Label i = 0; i < c_.n; ++i) {
    for (std::size_t k = 0; k < 4; ++k) sum[k] += stretch(i)[k];
  }
  for (double& width : sum) width = std::max(2 * c_.epsilon.filter.upper() * width / c_.n, 0x1p-10);
  return sum;
}

Vertices FieldCharts::within(const TorusCells& cells, Label i, double radius, bool perturbed) const {
  std::array<double, 4> half_widths{};
  for (std::size_t k = 0; k < c_.m_size(); ++k) half_widths[k] = radius * stretch(i)[k];
  const double most = radius * radius;
  Vertices found;
  cells.visit(originals_[i], half_widths, [&](const Vertex& v) {
    const Vector<Interval> at = perturbed ? seen<Interval>(i, v) : seen_original<Interval>(i, v);
    if (dot(at, at, c_.m_size()).lower() <= most) found.push_back(v);
  });
  std::sort(found.begin(), found.end());
  return found;
}

Vertices FieldCharts::around(Label i, double radius) const { return within(cells_[0], i, radius, true); }
Vertices FieldCharts::originals_around(Label i, double radius) const { return within(cells_[1], i, radius, false); }

ShownPoints<Rational> FieldCharts::shown(Label i, const Quantity& radius) const {
  ShownPoints<Rational> result(c_.m_size());
  Vertices vertices = around(i, radius.filter.upper());
  for (const Vertex& v : vertices) result.add(v.label, seen<Interval>(i, v));
  result.exact = [this, i, vertices = std::move(vertices)](std::size_t at) { return seen<Rational>(i, vertices[at]); };
  return result;
}

std::string FieldCharts::fault_of_patches(Level level) const {
  const Rational reach =
      level == level_1 ? c_.reach_1() + c_.rho.exact * c_.epsilon.exact : Rational(c_.reach_2s.exact);
  if (less(reach, c_.metric_field->patch_radius.exact) == Verdict::proved) return "";
  return std::string(level == level_1 ? "2 perturbation + 2 circumradius + protection" : "reach") +
         " is not below patch_radius";
}

}  // namespace delcert::checker
