#include "proofs/formula/pair_vocabulary.hpp"

#include "kernel/simplex/spectrum.hpp"
#include "proofs/formula/pair_alignment.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S>
const SimplexObject& simplex_in_pair(const Argument<S>& argument) {
  return object_of<SimplexObject>(argument);
}

void require_pair(const SimplexObject& simplex, const SimplexObject& image) {
  if (simplex.vertex_count() != image.vertex_count() || simplex.dimension() == 0) {
    throw InputError("two simplices of " + std::to_string(simplex.vertex_count()) + " and " +
                     std::to_string(image.vertex_count()) + " vertices are no pair");
  }
}

/// Row or column i of a Gram matrix, counted from 1 as in the paper.
std::size_t index_of(const SimplexObject& simplex, long index) {
  if (index < 1 || static_cast<std::size_t>(index) > simplex.dimension()) {
    throw InputError("a Gram matrix of order " + std::to_string(simplex.dimension()) + " has no row " +
                     std::to_string(index));
  }
  return static_cast<std::size_t>(index) - 1;
}

SymmetricMatrix<Rational> gram_difference(const SimplexObject& simplex, const SimplexObject& image) {
  SymmetricMatrix<Rational> result = image.exact_gram().gram();
  for (std::size_t i = 0; i < result.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) result(i, j) -= simplex.exact_gram().gram()(i, j);
  }
  return result;
}

/// The alignment with one simplex, kept for the two quantities that are read from it.
template <class S>
struct AlignmentFrom {
  const SimplexObject* simplex;
  Partial<Alignment<S>> value;
};

template <class S>
Partial<Alignment<S>> known_alignment(Evaluation<S>& evaluation, Arguments<S> a) {
  const SimplexObject& simplex = simplex_in_pair(a[0]);
  const SimplexObject& image = simplex_in_pair(a[1]);
  require_pair(simplex, image);
  const auto& known = evaluation.template attached<AlignmentFrom<S>>(image, [&] {
    return AlignmentFrom<S>{&simplex, alignment(evaluation, simplex, image)};
  });
  return known.simplex == &simplex ? known.value : alignment(evaluation, simplex, image);
}

}  // namespace

void add_pair_quantities(Vocabulary& vocabulary) {
  vocabulary.add(
      number_function("gram_entry_difference", {types::simplex, types::simplex, types::integer, types::integer},
                      "E_ij of P̃ᵀP̃ = PᵀP + E, a squared length; i, j = 1 … k. The second simplex is the distorted one.",
                      "E_{#3#4}(#1, #2)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                        const SimplexObject& simplex = simplex_in_pair(a[0]);
                        const SimplexObject& image = simplex_in_pair(a[1]);
                        require_pair(simplex, image);
                        const std::size_t i = index_of(simplex, integer_of(a[2]));
                        const std::size_t j = index_of(simplex, integer_of(a[3]));
                        return scalar_from<S>(image.exact_gram().gram()(i, j) - simplex.exact_gram().gram()(i, j));
                      }));
  vocabulary.add(number_function(
      "gram_difference_norm", {types::simplex, types::simplex}, "‖E‖ = s_1(E) for P̃ᵀP̃ = PᵀP + E, a squared length.",
      "\\lVert E(#1, #2)\\rVert", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        require_pair(simplex_in_pair(a[0]), simplex_in_pair(a[1]));
        const auto values = eigenvalues_by_scaling<S>(gram_difference(simplex_in_pair(a[0]), simplex_in_pair(a[1])));
        return values ? Partial<S>(norm_from_eigenvalues(*values)) : Partial<S>::absent(values.exists());
      }));
  vocabulary.add(number_function(
      "alignment_error", {types::simplex, types::simplex},
      "The least ‖P̃ − ΦP‖ over all isometries Φ, a length. An upper bound of it holds by an isometry that is "
      "exhibited; a lower one by singular values only, hence a bound between the two stays undecided.",
      "\\min_\\Phi\\lVert \\tilde{P} - \\Phi P\\rVert(#1, #2)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const auto known = known_alignment(e, a);
        return known ? Partial<S>(known->matrix_error) : Partial<S>::absent(known.exists());
      }));
  vocabulary.add(number_function(
      "vertex_alignment_error", {types::simplex, types::simplex},
      "The least over all isometries Φ with Φp_0 = p̃_0 of the largest ‖p̃_i − Φp_i‖, a length. Upper bounds hold by the "
      "isometry that alignment_error exhibits, lower ones by lengths.",
      "\\min_\\Phi\\max_i\\lVert \\tilde{p}_i - \\Phi p_i\\rVert(#1, #2)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const auto known = known_alignment(e, a);
        return known ? Partial<S>(known->vertex_error) : Partial<S>::absent(known.exists());
      }));
}

}  // namespace delcert
