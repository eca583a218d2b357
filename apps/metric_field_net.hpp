#pragma once

#include <vector>

#include "apps/net_source.hpp"
#include "kernel/manifold/gluing/metric_field_atlas.hpp"

namespace delcert {

/// The net of a metric field that the options ask for: a Poisson-disk net of --radius, or the points of --points, for
/// which --radius is nominal. Throws InputError for the options of other manifolds, and what sampling and reading
/// throw.
template <int m>
[[nodiscard]] std::vector<Vector<Rational, m>> metric_field_net_of(const NetSource& source, const MetricField<m>& field,
                                                                   const Progress& progress);

}  // namespace delcert
