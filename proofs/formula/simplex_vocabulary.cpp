#include "proofs/formula/simplex_vocabulary.hpp"

#include <numeric>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/dual_basis.hpp"
#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/faces.hpp"
#include "kernel/simplex/flake.hpp"
#include "kernel/simplex/good.hpp"
#include "kernel/simplex/hoop.hpp"
#include "kernel/simplex/realisability.hpp"
#include "kernel/simplex/spectrum.hpp"
#include "kernel/simplex/thickness.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

namespace {

template <class S>
const SimplexObject& simplex_of(const Argument<S>& argument) {
  return object_of<SimplexObject>(argument);
}
const SimplexObject& simplex_of(const Item& item) { return object_of<SimplexObject>(item); }

std::size_t vertex_of(const SimplexObject& simplex, long index) {
  if (index < 0 || static_cast<std::size_t>(index) >= simplex.vertex_count()) {
    throw InputError("a simplex of " + std::to_string(simplex.vertex_count()) + " vertices has no vertex " +
                     std::to_string(index));
  }
  return static_cast<std::size_t>(index);
}

template <class S>
std::size_t vertex_of(const SimplexObject& simplex, const Argument<S>& argument) {
  return vertex_of(simplex, integer_of(argument));
}

// Types of their own: what is attached to an object is found again by its type.
template <class S>
struct Spectrum {
  Partial<std::vector<S>> values;
};
template <class S>
struct DualLengths {
  Partial<std::vector<S>> squares;
};

/// The eigenvalues of PᵀP, the largest first.
template <class S>
const Partial<std::vector<S>>& spectrum(Evaluation<S>& evaluation, const SimplexObject& simplex) {
  return evaluation
      .template attached<Spectrum<S>>(
          simplex, [&] { return Spectrum<S>{eigenvalues_by_scaling<S>(simplex.exact_gram().gram())}; })
      .values;
}

template <class S>
Partial<S> singular_value(Evaluation<S>& evaluation, const SimplexObject& simplex, long index) {
  if (index < 1 || static_cast<std::size_t>(index) > simplex.dimension()) {
    throw InputError("a simplex of dimension " + std::to_string(simplex.dimension()) + " has no singular value " +
                     std::to_string(index));
  }
  const auto at = static_cast<std::size_t>(index) - 1;
  // Not negative, whatever the enclosure's lower end.
  if constexpr (std::same_as<S, Interval>) {
    // There one is cheaper than all.
    const Partial<S> value = eigenvalue<S>(simplex.exact_gram().gram(), at);
    return value ? Partial<S>(square_root(*value)) : value;
  }
  const auto& values = spectrum(evaluation, simplex);
  if (!values) return Partial<S>::absent(values.exists());
  return square_root((*values)[at]);
}

template <class S>
const std::optional<DualBasis>& dual_basis(Evaluation<S>& evaluation, const SimplexObject& simplex) {
  return evaluation.template attached_exactly<std::optional<DualBasis>>(
      simplex, [&] { return DualBasis::of(simplex.exact_gram()); });
}

/// Υ(σ); exactly, where that is asked, by what the dual basis has in integers.
template <class S>
Partial<S> thickness_of(Evaluation<S>& evaluation, const SimplexObject& simplex) {
  if constexpr (std::same_as<S, Surd>) {
    if (const auto& basis = dual_basis(evaluation, simplex)) return square_root(Surd(basis->squared_thickness()));
  }
  return thickness(simplex.gram(evaluation));
}

/// R(σ), as above.
template <class S>
Partial<S> circumradius_of(Evaluation<S>& evaluation, const SimplexObject& simplex) {
  if constexpr (std::same_as<S, Surd>) {
    if (const auto& basis = dual_basis(evaluation, simplex)) return square_root(Surd(basis->squared_circumradius()));
  }
  return circumradius(simplex.gram(evaluation));
}

template <class S>
Partial<S> root_of(const Partial<S>& squared) {
  return squared ? Partial<S>(square_root(*squared)) : squared;
}

std::vector<Item> faces_of(const SimplexObject& simplex, std::size_t least, std::size_t most) {
  std::vector<Item> result;
  for (std::size_t count = least; count <= most; ++count) {
    for (Faces faces(simplex.vertex_count(), count); faces.has_face(); faces.advance()) {
      result.emplace_back(std::make_shared<SimplexObject>(simplex.face(faces.vertices())));
    }
  }
  return result;
}

void add_sets(Vocabulary& vocabulary) {
  vocabulary.add(
      {"dimension",
       {types::simplex},
       types::integer,
       "The dimension k of a simplex of k + 1 vertices.",
       "\\dim #1",
       false,
       ItemFunction([](std::span<const Item> a) { return Item(static_cast<long>(simplex_of(a[0]).dimension())); })});
  vocabulary.add({"vertices",
                  {types::simplex},
                  types::integers,
                  "The numbers 0 … k of the vertices.",
                  "#1",
                  false,
                  SetFunction([](std::span<const Item> a) {
                    std::vector<Item> result;
                    for (std::size_t p = 0; p < simplex_of(a[0]).vertex_count(); ++p) {
                      result.emplace_back(static_cast<long>(p));
                    }
                    return result;
                  })});
  vocabulary.add({"edges",
                  {types::simplex},
                  types::simplices,
                  "The faces of dimension 1.",
                  "\\mathrm{edges}(#1)",
                  false,
                  SetFunction([](std::span<const Item> a) { return faces_of(simplex_of(a[0]), 2, 2); })});
  vocabulary.add(
      {"faces_of_dimension",
       {types::simplex, types::integer},
       types::simplices,
       "The faces of the dimension given, the vertices (0) and the simplex itself among them; none for others.",
       "\\mathrm{faces}_{#2}(#1)",
       false,
       SetFunction([](std::span<const Item> a) -> std::vector<Item> {
         const long wanted = std::get<long>(a[1]);
         if (wanted < 0 || static_cast<std::size_t>(wanted) > simplex_of(a[0]).dimension()) return {};
         const auto count = static_cast<std::size_t>(wanted) + 1;
         return faces_of(simplex_of(a[0]), count, count);
       })});
  vocabulary.add({"face",
                  {types::simplex, types::integer, types::integer},
                  types::simplex,
                  "The face of the vertices from the first to the last number.",
                  "{#1}_{#2 \\ldots #3}",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const SimplexObject& simplex = simplex_of(a[0]);
                    const std::size_t first = vertex_of(simplex, std::get<long>(a[1]));
                    const std::size_t last = vertex_of(simplex, std::get<long>(a[2]));
                    if (last < first) throw InputError("a face needs a vertex: the last is before the first");
                    std::vector<std::size_t> vertices(last - first + 1);
                    std::iota(vertices.begin(), vertices.end(), first);
                    return std::make_shared<SimplexObject>(simplex.face(vertices));
                  })});
  vocabulary.add({"faces",
                  {types::simplex},
                  types::simplices,
                  "All faces of dimension 1 and more, the simplex itself among them.",
                  "\\mathrm{faces}(#1)",
                  false,
                  SetFunction([](std::span<const Item> a) {
                    return faces_of(simplex_of(a[0]), 2, simplex_of(a[0]).vertex_count());
                  })});
  vocabulary.add({"proper_faces",
                  {types::simplex},
                  types::simplices,
                  "All faces of dimension 1 and more but the simplex itself.",
                  "\\mathrm{faces}(#1)\\setminus\\{#1\\}",
                  false,
                  SetFunction([](std::span<const Item> a) {
                    return faces_of(simplex_of(a[0]), 2, simplex_of(a[0]).vertex_count() - 1);
                  })});
  vocabulary.add({"facets",
                  {types::simplex},
                  types::simplices,
                  "The faces opposite the vertices.",
                  "\\mathrm{facets}(#1)",
                  false,
                  SetFunction([](std::span<const Item> a) {
                    return faces_of(simplex_of(a[0]), simplex_of(a[0]).vertex_count() - 1,
                                    simplex_of(a[0]).vertex_count() - 1);
                  })});
  vocabulary.add({"opposite_facet",
                  {types::simplex, types::integer},
                  types::simplex,
                  "The facet without vertex p.",
                  "{#1}_{#2}",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const SimplexObject& simplex = simplex_of(a[0]);
                    const std::size_t left_out = vertex_of(simplex, std::get<long>(a[1]));
                    std::vector<std::size_t> vertices;
                    for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
                      if (p != left_out) vertices.push_back(p);
                    }
                    return std::make_shared<SimplexObject>(simplex.face(vertices));
                  })});
}

