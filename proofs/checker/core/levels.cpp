#include "proofs/checker/core/levels.hpp"

#include "proofs/checker/core/reader.hpp"
#include "proofs/checker/core/rules.hpp"

namespace delcert::checker::core {
namespace {

/// The theorem of Dyer, Vegter and Wintraecken; the injectivity radius is that of the group.
void check_riemannian(Complex& complex, const Certificate& c, Report& report) {
  const Rational& radius = c.riemannian_radius.exact;
  const SpaceForm& form = *c.space_form;
  if (less(form.injectivity_radius.exact, Rational(4) * radius) == Verdict::proved ||
      (form.K != 0 && less(c.riemannian_thickness.exact, Rational(6) * radius) == Verdict::proved)) {
    report.reject("5.radius", [] { return "radius is more than injectivity radius / 4 or thickness / 6"; });
  }
  check_riemannian_simplices(complex, c.riemannian_thickness, c.riemannian_radius, report);
}

}  // namespace

std::string check_levels(const Certificate& c, const std::array<bool, level_names.size()>& chosen, Report& report) {
  const Data data = data_of(c);
  if (!are_isometries(data, report)) return "the generators are no isometries";
  Complex complex(data);
  check_manifold(complex, report);
  check_quotient(complex, report);
  if (chosen[level_4]) check_hinges(complex, report);
  if (c.space_form) {
    if (chosen[level_4]) check_margins(complex, c.ball_radius, c.empty_margin, report);
    if (chosen[level_5] && c.riemannian_simplices) check_riemannian(complex, c, report);
    if (chosen[level_6] && c.self_delaunay) check_cotangents(complex, c.weight, report);
    if (chosen[level_6]) check_stretching(complex, c.least_stretch, c.greatest_stretch, report);
  }
  return std::to_string(data.simplices()) + " simplices, " + std::to_string(complex.hinges.size()) + " facets, " +
         std::to_string(data.loops.size()) + " loops";
}

}  // namespace delcert::checker::core
