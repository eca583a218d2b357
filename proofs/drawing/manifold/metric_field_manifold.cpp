#include "proofs/drawing/manifold/metric_field_manifold.hpp"

#include <algorithm>

#include "proofs/drawing/manifold/manifold_json.hpp"
#include "proofs/drawing/manifold/upper_triangle.hpp"
#include "support/error.hpp"

namespace delcert {

MetricFieldManifold::MetricFieldManifold(const CertificateSummary& certificate)
    : TorusManifold(certificate, OnlyElements()) {
  for (const auto& chart : certificate.charts) charts_.push_back(doubles_of(chart));
  const auto is_short = [this](const auto& chart) { return chart.size() != m_ * (m_ + 1) / 2; };
  if (charts_.size() != certificate.points.size() || std::any_of(charts_.begin(), charts_.end(), is_short))
    throw InputError("charts: there is not a triangular matrix for each point");
  net_ = net_of(certificate);
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::vector<double> point = doubles_of(certificate.points[label]);
    point.resize(m_);
    const std::vector<double> solution = triangle_solution(charts_[label], point);
    Vector place{1};
    for (std::size_t axis = 0; axis < m_; ++axis) place[axis + 1] = net_[label][axis] + solution[axis];
    points_.push_back(place);
  }
}

std::optional<ApproximateManifold::ChartPlace> MetricFieldManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                             std::uint32_t element) const {
  const Vector x = motions_.apply(element, points_.at(j));
  std::vector<double> difference(m_);
  for (std::size_t axis = 0; axis < m_; ++axis) difference[axis] = x[axis + 1] - net_[i][axis];
  difference = triangle_times(charts_[i], difference);
  ChartPlace result{};
  std::copy(difference.begin(), difference.end(), result.begin());
  return result;
}

}  // namespace delcert
