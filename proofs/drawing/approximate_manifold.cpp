#include "proofs/drawing/approximate_manifold.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "proofs/drawing/chart_manifold.hpp"
#include "proofs/drawing/linear_manifold.hpp"
#include "proofs/drawing/tangent_manifold.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

std::unique_ptr<ApproximateManifold> manifold_of_family(const CertificateSummary& certificate) {
  const std::string& family = certificate.family;
  if (family == "submanifold") return std::make_unique<TangentManifold>(certificate);
  if (family == "atlas") return std::make_unique<ChartManifold>(certificate);
  for (const char* linear : {"flat-torus", "euclidean-ball", "spherical", "flat", "hyperbolic", "metric-field"}) {
    if (family == linear) return std::make_unique<LinearManifold>(certificate);
  }
  throw InputError("manifold: this version does not draw the family");
}

}  // namespace

std::string_view name_of(DrawingModel model) {
  switch (model) {
    case DrawingModel::unit:
      return "unit";
    case DrawingModel::conformal:
      return "conformal";
    case DrawingModel::stereographic:
      return "stereographic";
    case DrawingModel::gnomonic:
      return "gnomonic";
    case DrawingModel::space:
      return "space";
  }
  throw std::logic_error("no such model");
}

std::unique_ptr<ApproximateManifold> approximate_manifold(const CertificateSummary& certificate) {
  try {
    return manifold_of_family(certificate);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw InputError(std::string("manifold: ") + error.what());
  } catch (const FormulaError& error) {
    throw InputError(std::string("manifold: ") + error.what());
  } catch (const std::out_of_range&) {
    throw InputError("a list of the certificate is shorter than its format says");
  }
}

}  // namespace delcert
