#pragma once

#include <string>

#include "proofs/checker/metric_fields/metric_field_charts.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// The rules field.*, whatever level is looked at.
std::string check_metric_field(const FieldCharts& charts, Report& report);

/// Level 4 of metric fields, as those of run.hpp. Levels 1 and 2s are those of chart_stars.hpp, 2 is that of all
/// families, and 5 follows.
std::string check_delaunay_of_metric_field(const FieldCharts& charts, Report& report);

}  // namespace delcert::checker
