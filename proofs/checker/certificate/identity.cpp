#include "proofs/checker/certificate/identity.hpp"

#include "proofs/checker/arithmetic/abelian_group.hpp"
#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/certificate/printable.hpp"

namespace delcert::checker {
namespace {

/// The number, or a decimal one below it if it is long.
std::string short_text(const Rational& x) {
  if (fmpz_bits(fmpq_numref(x.raw())) > 60 || fmpz_bits(fmpq_denref(x.raw())) > 60) return ">= " + rounded_down(x);
  char* text = fmpq_get_str(nullptr, 10, x.raw());
  std::string result = text;
  flint_free(text);
  return result;
}

SquareMatrix<Rational> matrix_of(const Certificate& c) {
  SquareMatrix<Rational> result(c.m_size());
  for (std::size_t k = 0; k < c.gram.size(); ++k) result(k / c.m_size(), k % c.m_size()) = c.gram[k];
  return result;
}

}  // namespace

Identity identify(const Certificate& c) {
  Identity result;
  result.dimension = c.m;
  result.name = printable(c.name);
  result.manifold_digest = sha256(c.manifold_text);
  if (c.space_form) {
    result.family = c.space_form->K > 0 ? "spherical" : c.space_form->K == 0 ? "flat" : "hyperbolic";
    return result;
  }
  if (c.gluing) {
    result.family = "atlas";
    result.size = std::to_string(c.gluing->charts.size()) + " charts, " + std::to_string(c.gluing->transitions.size()) +
                  " transitions";
    return result;
  }
  if (c.submanifold) {
    result.family = "submanifold";
    result.size = "in R^" + std::to_string(c.submanifold->N);
    return result;
  }
  result.orientability = "orientable";
  result.first_homology = group_text(c.has_boundary() ? 0 : c.m_size(), {});
  if (c.metric_field) {
    result.family = "metric-field";
    result.size = std::to_string(c.metric_field->waves.size()) + " waves";
  } else if (c.torus) {
    result.family = "flat-torus";
    result.size = "squared volume " + short_text(matrix_of(c).leading_minor(c.m_size()));
  } else {
    result.family = "euclidean-ball";
    result.size = "radius " + short_text(c.radius.exact);
  }
  return result;
}

std::string to_string(const Identity& identity, bool with_name) {
  std::string text = identity.family + ", dimension " + std::to_string(identity.dimension);
  if (!identity.size.empty()) text += ", " + identity.size;
  if (!identity.orientability.empty()) text += ", " + identity.orientability;
  text += identity.first_homology.empty() ? ", H1 not looked at"
                                          : ", H1 = " + identity.first_homology + " by " + identity.homology_of;
  if (with_name) text += "; name \"" + identity.name + "\" as stated";
  text += "; SHA-256 of the manifold block " + identity.manifold_digest;
  if (!identity.file_digest.empty()) text += ", of the file " + identity.file_digest;
  return text;
}

}  // namespace delcert::checker
