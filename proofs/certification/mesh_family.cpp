#include <fmt/format.h>

#include "kernel/manifold/mesh_file.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "kernel/theorems/full_stars.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/file_text.hpp"
#include "proofs/certificate/submanifold_claims.hpp"
#include "proofs/certification/family.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// A mesh that is given, against the surface of an equation: nothing is moved.
class MeshFamily final : public Family {
 public:
  MeshFamily(const SubmanifoldDescription& manifold, std::string file) : zero_set_(manifold), file_(std::move(file)) {
    report.manifold = manifold.name;
    report.family = "submanifold";
    report.dimension = manifold.dimension;
    report.graphs.emplace();
    report.graphs->ambient_dimension = zero_set_.ambient();
    if (manifold.dimension != Dimension(2) || zero_set_.ambient() != 3)
      throw InputError(manifold.name +
                       ": --complex certifies a mesh of triangles in space, but this is not a surface in space");
  }

  void make_net(const NetSource& source, const Progress& progress) override {
    TriangleMesh mesh = parse_mesh(read_text(file_), file_);
    for (LabelSimplex<2> triangle : mesh.triangles) {
      std::sort(triangle.begin(), triangle.end());
      simplices_.push_back(triangle);
    }
    std::sort(simplices_.begin(), simplices_.end());
    const auto twice = std::adjacent_find(simplices_.begin(), simplices_.end());
    if (twice != simplices_.end())
      throw Rejection(fmt::format("{}: the triangle {} occurs twice", file_, fmt::join(*twice, " ")));
    report.sampling_radius = source.radius ? *source.radius : radius_for(mesh);
    report.points = mesh.points.size();
    report.simplices = simplices_.size();
    charts_ = fit_charts(zero_set_, mesh.points, report.sampling_radius, progress);
    report.patch_factor = charts_.patch_factor;
    report.graphs->slope = charts_.slope;
    report.graphs->distortion = distortion_of_slope(charts_.slope);
    report.graphs->cover_parts = require_cover(zero_set_, charts_.charts, progress);
  }

  [[nodiscard]] NetText net() const override {
    NetText result;
    for (const TangentChart& chart : charts_.charts) result.points.push_back(chart.data().centre);
    return result;
  }

  void choose_parameters(const CertifyOptions&, const Progress&) override {
    report.parameters.mode = RunMode::none;
    report.parameters.algorithm.separation = Rational::power_of_two(-10);
    report.parameters.squared_flake_parameter = Rational::power_of_two(-120);
  }

  void run(RunRequest, const Progress&) override {
    const std::vector<StarFailure> failures = check_full_stars<2>(charts_.charts, simplices_);
    if (!failures.empty()) refuse_stars({failures});
  }

  void derive(const LevelSelection& selection, const Progress& progress) override {
    report.claims.full_stars.emplace();
    std::vector<std::uint32_t> labels;
    for (const LabelSimplex<2>& triangle : simplices_) labels.insert(labels.end(), triangle.begin(), triangle.end());
    report.claims.manifold = manifold_claim(PureComplex(Dimension(2), labels), simplices_.size(), true);
    if (!selects(selection, "5") && !selects(selection, "5i")) return;
    const GraphVertices vertices = given_vertices(zero_set_, charts_.charts);
    const auto triangulation = check_graph_triangulation<2>(vertices, simplices_, progress);
    std::optional<GraphIsotopy> isotopy;
    if (selects(selection, "5i") && triangulation.triangulates()) {
      isotopy = check_graph_isotopy<2>(vertices, simplices_, triangulation, progress);
      report.graphs->margin = isotopy->margin;
    }
    claim_graph<2>(triangulation, isotopy, report.sampling_radius, selection, report.claims, report.reasons);
    if (!triangulation.triangulates()) throw Rejection(refusal(triangulation));
  }

  void write(const std::string& path, const Progress& progress) const override {
    write_certificate<2>(
        path, content_of<2>(zero_set_, charts_, report.sampling_radius, simplices_, report.parameters, report.claims),
        progress);
  }

 private:
  /// Half of what nine tenths of the edges are not longer than, in few digits: patches are a few times as large. An
  /// edge that is far longer than the others is found to be wrong, and does not make all patches too large.
  static Rational radius_for(const TriangleMesh& mesh) {
    std::vector<Rational> squares;
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        Rational& squared = squares.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
          squared += square(mesh.points[triangle[k]][axis] - mesh.points[triangle[(k + 1) % 3]][axis]);
      }
    }
    std::sort(squares.begin(), squares.end());
    const Rational& most = squares[squares.size() * 9 / 10];
    if (most == Rational(0)) throw Rejection("nearly all edges of the mesh have length 0");
    const Rational half = square_root_upper(most, 20) / Rational(2);
    return rounded_up(half, binary_exponent(half) - 11);
  }

  [[nodiscard]] std::string refusal(const GraphTriangulation<2>& triangulation) const {
    constexpr std::size_t shown = 10;
    std::string result = file_ + " is not certified: " + report.reasons.front();
    for (std::size_t at = 1; at < std::min(shown, triangulation.failures.size()); ++at) {
      const GraphSimplexFailure<2>& failure = triangulation.failures[at];
      result += fmt::format("\n  simplex {}: {}", fmt::join(failure.simplex, " "), description_of(failure.cause));
    }
    return result;
  }

  ZeroSet zero_set_;
  std::string file_;
  std::vector<LabelSimplex<2>> simplices_;
  FittedCharts charts_;
};

}  // namespace

std::unique_ptr<Family> family_of_mesh(const AnyManifold& manifold, const std::string& file) {
  if (const auto* submanifold = std::get_if<SubmanifoldDescription>(&manifold)) {
    if (submanifold->mesh)
      throw InputError("--complex is for manifolds given by equations, not for those given by a mesh");
    return std::make_unique<MeshFamily>(*submanifold, file);
  }
  throw InputError("--complex with --manifold is for submanifolds; without it for a complex with group elements");
}

}  // namespace delcert
