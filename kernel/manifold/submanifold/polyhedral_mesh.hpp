#pragma once

#include "kernel/manifold/submanifold/embedded_manifold.hpp"
#include "kernel/manifold/submanifold/facet_tree.hpp"
#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "kernel/manifold/submanifold/triangle_mesh.hpp"

namespace delcert {

/// M is the polyhedron itself: the union of the triangles, *facets*, of a mesh in space (docs/submanifolds.md).
class PolyhedralMesh final : public EmbeddedManifold {
 public:
  /// Rule mesh.closed. Throws Rejection, which names facets or an edge, unless every facet has an area and every edge
  /// is in exactly two of them, in opposite directions. Precondition: rounding to nearest.
  PolyhedralMesh(std::string name, TriangleMesh mesh, std::vector<std::string> homology);

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  /// The facets with an edge of this one, in the order of its edges, from the first vertex to the second on.
  [[nodiscard]] const std::array<std::uint32_t, 3>& neighbours(std::uint32_t facet) const { return neighbours_[facet]; }
  /// Enclosed, three coordinates.
  [[nodiscard]] const Interval* point(std::uint32_t facet, std::size_t corner) const {
    return &places_[3 * std::size_t{mesh_.triangles[facet][corner]}];
  }
  [[nodiscard]] const FacetTree& tree() const { return tree_; }
  /// Names the sharpest edge of what is near to a facet, and says what to do about it.
  [[nodiscard]] std::string crease_near(std::uint32_t facet) const;

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::size_t ambient() const override { return 3; }
  [[nodiscard]] std::size_t codimension() const override { return 1; }
  [[nodiscard]] const std::vector<std::string>& homology() const override { return homology_; }
  /// A little larger than the mesh.
  [[nodiscard]] const std::vector<std::array<Rational, 2>>& box() const override { return box_; }
  [[nodiscard]] bool is_smooth() const override { return false; }
  /// The function of chart i is N_iᵀ(x − c_i) less the height of M there, over Y_i. Its derivative is ν/⟨ν, N_iY_i⟩ for
  /// a facet with the normal ν.
  [[nodiscard]] std::unique_ptr<GraphEvaluation> evaluation() const override;
  /// Darts are random points of facets, by their areas; normals are means over the radius.
  [[nodiscard]] std::unique_ptr<ManifoldSampler> sampler(double radius) const override;
  [[nodiscard]] FittedCharts fit_charts(const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
                                        const Progress& progress) const override;
  /// Facets are divided until each part is in the cylinder of some chart; open parts are points of M.
  [[nodiscard]] CoverReport check_cover(const std::vector<TangentChart>& charts,
                                        const Progress& progress) const override;
  /// None: rule mesh.closed is verified.
  [[nodiscard]] std::optional<BoxPart> singular_part() const override;

 private:
  std::string name_;
  TriangleMesh mesh_;
  std::vector<std::string> homology_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<Interval> places_;
  std::vector<std::array<Rational, 2>> box_;
  FacetTree tree_;
};

}  // namespace delcert
