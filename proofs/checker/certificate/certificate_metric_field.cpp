#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

std::vector<Rational> Certificate::chart_entries(Label i) const {
  std::vector<Rational> result;
  for (std::size_t k = gluing ? 1 : 0; k < chart_size(); ++k)
    result.push_back(exact_value(chart_text[i * chart_size() + k]));
  return result;
}

void Certificate::require_metric_field() const {
  Report::require("form.ranges", !claimed[level_2s] || reach_2s.exact.sign() > 0, "reach is not positive");
  Report::require("form.ranges", !claimed[level_4] || (edge.exact.sign() > 0 && stability_margin.exact.sign() >= 0),
                  "the edge of level 4 is not positive or its margin negative");
}

/// Without the last no chart can be looked at.
void Certificate::require_affine_charts() const {
  Report::require("form.family", !theory, "the mode theory is not for affine charts");
  for (Label i = 0; i < n; ++i) {
    const std::vector<Rational> entries = chart_entries(i);
    std::size_t diagonal = 0;
    for (std::size_t row = 0; row < m_size(); diagonal += m_size() - row, ++row) {
      if (entries[diagonal].sign() <= 0)
        throw Malformed("form.charts", "the chart of " + std::to_string(i) + " has no positive diagonal");
    }
  }
}

}  // namespace delcert::checker
