#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/certificate/reader.hpp"
#include "proofs/drawing/manifold/approximate_manifold.hpp"
#include "proofs/drawing/measures.hpp"

namespace delcert {

/// Which copies of the simplices are drawn.
enum class DrawingCopies : unsigned char {
  /// Each label once, where the certificate has it: the closed complex, with simplices across the walls of a cell.
  quotient,
  /// Each simplex once, its copy in one fundamental cell; on an atlas, in a chart that shows it. What is cut open is in
  /// `matching_faces`.
  cell,
  /// The cell and around it all copies of simplices that share a vertex with it: every star is whole somewhere.
  glued
};
[[nodiscard]] std::string_view name_of(DrawingCopies copies);

struct DrawingOptions {
  DrawingCopies copies = DrawingCopies::cell;
  /// None: the usual one of the family.
  std::optional<DrawingModel> model;
  /// Whether simplices are measured, which takes most of the time.
  bool is_measured = true;
};

/// Two facets of the drawing that are one in the manifold.
struct MatchingFaces {
  std::vector<std::uint32_t> first;   ///< m vertices
  std::vector<std::uint32_t> second;  ///< their copies, in the same order
  std::string step;                   ///< what takes the first to the second: "0 1 0", "g2 e1^-1", "north -> south"
};

/// Of level 1, if it is claimed, and of level 6 for the hinges of surfaces; in the units of `SimplexMeasures`.
struct MeasureBounds {
  std::optional<double> protection;    ///< lower
  std::optional<double> thickness;     ///< lower
  std::optional<double> circumradius;  ///< upper
  std::optional<double> hinge;         ///< lower
};

/// The complex of a certificate in coordinates. In doubles, without error bounds: for other programs and for the eye.
struct Drawing {
  DrawingCopies copies = DrawingCopies::cell;
  DrawingModel model = DrawingModel::unit;
  std::string geometry;               ///< "flat", "spherical", "hyperbolic", "metric", "charts", "space"
  std::size_t dimension = 0;          ///< m
  std::size_t ambient_dimension = 0;  ///< 2 or 3; a curve in one coordinate has 0 as its second one
  std::string projection;             ///< "first 3 coordinates of 4"; empty if nothing is left out

  std::vector<double> coordinates;    ///< ambient_dimension to a vertex
  std::vector<std::uint32_t> labels;  ///< of each vertex
  std::vector<std::uint32_t> lifts;   ///< of each vertex, its place in lift_texts
  std::vector<std::string> lift_texts;

  /// m + 1 vertices each. Neighbours have opposite orientations on their facet, where the whole can be oriented; of the
  /// two orientations the one in which volumes are positive, of surfaces in space the one with normals to the outside.
  std::vector<std::uint32_t> simplices;
  bool is_oriented = false;              ///< whether that could be done everywhere
  std::vector<std::uint32_t> positions;  ///< of each simplex, in the certificate's list
  SimplexMeasures measures;              ///< by positions in the certificate's list; empty lists if not asked for
  MeasureBounds bounds;

  std::vector<MatchingFaces> matching_faces;
  std::vector<double> domain;  ///< wires of a fundamental domain: two points each, ambient_dimension to a point

  [[nodiscard]] std::size_t vertex_count() const { return labels.size(); }
  [[nodiscard]] std::size_t simplex_count() const { return positions.size(); }
};

/// Throws InputError where the certificate is not as its format says, for a model that its family is not drawn in (the
/// message lists those that it is drawn in), and where the model does not show a point.
[[nodiscard]] Drawing drawing_of(const CertificateSummary& certificate, const DrawingOptions& options);

}  // namespace delcert
