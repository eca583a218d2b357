#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/manifold/submanifold/embedded_manifold.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How densely a subset of a Euclidean space is to be sampled, place by place: e(x) = min{e_max, min over cones of
/// a + ν|x − s|}, which has the greatest ν for a Lipschitz constant. In doubles: no claim rests on it.
class Sizing {
 public:
  struct Cone {
    std::vector<double> apex;
    double radius = 0;
    double slope = 0;
  };

  /// e_max everywhere.
  Sizing(std::size_t dimension, double greatest) : dimension_(dimension), greatest_(greatest) {}

  /// Preconditions: a radius above 0, a slope of at least 0.
  void add(Cone cone);
  [[nodiscard]] double at(const double* x) const;
  [[nodiscard]] double greatest() const { return greatest_; }
  /// Of e, a lower bound.
  [[nodiscard]] double least() const;
  [[nodiscard]] std::size_t size() const { return cones_.size(); }

 private:
  /// A part of the cones, with a box around their apices.
  struct Node {
    std::size_t begin, end;
    std::size_t left = 0;  // and the one after it; 0: there are none
    double least_radius = 0, least_slope = 0;
    std::vector<double> lower, upper;
  };
  void build(std::size_t node, std::size_t axis);
  [[nodiscard]] double bound(const Node& node, const double* x) const;

  std::size_t dimension_;
  double greatest_;
  std::vector<Cone> cones_;
  std::size_t in_tree_ = 0;  // of the cones; the last ones are looked at one by one
  std::vector<Node> nodes_;
};

/// Where a sizing function comes from.
struct SizingRequest {
  std::string text;  ///< "curvature:k,ν", or a file; empty: a constant

  [[nodiscard]] bool is_by_curvature() const;
};

/// A file with a cone a line: the coordinates of its apex, its radius, its slope. Throws InputError, with the line.
[[nodiscard]] std::vector<Sizing::Cone> read_cones(const std::string& file, std::size_t dimension);

/// "curvature:k,ν": cones of slope ν with the radius k/κ, κ about the curvature, at random points of M, as many as
/// matter. Otherwise a file of cones, in the N coordinates. Throws InputError, with the line, and for the curvature of
/// what is not smooth.
[[nodiscard]] Sizing sizing_of(const SizingRequest& request, const EmbeddedManifold& manifold, double greatest,
                               std::uint64_t seed, const Progress& progress);

}  // namespace delcert
