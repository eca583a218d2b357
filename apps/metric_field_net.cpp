#include "kernel/sample/metric_field_net.hpp"

#include <algorithm>

#include "apps/metric_field_net.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/point_file.hpp"
#include "support/error.hpp"

namespace delcert {

template <int m>
std::vector<Vector<Rational, m>> metric_field_net_of(const NetSource& source, const MetricField<m>& field,
                                                     const Progress& progress) {
  if (source.lattice || source.icosphere_frequency || source.relaxation_steps > 0)
    throw InputError("--lattice, --icosphere and --relax are not for metric fields: give --radius or --points");
  if (!source.radius) throw InputError("no net: give --radius, or with it --points");
  if (*source.radius <= Rational(0)) throw InputError("--radius " + exact_text(*source.radius) + " is not above 0");
  if (source.points_file.empty()) return metric_field_net<m>(field, *source.radius, source.seed, progress).centres;
  std::vector<Vector<Rational, m>> result;
  for (const auto& point : read_points(source.points_file, Dimension(m))) {
    result.emplace_back();
    std::copy(point.begin(), point.end(), result.back().begin());
  }
  return result;
}

template std::vector<Vector<Rational, 2>> metric_field_net_of<2>(const NetSource&, const MetricField<2>&,
                                                                 const Progress&);
template std::vector<Vector<Rational, 3>> metric_field_net_of<3>(const NetSource&, const MetricField<3>&,
                                                                 const Progress&);

}  // namespace delcert
