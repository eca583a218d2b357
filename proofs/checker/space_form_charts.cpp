#include "proofs/checker/space_form_charts.hpp"

namespace delcert::checker {
namespace {

/// From conformal coordinates.
template <class N>
Vector<N> in_chart(const Certificate& c, const Vector<N>& a) {
  return add(Vector<N>{}, logarithm_factor(c.space_form->K, squared(a, c.m_size()) / N(4)), a);
}

}  // namespace

ShownPoints<Ball> SpaceFormCharts::shown(Label i, const Quantity& radius) const {
  ShownPoints<Ball> result(c_.m_size());
  std::vector<Seen> seen = lifts_.around(i, radius.exact);
  for (const Seen& lift : seen) result.add(lift.label, in_chart(c_, lift.conformal));
  result.exact = [this, i, seen = std::move(seen)](std::size_t at) {
    return in_chart(c_, lifts_.conformal_about<Ball>(i, seen[at]));
  };
  return result;
}

/// A chart shows one lift of a label at most within 9 epsilon and the injectivity radius.
std::string SpaceFormCharts::fault_of_patches(Level level) const {
  const Rational reach = level == level_1 ? c_.reach_1() : c_.reach_2s.exact;
  if (less(reach, Rational(9) * c_.epsilon.exact) == Verdict::proved &&
      less(reach, c_.space_form->injectivity_radius.exact) == Verdict::proved)
    return "";
  return std::string(level == level_1 ? "perturbation + 2 circumradius + protection" : "reach") +
         " is not below 9 epsilon and the injectivity radius";
}

}  // namespace delcert::checker
