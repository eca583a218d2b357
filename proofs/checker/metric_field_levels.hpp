#pragma once

#include <string>

#include "proofs/checker/metric_field_charts.hpp"
#include "proofs/checker/report.hpp"

namespace delcert::checker {

/// The rules field.*, whatever level is looked at.
std::string check_metric_field(const AffineCharts& charts, Report& report);

// The levels of metric fields other than 2, which is that of all families, and 5, which follows. As those of run.hpp.
std::string check_stars_of_metric_field(const AffineCharts& charts, Report& report);         // 1
std::string check_stable_stars_of_metric_field(const AffineCharts& charts, Report& report);  // 2s
std::string check_delaunay_of_metric_field(const AffineCharts& charts, Report& report);      // 4

}  // namespace delcert::checker
