#pragma once

#include <vector>

#include "kernel/chart/model_space.hpp"
#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"

namespace delcert {

/// A Dirichlet polyhedron of a hyperbolic group in the standard basis, enclosed: for decisions about many points. All
/// of it needs a `RoundingGuard`.
template <int m>
class EnclosedPolyhedron {
 public:
  EnclosedPolyhedron(const InvariantForm& form, const DirichletPolyhedron& polyhedron);

  /// Proved if x is in the polyhedron, refuted if it is outside.
  [[nodiscard]] Verdict contains(const ModelPoint<Interval, m>& x) const;

  /// Whether x is certainly farther from some half-space of the polyhedron, and so from all of it, than the distance
  /// with this hyperbolic sine.
  [[nodiscard]] bool is_certainly_farther(const ModelPoint<Interval, m>& x, const Interval& sine) const;

 private:
  /// Unit normals n, as covectors: n·x is the hyperbolic sine of the distance of x from the side, positive outside.
  std::vector<ModelPoint<Interval, m>> normals_;
};

}  // namespace delcert
