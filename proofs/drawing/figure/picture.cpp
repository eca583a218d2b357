#include "proofs/drawing/figure/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "proofs/drawing/formats/cell_data.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr Figure::Colour colour_of_domain{200, 16, 46};
constexpr Figure::Colour colour_of_worst{230, 120, 0};
constexpr Figure::Colour colour_of_curve{28, 74, 122};
constexpr Figure::Colour colour_of_ground{255, 255, 255};
constexpr double width_of_curve = 2.5;
constexpr double width_of_gap = 11;  ///< around an edge of a curve, in what is behind it

class Picture {
 public:
  Picture(const Drawing& drawing, const PictureOptions& options)
      : drawing_(drawing),
        axes_(drawing.ambient_dimension),
        corners_(drawing.dimension + 1),
        shares_(is_curve() ? std::vector<double>() : shares(drawing, options.measure)) {}

  Figure figure(const PictureOptions& options) {
    Figure result;
    const std::vector<std::size_t> shown = visible();
    for (const std::size_t simplex : shown) {
      if (is_curve()) {
        add_edge(result, simplex);
      } else {
        result.paths.push_back(triangle(simplex));
      }
    }
    if (is_curve()) add_vertices(result);
    Figure::Path outline{{}, false, std::nullopt, colour_of_domain, 2};
    for (std::size_t at = 0; at + 2 * axes_ <= drawing_.domain.size(); at += 2 * axes_) {
      outline.lines.push_back({{drawing_.domain[at], drawing_.domain[at + 1]},
                               {drawing_.domain[at + axes_], drawing_.domain[at + axes_ + 1]}});
    }
    if (!outline.lines.empty()) result.paths.push_back(outline);
    result.description = is_curve() ? fmt::format("{} edges", shown.size())
                                    : fmt::format("{} triangles, shaded by {}", shown.size(), options.measure);
    if (options.has_worst_star) add_worst_star(result, shown);
    if (options.has_scale && has_lengths()) result.scale = round_scale(extent(shown) / 4);
    return result;
  }

