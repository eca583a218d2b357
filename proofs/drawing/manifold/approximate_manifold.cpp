#include "proofs/drawing/manifold/approximate_manifold.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "proofs/drawing/manifold/ball_manifold.hpp"
#include "proofs/drawing/manifold/chart_manifold.hpp"
#include "proofs/drawing/manifold/metric_field_manifold.hpp"
#include "proofs/drawing/manifold/space_form_manifold.hpp"
#include "proofs/drawing/manifold/tangent_manifold.hpp"
#include "proofs/drawing/manifold/torus_manifold.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

std::unique_ptr<ApproximateManifold> manifold_of_family(const CertificateSummary& certificate) {
  const std::string& family = certificate.family;
  if (family == "submanifold") return std::make_unique<TangentManifold>(certificate);
  if (family == "atlas") return std::make_unique<ChartManifold>(certificate);
  if (family == "flat-torus") return std::make_unique<TorusManifold>(certificate);
  if (family == "euclidean-ball") return std::make_unique<BallManifold>(certificate);
  if (family == "metric-field") return std::make_unique<MetricFieldManifold>(certificate);
  for (const char* space_form : {"spherical", "flat", "hyperbolic"}) {
    if (family == space_form) return std::make_unique<SpaceFormManifold>(certificate);
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
