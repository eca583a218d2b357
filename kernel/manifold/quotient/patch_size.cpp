#include "kernel/manifold/quotient/patch_size.hpp"

#include <algorithm>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

std::string about(const Rational& x) { return std::to_string(approximate_double(x)); }

Rational quarter_turn_lower() { return half_turn().lower() / Rational(2); }

/// A sampling radius that is not refused for patches of this factor, and hardly less than the largest.
std::string accepted_radius(const SpaceForm& form, int factor) {
  const Rational for_lifts = simple_fraction_at_most(form.injectivity_radius.lower / Rational(factor + 3));
  if (form.form().curvature() != Curvature::positive) return exact_text(for_lifts);
  return exact_text(std::min(for_lifts, simple_fraction_below(quarter_turn_lower() / Rational(factor))));
}

/// Why patches of this factor are not small enough; empty if they are.
std::string complaint(const SpaceForm& form, const Rational& sampling_radius, int factor) {
  const std::string& name = form.description.name;
  const Rational& least = form.injectivity_radius.lower;
  const Rational needed = Rational(factor + 3) * sampling_radius;
  if (needed > least)
    return name + ": " + std::to_string(factor + 3) + " sampling radii are about " + about(needed) +
           ", more than the injectivity radius, of which about " + about(least) +
           " is certified: take a sampling radius of at most " + accepted_radius(form, factor);
  if (form.form().curvature() != Curvature::positive) return {};
  const Rational patch = Rational(factor) * sampling_radius;
  if (patch < quarter_turn_lower()) return {};
  return name + ": patches of radius about " + about(patch) +
         " are no smaller than half of the sphere: take a sampling radius of at most " + accepted_radius(form, factor);
}

void require_radius(const SpaceForm& form, int dimension, const Rational& sampling_radius) {
  const std::string& name = form.description.name;
  if (form.form().dimension() != dimension)
    throw InputError(name + " has dimension " + std::to_string(form.form().dimension()) + ", expected " +
                     std::to_string(dimension));
  if (sampling_radius <= Rational(0)) throw InputError(name + ": the sampling radius is not above 0");
}

}  // namespace

void require_small_patches(const SpaceForm& form, int dimension, const Rational& sampling_radius, int factor) {
  require_radius(form, dimension, sampling_radius);
  const std::string reason = complaint(form, sampling_radius, factor);
  if (!reason.empty()) throw Rejection(reason);
}

int fitting_patch_factor(const SpaceForm& form, int dimension, const Rational& sampling_radius) {
  require_radius(form, dimension, sampling_radius);
  for (const int factor : patch_factors) {
    if (complaint(form, sampling_radius, factor).empty()) return factor;
  }
  throw Rejection(complaint(form, sampling_radius, patch_factors.back()));
}

}  // namespace delcert
