#include "proofs/drawing/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "proofs/drawing/layout.hpp"
#include "proofs/drawing/orientation.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_drawn_axes = 3;

std::vector<DrawnSimplex> simplices_of(const CertificateSummary& certificate, std::size_t m) {
  std::vector<DrawnSimplex> result;
  result.reserve(certificate.simplices.size());
  for (const std::vector<std::uint32_t>& row : certificate.simplices) {
    DrawnSimplex simplex{result.size(), {}, {}};
    if (row.size() != 2 * m + 1)
      throw InputError(fmt::format("simplices[{}] has {} numbers, not {}", result.size(), row.size(), 2 * m + 1));
    simplex.labels.assign(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(m + 1));
    simplex.elements.push_back(0);
    simplex.elements.insert(simplex.elements.end(), row.begin() + static_cast<std::ptrdiff_t>(m + 1), row.end());
    if (!std::is_sorted(simplex.labels.begin(), simplex.labels.end(), std::less_equal<>()) ||
        simplex.labels.back() >= certificate.points.size())
      throw InputError(fmt::format("simplices[{}]: labels do not increase, or there is no such label", result.size()));
    if (*std::max_element(simplex.elements.begin(), simplex.elements.end()) > certificate.elements.size())
      throw InputError(fmt::format("simplices[{}]: there is no such element", result.size()));
    result.push_back(std::move(simplex));
  }
  return result;
}

std::string geometry_of(const CertificateSummary& certificate) {
  const std::string& family = certificate.family;
  if (family == "spherical" || family == "hyperbolic") return family;
  if (family == "metric-field") return "metric";
  if (family == "atlas") return "charts";
  return family == "submanifold" ? "space" : "flat";
}

DrawingModel chosen_model(const ApproximateManifold& manifold, const std::optional<DrawingModel>& wanted,
                          const std::string& family) {
  const std::vector<DrawingModel> models = manifold.models();
  if (!wanted) return models.front();
  if (std::find(models.begin(), models.end(), *wanted) != models.end()) return *wanted;
  std::string list;
  for (const DrawingModel model : models) list += (list.empty() ? "" : ", ") + std::string(name_of(model));
  throw InputError(
      fmt::format("the family {} is not drawn in the model {}, but in: {}", family, name_of(*wanted), list));
}

MeasureBounds bounds_of(const CertificateSummary& certificate) {
  const double unit = approximate_double(certificate.parameter("sampling_radius"));
  const auto bound = [&certificate](const char* level, const char* key, double divisor) -> std::optional<double> {
    const auto margin = certificate.margin(level, key);
    if (!margin) return std::nullopt;
    return approximate_double(*margin) / divisor;
  };
  return {bound("1", "protection", unit), bound("1", "thickness", 1), bound("1", "circumradius", unit),
          bound("6", "weight", 1)};
}

/// Two coordinates or three: others are left out, or are 0.
class Projection {
 public:
  explicit Projection(std::size_t axes) : axes_(axes), drawn_(std::clamp<std::size_t>(axes, 2, most_drawn_axes)) {}
  [[nodiscard]] std::size_t drawn() const { return drawn_; }
  [[nodiscard]] std::string text() const {
    return axes_ > most_drawn_axes ? fmt::format("first {} coordinates of {}", most_drawn_axes, axes_) : "";
  }
  void append(const std::vector<double>& x, std::vector<double>& all) const {
    for (std::size_t axis = 0; axis < drawn_; ++axis) all.push_back(axis < x.size() ? x[axis] : 0);
  }

 private:
  std::size_t axes_;
  std::size_t drawn_;
};

