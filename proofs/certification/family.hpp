#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/sample/point_file.hpp"
#include "proofs/certification/certify_options.hpp"
#include "proofs/certification/refinement.hpp"
#include "proofs/certification/run_report.hpp"

namespace delcert {

/// A net as `delcert sample` writes it.
struct NetText {
  PointList points;
  std::string coordinates;  ///< which they are; empty for those of the frame
  /// Of the covering radius: a certified lower bound where the sampling radius is a certified upper one, or a guess.
  std::optional<Rational> covering_radius_lower = {};
  std::optional<double> covering_radius_about = {};
};

/// A manifold on its way from a net to a certificate: what the families do differently, in the order of the calls. What
/// is found is written into the report.
class Family {
 public:
  RunReport report;

  Family() = default;
  Family(const Family&) = delete;
  Family& operator=(const Family&) = delete;
  virtual ~Family() = default;

  /// Makes or reads the net, and all that is measured of it. Throws what sampling and reading throw.
  virtual void make_net(const NetSource& source, const Progress& progress) = 0;
  [[nodiscard]] virtual NetText net() const = 0;
  /// Completes what the command line leaves open. Throws Rejection unless the net and the manifold are fit for it.
  virtual void choose_parameters(const CertifyOptions& options, const Progress& progress) = 0;
  /// Throws Rejection, which names the stars that failed, unless everything is certified.
  virtual void run(RunRequest request, const Progress& progress) = 0;
  virtual void derive(const LevelSelection& selection, const Progress& progress) = 0;
  /// After all that, or when it ended with a Rejection: makes radii smaller where something fails, so that the net will
  /// be another one. Where that was; none if there is no such place, or radii are not chosen by the run.
  [[nodiscard]] virtual std::optional<FailedRound> refine() { return std::nullopt; }
  /// After that: which radii should do, for the end of a message; empty where radii are not what was wrong, or nothing
  /// is known of others. A heuristic.
  [[nodiscard]] virtual std::string advice(const NetSource&, const Progress&) const { return {}; }
  virtual void write(const std::string& path, const Progress& progress) const = 0;

 protected:
  /// Throws Rejection: how many failures there are, the first ten of them, and all labels whose stars disagree.
  [[noreturn]] void refuse_stars(std::initializer_list<std::vector<StarFailure>> failures,
                                 const std::vector<Label>& disagreeing = {}) const;
  /// Throws Rejection unless the homology, if it is claimed, is what a file says, if it says something.
  void require_homology(const std::vector<std::string>& said) const;
};

/// Verified: that a group acts as it should, that a metric is one, that charts are glued to a closed manifold. Throws
/// Rejection, Undecided.
[[nodiscard]] std::unique_ptr<Family> family_of(const AnyManifold& manifold, StageClock& clock);

[[nodiscard]] std::unique_ptr<Family> family_of(const ManifoldDescription& manifold);
[[nodiscard]] std::unique_ptr<Family> family_of(const SpaceFormDescription& manifold);
[[nodiscard]] std::unique_ptr<Family> family_of(const MetricFieldDescription& manifold);
[[nodiscard]] std::unique_ptr<Family> family_of(const FormulaAtlasDescription& manifold);
[[nodiscard]] std::unique_ptr<Family> family_of(const SubmanifoldDescription& manifold);
/// A mesh in a file (kernel/manifold/mesh_file.hpp), as a triangulation of a surface in space. Throws InputError for
/// another manifold.
[[nodiscard]] std::unique_ptr<Family> family_of_mesh(const AnyManifold& manifold, const std::string& file);

}  // namespace delcert
