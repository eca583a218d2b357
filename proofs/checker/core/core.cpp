#include "proofs/checker/core/core.hpp"

#include "proofs/checker/core/chunk_view.hpp"
#include "proofs/checker/core/reader.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/parts.hpp"

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

Core::Core(const Certificate& c) : c_(c), data_(data_of(c)) {}

void Core::check_manifold(Report& report) {
  if (!are_isometries(data_, report)) return;
  complex_.emplace(data_);
  core::check_manifold(*complex_, report);
  if (c_.chunk != nullptr) c_.chunk->check_border(report);
}

void Core::check_quotient(Report& report) {
  if (!quotient_) {
    Report found;
    if (c_.chunk != nullptr) {
      c_.chunk->check_loops(*complex_, found);  // core.connected is left to those who put receipts together
    } else {
      core::check_quotient(*complex_, found);
    }
    quotient_ = std::move(found);
  }
  report.add(*quotient_);
}

FlatSimplices* Core::flat() {
  if (!flat_ && FlatSimplices::are(data_)) flat_.emplace(*complex_);
  return flat_ ? &*flat_ : nullptr;
}

bool Core::is_delaunay() {
  if (!hinges_) {
    Report found;
    if (c_.chunk != nullptr && !c_.claimed[level_4]) return false;
    std::optional<Undivided> undivided;
    if (!c_.claimed[level_4]) undivided.emplace();  // no level says in which parts it holds
    check_hinges(*complex_, flat(), found);
    hinges_ = std::move(found);
  }
  return hinges_->findings.empty();
}

bool Core::is_delaunay_quotient() {
  Report found;
  check_quotient(found);
  return found.findings.empty() && is_delaunay();
}

std::string Core::check_delaunay(Report& report) {
  check_quotient(report);
  is_delaunay();
  report.add(*hinges_);
  const std::string text = "{facets} facets locally Delaunay";
  if (!c_.space_form) return text;
  check_margins(*complex_, c_.ball_radius, c_.empty_margin, report);
  return text + ", circumradius <= " + rounded_up(c_.ball_radius.exact) + ", all other points farther than " +
         rounded_down(c_.empty_margin.exact);
}

std::string Core::check_triangulation(Report& report) {
  check_quotient(report);
  std::string text =
      "a connected complex with a loop for each of " + std::to_string(data_.generators.size()) + " generators";
  if (!c_.riemannian_simplices) return text;
  check_riemannian(*complex_, c_, report);
  return text + "; Riemannian simplices of thickness >= " + rounded_down(c_.riemannian_thickness.exact) + " within " +
         rounded_up(c_.riemannian_radius.exact);
}

std::string Core::check_metric(Report& report) {
  if (!c_.space_form) return "follows from levels 4 and 5";
  if (c_.self_delaunay) check_cotangents(*complex_, c_.weight, report);
  check_stretching(*complex_, c_.least_stretch, c_.greatest_stretch, report);
  return std::string(c_.self_delaunay ? "self-Delaunay, " : "") + "distances stretched by " +
         rounded_down(c_.least_stretch.exact) + " to " + rounded_up(c_.greatest_stretch.exact);
}

}  // namespace delcert::checker::core
