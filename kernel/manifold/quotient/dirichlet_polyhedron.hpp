#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/quotient/invariant_form.hpp"

namespace delcert {

/// The set of points that are no closer to go than to o, for some isometries g: if these are enough of a discrete
/// group, its Dirichlet polyhedron about o. Bounded, with exact vertices over the number field.
struct DirichletPolyhedron {
  /// A facet, on the bisector of o and go.
  struct Side {
    FieldMatrix element;
    /// The number of the element in the list that the polyhedron was made of, and the side of its inverse.
    std::size_t number;
    std::size_t opposite;
    FieldVector covector;
    /// Increasing.
    std::vector<std::size_t> vertices;
  };
  /// A face of codimension 2, where two sides meet.
  struct Ridge {
    std::size_t first_side;
    std::size_t second_side;
    std::vector<std::size_t> vertices;
  };

  std::vector<Side> sides;
  /// Points of the linear model's rays, with first coordinate 1.
  std::vector<FieldVector> vertices;
  std::vector<Ridge> ridges;

  /// The vertex on the ray of x; the number of vertices if there is none there. Precondition: x₀ is not 0.
  [[nodiscard]] std::size_t vertex_on(const FieldVector& ray) const;
};

/// Whether every element must have a side, or only those count that have one.
enum class ElementsWithoutSide { are_errors, are_left_out };

/// The polyhedron of these isometries, closed under inverses. Throws Rejection, naming elements by `names`, if it is
/// not bounded (in 𝕊ᵐ: in the open half-sphere about o), if an element fixes o or is its own inverse, if two have the
/// same side, or – where that is asked for – one has none. Precondition: dimension 2 or 3; the elements are isometries.
[[nodiscard]] DirichletPolyhedron dirichlet_polyhedron(const InvariantForm& form,
                                                       const std::vector<FieldMatrix>& elements,
                                                       const std::vector<std::string>& names,
                                                       ElementsWithoutSide without_side);

/// An enclosure of the largest distance of a vertex from o.
[[nodiscard]] BigInterval circumradius(const InvariantForm& form, const DirichletPolyhedron& polyhedron);

}  // namespace delcert
