#pragma once

#include <string>
#include <vector>

#include "proofs/checker/certificate/space_form.hpp"

namespace delcert::checker {

using FieldVector = std::vector<FieldElement>;

/// A side of the polyhedron P of all points of a hyperbolic space that are no farther from o than from the images of o
/// under the generators and their inverses: on the bisector of o and (element) o.
struct Side {
  FieldMatrix element{0};
  FieldVector normal;                 // (element) o - o up to a factor: <x, normal> <= 0 for x in P
  std::vector<std::size_t> vertices;  // increasing
  std::size_t inverse = 0;            // the side of the inverse element
};

/// The polyhedron, exactly. If it does not fulfil Poincare's conditions, `fault` says why.
struct Dirichlet {
  explicit Dirichlet(const SpaceForm& form);

  std::string fault;
  std::vector<Side> sides;
  std::vector<FieldVector> vertices;             // with x_0 = 1
  std::vector<std::vector<std::size_t>> cycles;  // the sides that one crosses on the way around each ridge

  /// cosh of the greatest distance of a vertex from o.
  Ball farthest_vertex() const;

 private:
  std::string find_vertices();
  std::string find_sides();
  std::string check_cycles();
  FieldElement product(const FieldVector& x, const FieldVector& y) const;
  /// The vertex at the image, or the number of vertices if there is none.
  std::size_t image(const FieldMatrix& a, std::size_t vertex) const;
  Ball angle(const Side& s, const Side& t) const;

  const SpaceForm& form_;
  FieldMatrix J_;
};

}  // namespace delcert::checker
