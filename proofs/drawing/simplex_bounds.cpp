#include "proofs/drawing/simplex_bounds.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/manifold/quotient/space_form.hpp"
#include "proofs/drawing/space_form_bounds.hpp"
#include "proofs/drawing/torus_bounds.hpp"
#include "support/error.hpp"

namespace delcert {

SimplexBounds simplex_bounds(const CertificateSummary& certificate) {
  const std::string& family = certificate.family;
  const bool is_space_form = family == "spherical" || family == "flat" || family == "hyperbolic";
  if (!is_space_form && family != "flat-torus")
    throw InputError(fmt::format(
        "bounds of each simplex are there for flat tori and space forms, and not for the family {}: the bounds of "
        "level 1 hold for all simplices",
        family));
  if (!certificate.radii.empty())
    throw InputError("bounds of each simplex are there only where the sampling radius is the same everywhere");
  const int dimension = certificate.manifold.dimension.value;
  if (dimension < 1 || dimension > 4) throw InputError("manifold: the dimension is not in 1 to 4");
  try {
    return is_space_form ? space_form_bounds(certificate) : torus_bounds(certificate);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw InputError(std::string("manifold: ") + error.what());
  }
}

}  // namespace delcert