void add_lengths(Vocabulary& vocabulary) {
  vocabulary.add(number_function(
      "longest_edge", {types::simplex}, "Δ(σ), a length; 0 for a vertex.", "\\Delta(#1)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> { return longest_edge(simplex_of(a[0]).gram(e)); }));
  vocabulary.add(number_function("shortest_edge", {types::simplex}, "L(σ), a length; undefined for a vertex.", "L(#1)",
                                 []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   if (simplex_of(a[0]).dimension() == 0) return Partial<S>::absent(Verdict::refuted);
                                   return shortest_edge(simplex_of(a[0]).gram(e));
                                 }));
  vocabulary.add(number_function("edge", {types::simplex, types::integer, types::integer},
                                 "The distance of two vertices by their numbers, a length.",
                                 "\\lVert {#1}_{#2} - {#1}_{#3}\\rVert",
                                 []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   const SimplexObject& s = simplex_of(a[0]);
                                   const std::size_t i = vertex_of(s, a[1]);
                                   const std::size_t j = vertex_of(s, a[2]);
                                   return i == j ? S(0) : S(square_root(s.gram(e).squared_edge(i, j)));
                                 }));
  vocabulary.add(number_function("altitude", {types::simplex, types::integer},
                                 "D(p, σ), a length: the distance of a vertex from the affine hull of its facet.",
                                 "D(#2, #1)", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   const SimplexObject& s = simplex_of(a[0]);
                                   if (s.dimension() == 0) return Partial<S>::absent(Verdict::refuted);
                                   return altitude(s.gram(e), vertex_of(s, a[1]));
                                 }));
  vocabulary.add(number_function(
      "thickness", {types::simplex}, "Υ(σ), a ratio in [0, 1]: the least altitude over kΔ(σ); 1 for a vertex.",
      "\\Upsilon(#1)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> { return thickness_of(e, simplex_of(a[0])); }));
  vocabulary.add(number_function(
      "circumradius", {types::simplex},
      "R(σ), a length: of the smallest circumscribing ball; undefined if there is none.", "R(#1)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> { return circumradius_of(e, simplex_of(a[0])); }));
}

/// ⟨w_i, p_j − p_0⟩ for i = 0 … k, j = 1 … k, from the coordinates where there are any; empty if degenerate.
struct DualProducts {
  std::vector<std::vector<Rational>> of;
};

template <class S>
DualProducts dual_products(Evaluation<S>& evaluation, const SimplexObject& simplex) {
  const auto& basis = dual_basis(evaluation, simplex);
  if (!basis) return {};
  return {simplex.has_coordinates() ? basis->products(simplex.points()) : basis->products()};
}

void add_dual_basis(Vocabulary& vocabulary) {
  vocabulary.add(
      number_function("dual_length", {types::simplex, types::integer},
                      "‖w_i‖, an inverse length: row i = 1 … k of the pseudo-inverse of P; minus their sum for i = 0.",
                      "\\lVert w_{#2}(#1)\\rVert", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                        const SimplexObject& s = simplex_of(a[0]);
                        const std::size_t i = vertex_of(s, a[1]);
                        const auto& squared = e.template attached<DualLengths<S>>(s, [&] {
                                                 return DualLengths<S>{squared_dual_lengths(s.gram(e))};
                                               }).squares;
                        return squared ? Partial<S>(square_root((*squared)[i])) : Partial<S>::absent(squared.exists());
                      }));
  vocabulary.add(number_function(
      "altitude_times_dual_length", {types::simplex, types::integer},
      "D(p_i, σ)‖w_i‖, from the exact squares of both on every rung; undefined for a degenerate simplex.",
      "D(#2, #1)\\,\\lVert w_{#2}(#1)\\rVert", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const SimplexObject& s = simplex_of(a[0]);
        const std::size_t i = vertex_of(s, a[1]);
        if (s.dimension() == 0) return Partial<S>::absent(Verdict::refuted);
        const auto& basis = dual_basis(e, s);
        if (!basis) return Partial<S>::absent(Verdict::refuted);
        return square_root(scalar_from<S>(basis->squared_altitude_times_length(i)));
      }));
  vocabulary.add(number_function(
      "dual_product", {types::simplex, types::integer, types::integer},
      "⟨w_i, p_j − p_0⟩, a ratio, exact on every rung: the dual vector i = 0 … k and the edge to vertex j = 0 … k; "
      "undefined for a degenerate simplex.",
      "\\langle w_{#2}, {#1}_{#3} - {#1}_0\\rangle", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const SimplexObject& s = simplex_of(a[0]);
        const std::size_t i = vertex_of(s, a[1]);
        const std::size_t j = vertex_of(s, a[2]);
        const auto& products = e.template attached<DualProducts>(s, [&] { return dual_products(e, s); });
        if (products.of.empty()) return Partial<S>::absent(Verdict::refuted);
        return j == 0 ? S(0) : scalar_from<S>(products.of[i][j - 1]);
      }));
}

