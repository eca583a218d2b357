#include "proofs/certificate/delaunay_margin.hpp"

namespace delcert {

DelaunayMargin delaunay_margin(Dimension dimension, const Rational& metric_distortion, const StarMargins& stars,
                               const Rational& edge) {
  const Rational one(1);
  const Rational m(dimension.value);
  const Rational stretch = (one + metric_distortion) / (one - metric_distortion);
  const Rational h = Rational(4) * metric_distortion * square(stars.circumradius / (one - metric_distortion));
  const Rational steepness = Rational(2) * stretch * stars.circumradius / (m * stars.thickness * edge);
  return {edge, (m + one) * h * (one + steepness), (edge + stars.protection) * stars.protection};
}

}  // namespace delcert
