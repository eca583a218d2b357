#include "proofs/constants/riemannian_demand.hpp"

#include <algorithm>

namespace delcert {

namespace {

Rational quotient(const Rational& x, long divisor) { return x / Rational(divisor); }

}  // namespace

RiemannianDemand riemannian_demand(const Ledger& ledger, const MeasuredNet& net) {
  RiemannianDemand result;
  result.printed_radius = PowerProduct(quotient(net.injectivity_radius, 4));
  result.mended_radius = PowerProduct(quotient(net.injectivity_radius, 20));
  if (net.curvature != 0) {
    const PowerProduct& by_curvature = ledger.riemannian_sampling_radius;
    result.printed_radius = std::min(result.printed_radius, by_curvature);
    result.mended_radius = std::min(result.mended_radius, by_curvature);
  }
  result.is_met = PowerProduct(net.sampling_radius) <= result.mended_radius;

  // With V(r) the volume of a ball in the space of this curvature and b ≤ a, V(a)/V(b) ≥ (a/b)ᵐ where the curvature is
  // not positive; on a sphere times (sin a/a)^{m − 1} ≥ (1 − a²/6)^{m − 1}.
  const long m = ledger.dimension.value;
  const Rational a = quotient(ledger.separation * net.sampling_radius, 2);
  Rational balls = Rational(static_cast<long>(net.points)) * power(a, m);
  if (net.curvature > 0) balls *= power(Rational(1) - quotient(square(a), 6), m - 1);
  result.least_points = PowerProduct(balls) / power(result.printed_radius, m);
  return result;
}

}  // namespace delcert
