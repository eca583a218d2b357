#include "kernel/manifold/quotient/space_form.hpp"

#include "kernel/manifold/quotient/tile_walk.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t greatest_order = 2000;

void require_isometries(const SpaceFormDescription& description) {
  for (std::size_t at = 0; at < description.generators.size(); ++at) {
    const std::string name = "generator " + std::to_string(at + 1);
    const FieldMatrix& generator = description.generators[at];
    if (generator.order() != description.form.matrix().order())
      throw Rejection(name + " has order " + std::to_string(generator.order()) + ", expected " +
                      std::to_string(description.form.matrix().order()));
    if (const auto reason = description.form.why_no_isometry(generator)) throw Rejection(name + ": " + *reason);
    if (is_identity(generator)) throw Rejection(name + " is the identity");
  }
}

void verify_spherical(SpaceForm& result) {
  result.finite = closure(result.form(), result.description.generators, greatest_order);
  require_free(*result.finite);
  const std::size_t order = result.finite->elements.size();
  if (result.description.order && *result.description.order != order)
    throw Rejection("the group has order " + std::to_string(order) + ", the description says " +
                    std::to_string(*result.description.order));
  result.first_homology = result.finite->abelianisation;
  result.injectivity_radius = injectivity_radius(result.form(), *result.finite);
}

void verify_flat(SpaceForm& result) {
  result.crystallographic = crystallographic_group(result.form(), result.description.generators);
  result.first_homology = result.crystallographic->abelianisation;
  result.injectivity_radius = injectivity_radius(*result.crystallographic);
}

void verify_hyperbolic(SpaceForm& result) {
  std::vector<FieldMatrix> elements;
  std::vector<std::string> names;
  for (std::size_t at = 0; at < result.description.generators.size(); ++at) {
    const FieldMatrix& generator = result.description.generators[at];
    const std::string name = "generator " + std::to_string(at + 1);
    const FieldMatrix inverse = result.form().inverse_of(generator);
    if (inverse == generator) throw Rejection(name + " is its own inverse: it fixes a point");
    elements.push_back(generator);
    names.push_back(name);
    elements.push_back(inverse);
    names.push_back("inverse of " + name);
  }
  result.polyhedron = dirichlet_polyhedron(result.form(), elements, names, ElementsWithoutSide::are_errors);
  result.cycles = verify_poincare(result.form(), *result.polyhedron, names);
  result.first_homology = result.cycles->abelianisation;
  result.injectivity_radius = injectivity_radius(result.form(), *result.polyhedron);
}

void verify(SpaceForm& result) {
  const InvariantForm& form = result.form();
  if (form.dimension() < 2 || form.dimension() > 3)
    throw Rejection("dimension " + std::to_string(form.dimension()) + ", expected 2 or 3");
  require_isometries(result.description);
  for (const FieldMatrix& generator : result.description.generators)
    result.is_orientable = result.is_orientable && determinant(generator).sign() > 0;
  if (result.description.order && form.curvature() != Curvature::positive)
    throw Rejection("an order is given, but the group of a closed manifold without positive curvature is infinite");
  switch (form.curvature()) {
    case Curvature::positive:
      verify_spherical(result);
      break;
    case Curvature::zero:
      verify_flat(result);
      break;
    case Curvature::negative:
      verify_hyperbolic(result);
      break;
  }
  const std::string homology = group_text(result.first_homology);
  if (result.description.first_homology && *result.description.first_homology != homology)
    throw Rejection("the group is that of another manifold: its first homology is " + homology +
                    ", the description says " + *result.description.first_homology);
}

}  // namespace

std::vector<FieldMatrix> SpaceForm::elements_within(const Rational& radius) const {
  if (finite) return finite->elements;
  if (polyhedron) return tiles_with_centre_within(form(), *polyhedron, BigInterval(radius));
  std::vector<FieldMatrix> result{FieldMatrix::identity(form().matrix().order())};
  for (FieldMatrix& element : short_elements(form(), *crystallographic, square(radius)))
    result.push_back(std::move(element));
  return result;
}

SpaceForm verify_space_form(const SpaceFormDescription& description) {
  SpaceForm result{description, true, {}, {}, {}, {}, {}, {}};
  try {
    verify(result);
  } catch (const Rejection& rejection) {
    throw Rejection(description.name + ": " + rejection.what());
  }
  return result;
}

}  // namespace delcert