/// Of simplices in as many coordinates as they have dimensions their volumes, of triangles in space the volumes over
/// the origin, summed up and times a constant.
double signed_volume(const Drawing& drawing) {
  const std::size_t axes = drawing.ambient_dimension;
  const auto at = [&drawing, axes](std::size_t vertex, std::size_t axis) {
    return drawing.coordinates[drawing.simplices[vertex] * axes + axis];
  };
  const std::size_t size = drawing.dimension + 1;
  double sum = 0;
  for (std::size_t first = 0; first < drawing.simplices.size(); first += size) {
    std::array<std::array<double, 3>, 3> rows{};
    for (std::size_t k = 0; k < axes; ++k) {
      const bool is_surface = drawing.dimension == 2 && axes == 3;
      for (std::size_t axis = 0; axis < axes; ++axis)
        rows[k][axis] = is_surface ? at(first + k, axis) : at(first + k + 1, axis) - at(first, axis);
    }
    if (axes == 2) {
      sum += rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    } else {
      sum += rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
             rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
             rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]);
    }
  }
  return sum;
}

}  // namespace

std::string_view name_of(DrawingCopies copies) {
  switch (copies) {
    case DrawingCopies::quotient:
      return "quotient";
    case DrawingCopies::cell:
      return "cell";
    case DrawingCopies::glued:
      return "glued";
  }
  throw std::logic_error("no such copies");
}

Drawing drawing_of(const CertificateSummary& certificate, const DrawingOptions& options) {
  const std::unique_ptr<ApproximateManifold> manifold = approximate_manifold(certificate);
  Drawing result;
  result.copies = options.copies;
  result.dimension = manifold->dimension();
  result.geometry = geometry_of(certificate);
  result.model = chosen_model(*manifold, options.model, certificate.family);
  result.bounds = bounds_of(certificate);
  const std::vector<DrawnSimplex> simplices = simplices_of(certificate, result.dimension);
  Layout layout = layout_of(*manifold, simplices, certificate.points.size(), options.copies);
  if (layout.vertices.empty()) throw InputError("there is nothing to draw");

  std::optional<Projection> projection;
  std::map<std::uint32_t, std::uint32_t> lift_of_sheet;
  for (const Layout::Vertex& vertex : layout.vertices) {
    const auto place = manifold->place(vertex.label, vertex.sheet);
    const auto drawn = place ? manifold->drawn(result.model, *place) : std::nullopt;
    if (!drawn) {
      throw InputError(
          fmt::format("the model {} does not show the point with the label {}", name_of(result.model), vertex.label));
    }
    if (!projection) projection.emplace(drawn->size());
    projection->append(*drawn, result.coordinates);
    result.labels.push_back(vertex.label);
    const auto [lift, is_new] =
        lift_of_sheet.try_emplace(vertex.sheet, static_cast<std::uint32_t>(result.lift_texts.size()));
    if (is_new) result.lift_texts.push_back(manifold->sheet_text(vertex.sheet));
    result.lifts.push_back(lift->second);
  }
  result.ambient_dimension = projection->drawn();
  result.projection = projection->text();
  for (const auto& [from, to] : manifold->domain()) {
    const auto first = manifold->drawn(result.model, from);
    const auto second = manifold->drawn(result.model, to);
    if (!first || !second) continue;
    projection->append(*first, result.domain);
    projection->append(*second, result.domain);
  }
  const FacetTable facets(layout.simplices, result.dimension + 1);
  if (options.copies == DrawingCopies::cell) result.matching_faces = matching_faces(*manifold, layout, facets);

  result.positions = std::move(layout.positions);
  result.simplices = std::move(layout.simplices);
  result.is_oriented = orient_coherently(result.simplices, result.dimension + 1, facets);
  const bool has_volume = result.projection.empty() && (result.dimension == result.ambient_dimension ||
                                                        (result.dimension == 2 && result.ambient_dimension == 3));
  if (has_volume && signed_volume(result) < 0) reverse_orientation(result.simplices, result.dimension + 1);
  if (options.is_measured) result.measures = measure_simplices(*manifold, simplices, certificate.points.size());
  return result;
}

}  // namespace delcert
