#pragma once

#include "tests/checker/support/space_form_model.hpp"

namespace delcert::checker_tests {

/// A model with margins that hold.
struct SpaceFormSample {
  SpaceFormModel model;
  SpaceFormMargins margins;
  std::set<std::string> levels;  // "5r": level 5 by Riemannian simplices as well

  Json document() const { return certificate(model, margins, levels); }
  SpaceFormSample claiming(std::set<std::string> some) const {
    SpaceFormSample result = *this;
    result.levels = std::move(some);
    return result;
  }
};

/// An icosphere of frequency 8 on the sphere, and half of its points on the projective plane.
const SpaceFormSample& icosphere();
const SpaceFormSample& projective_plane();
/// The vertices of the 600-cell on the 3-sphere, and half of them on the projective space.
const SpaceFormSample& cell_600();
const SpaceFormSample& projective_space();
/// The Bolza surface and a Klein bottle with random points.
const SpaceFormSample& bolza_surface();
const SpaceFormSample& klein_bottle();
/// The Bolza surface, perturbed so that stars agree, but some differ in the charts of others.
const SpaceFormSample& unstable_bolza_surface();

/// The manifold block of a surface with a short core of a crosscap, far from o: the right-angled octagon about o whose
/// sides have in turn the lengths log 2 / 2 and b, sinh^2 (b/2) = 4. Translations pair opposite long sides, the glide
/// reflections along diagonals opposite short ones. The element along a short side that makes half of the turn around
/// the crosscap moves its points by log 4, less than any other element moves a point, and o by d, cosh d = 30.25: of
/// all d within the sum of log 4 and the diameter of the octagon, cosh of which is 86, it is not among the first.
Json surface_with_far_crosscap();
/// It with random points.
const SpaceFormSample& far_crosscap();

}  // namespace delcert::checker_tests