 private:
  [[nodiscard]] double coordinate(std::size_t simplex, std::size_t corner, std::size_t axis) const {
    return drawing_.coordinates[drawing_.simplices[corners_ * simplex + corner] * axes_ + axis];
  }
  [[nodiscard]] std::uint32_t label(std::size_t simplex, std::size_t corner) const {
    return drawing_.labels[drawing_.simplices[corners_ * simplex + corner]];
  }
  [[nodiscard]] std::uint32_t least_label(std::size_t simplex) const {
    std::uint32_t result = label(simplex, 0);
    for (std::size_t corner = 1; corner < corners_; ++corner) result = std::min(result, label(simplex, corner));
    return result;
  }
  [[nodiscard]] double area(std::size_t simplex) const {
    const auto edge = [this, simplex](std::size_t corner, std::size_t axis) {
      return coordinate(simplex, corner, axis) - coordinate(simplex, 0, axis);
    };
    return edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0);
  }
  [[nodiscard]] double height(std::size_t simplex) const {
    double sum = 0;
    for (std::size_t corner = 0; corner < corners_; ++corner) sum += coordinate(simplex, corner, 2);
    return sum;
  }
  [[nodiscard]] bool is_curve() const { return corners_ == 2; }
  [[nodiscard]] bool has_lengths() const {
    return drawing_.geometry == "flat" || drawing_.geometry == "space" ||
           (drawing_.geometry == "spherical" && drawing_.model == DrawingModel::unit);
  }

  /// All triangles, or those of a surface in space that face the eye, from the farthest to the nearest.
  [[nodiscard]] std::vector<std::size_t> visible() const {
    std::vector<std::size_t> result(drawing_.simplex_count());
    std::iota(result.begin(), result.end(), std::size_t{0});
    if (axes_ == 2) return result;
    if (drawing_.is_oriented && !is_curve())
      std::erase_if(result, [this](std::size_t simplex) { return area(simplex) <= 0; });
    std::stable_sort(result.begin(), result.end(),
                     [this](std::size_t a, std::size_t b) { return height(a) < height(b); });
    return result;
  }

  [[nodiscard]] double extent(const std::vector<std::size_t>& shown) const {
    double lowest = 0;
    double highest = 0;
    for (std::size_t at = 0; at < corners_ * shown.size(); ++at) {
      const double x = coordinate(shown[at / corners_], at % corners_, 0);
      lowest = at == 0 ? x : std::min(lowest, x);
      highest = at == 0 ? x : std::max(highest, x);
    }
    return highest > lowest ? highest - lowest : 1;
  }

  [[nodiscard]] std::vector<Figure::Point> corners(std::size_t simplex) const {
    std::vector<Figure::Point> result;
    for (std::size_t corner = 0; corner < corners_; ++corner)
      result.push_back({coordinate(simplex, corner, 0), coordinate(simplex, corner, 1)});
    return result;
  }

  [[nodiscard]] Figure::Path triangle(std::size_t simplex) const {
    const double share = shares_[simplex];
    const auto shade = [share](double lightest, double range) {
      return static_cast<int>(std::lround(lightest + range * share));
    };
    return {{corners(simplex)}, true, Figure::Colour{shade(250, -150), shade(240, -70), shade(220, 10)}};
  }

  /// In space with a gap around it in what has been drawn.
  void add_edge(Figure& result, std::size_t simplex) const {
    if (axes_ == 3) {
      result.paths.push_back({{corners(simplex)}, false, std::nullopt, colour_of_ground, width_of_gap});
    }
    result.paths.push_back({{corners(simplex)}, false, std::nullopt, colour_of_curve, width_of_curve});
  }

  void add_vertices(Figure& result) const {
    for (std::size_t vertex = 0; vertex < drawing_.vertex_count(); ++vertex) {
      result.dots.push_back({{drawing_.coordinates[vertex * axes_], drawing_.coordinates[vertex * axes_ + 1]},
                             vertex_radius(),
                             colour_of_curve});
    }
  }
  /// In pixels: smaller where there are many.
  [[nodiscard]] double vertex_radius() const { return drawing_.vertex_count() > 100 ? 1.8 : 3.5; }

  /// The worst simplex is filled, its star about the first of its labels has a thick outline.
  void add_worst_star(Figure& result, const std::vector<std::size_t>& shown) const {
    const auto position = worst_simplex(drawing_);
    if (!position) return;
    std::uint32_t centre = 0;
    for (std::size_t simplex = 0; simplex < drawing_.simplex_count(); ++simplex) {
      if (drawing_.positions[simplex] == *position) centre = least_label(simplex);
    }
    Figure::Path star{{}, !is_curve(), std::nullopt, colour_of_worst, 3};
    Figure::Path worst = star;
    if (!is_curve()) worst.fill = colour_of_worst;
    for (const std::size_t simplex : shown) {
      bool is_in_star = false;
      for (std::size_t corner = 0; corner < corners_; ++corner) is_in_star |= label(simplex, corner) == centre;
      if (is_in_star) star.lines.push_back(corners(simplex));
      if (drawing_.positions[simplex] == *position) worst.lines.push_back(corners(simplex));
    }
    if (!worst.lines.empty()) result.paths.push_back(worst);
    if (!star.lines.empty()) result.paths.push_back(star);
    const auto& measured = drawing_.measures.protection;
    const double protection = *position < measured.size() ? measured[*position] : std::nan("");
    result.description += fmt::format("; the star of label {} is marked, with the worst of all {}", centre,
                                      is_curve() ? "edges" : "triangles");
    if (!std::isnan(protection)) result.description += fmt::format(", of protection about {:.3g} eps", protection);
    if (star.lines.empty()) result.description += "; it is on the other side";
  }

  /// From 0 to 1, for each simplex of the drawing; 0 where nothing could be measured.
  static std::vector<double> shares(const Drawing& drawing, const std::string& measure) {
    const std::vector<NamedMeasure> measures = named_measures(drawing);
    std::vector<std::string_view> names;
    for (const NamedMeasure& one : measures) names.push_back(one.name);
    const auto found = std::find(names.begin(), names.end(), measure);
    if (found == names.end())
      throw InputError(fmt::format("no measure {} (there is {}){}", shortened(measure), fmt::join(names, ", "),
                                   suggestion(measure, names)));
    std::vector<double> result = measures[static_cast<std::size_t>(found - names.begin())].values;
    // A triangle's thickness is at most √3/4.
    double greatest = std::sqrt(3.0) / 4;
    if (measure != "thickness") {
      greatest = 0;
      for (const double value : result) greatest = std::isnan(value) ? greatest : std::max(greatest, value);
    }
    for (double& value : result)
      value = std::isnan(value) || greatest <= 0 ? 0 : std::clamp(value / greatest, 0.0, 1.0);
    return result;
  }

  const Drawing& drawing_;
  std::size_t axes_;
  std::size_t corners_;  ///< of a simplex
  std::vector<double> shares_;
};

/// The position of the least number; none if there is none.
std::optional<std::size_t> least_of(const std::vector<double>& values) {
  std::optional<std::size_t> result;
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (!std::isnan(values[at]) && (!result || values[at] < values[*result])) result = at;
  }
  return result;
}

}  // namespace

std::optional<std::size_t> worst_simplex(const Drawing& drawing) {
  const auto least_protected = least_of(drawing.measures.protection);
  return least_protected ? least_protected : least_of(drawing.measures.thickness);
}

Figure picture_of(const Drawing& drawing, const PictureOptions& options) {
  if (drawing.dimension != 1 && drawing.dimension != 2) {
    throw InputError("pictures are of certificates of dimension 1 or 2; this one has dimension " +
                     std::to_string(drawing.dimension));
  }
  return Picture(drawing, options).figure(options);
}

std::string picture_svg(const Drawing& drawing, const PictureOptions& options) {
  return svg_of(picture_of(drawing, options));
}

}  // namespace delcert