void add_singular_values(Vocabulary& vocabulary) {
  vocabulary.add(
      number_function("singular_value", {types::simplex, types::integer},
                      "s_i(P), a length: singular value of the matrix of the edges from vertex 0, i = 1 … k.",
                      "s_{#2}(#1)", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                        return singular_value(e, simplex_of(a[0]), integer_of(a[1]));
                      }));
  vocabulary.add(number_function("smallest_singular_value", {types::simplex}, "s_k(P), a length; k ≥ 1.", "s_k(#1)",
                                 []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   const SimplexObject& s = simplex_of(a[0]);
                                   return singular_value(e, s, static_cast<long>(s.dimension()));
                                 }));
  vocabulary.add(number_function(
      "largest_singular_value", {types::simplex}, "s_1(P) = ‖P‖, a length; k ≥ 1.", "s_1(#1)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> { return singular_value(e, simplex_of(a[0]), 1); }));
}

void add_simplex_predicates(Vocabulary& vocabulary) {
  vocabulary.add(truth_function(
      "is_nondegenerate", {types::simplex}, "The vertices are affinely independent.", "#1\\text{ non-degenerate}",
      []<class S>(Evaluation<S>& e, Arguments<S> a) { return is_non_degenerate(simplex_of(a[0]).gram(e)); }));
  vocabulary.add(truth_function(
      "has_circumcentre", {types::simplex}, "There is a circumscribing ball.", "R(#1) < \\infty",
      []<class S>(Evaluation<S>& e, Arguments<S> a) { return circumsphere(simplex_of(a[0]).gram(e)).exists(); }));
  vocabulary.add(truth_function("is_good", {types::simplex, types::number},
                                "Γ₀-good: every j-face has thickness at least Γ₀ʲ; 0 < Γ₀ ≤ 1.",
                                "#1\\text{ is }#2\\text{-good}", []<class S>(Evaluation<S>& e, Arguments<S> a) {
                                  return is_good(simplex_of(a[0]).gram(e), S(square(std::get<S>(a[1]))));
                                }));
  vocabulary.add(truth_function("is_flake", {types::simplex, types::number},
                                "A Γ₀-flake: not Γ₀-good, but all facets are; 0 < Γ₀ ≤ 1.",
                                "#1\\text{ is a }#2\\text{-flake}", []<class S>(Evaluation<S>& e, Arguments<S> a) {
                                  return is_flake(simplex_of(a[0]).gram(e), S(square(std::get<S>(a[1]))));
                                }));
  vocabulary.add(truth_function("has_hoop_property", {types::simplex, types::number},
                                "The α₀-hoop property: every vertex within α₀R of the circumsphere of its facet.",
                                "#1\\text{ has the }#2\\text{-hoop property}",
                                []<class S>(Evaluation<S>& e, Arguments<S> a) {
                                  return has_hoop_property(simplex_of(a[0]).gram(e), S(square(std::get<S>(a[1]))));
                                }));
}

}  // namespace

void add_simplex_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("simplex", SimplexObject::read);
  vocabulary.add_kind("point", PointObject::read);
  add_sets(vocabulary);
  add_lengths(vocabulary);
  add_singular_values(vocabulary);
  add_dual_basis(vocabulary);
  add_simplex_predicates(vocabulary);
}

}  // namespace delcert
