#include "kernel/manifold/input_check.hpp"

#include "kernel/manifold/lattice.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

template <int m>
InputItem patches_of_torus(const FlatAtlas<m>& atlas) {
  const Rational squared = squared_systole<m>(atlas.metric());
  const Rational factor = Rational(2) * atlas.patch_factor() + Rational(6);
  const Rational least = factor * atlas.sampling_radius();
  const bool vary = atlas.radii().vary();
  const bool are_small_enough = square(least) <= squared;
  // Where radii vary, it is not one number that would have to be smaller.
  const std::string advice = are_small_enough || vary
                                 ? ""
                                 : ": take a sampling radius of at most " +
                                       exact_text(simple_fraction_at_most(square_root_lower(squared, 32) / factor));
  return {vary ? "patches: every label at one lift in B(p_i, bε_i), the same lift for all charts that are compared"
               : "patches: every label at one lift in B(p_i, 9ε), the same lift for all charts that are compared",
          verdict_of(are_small_enough),
          "shortest lattice vector² " + exact_text(squared) + ", must be at least " +
              (vary ? "((2b + 6)·max ε_i)² = " : "(24ε)² = ") + exact_text(square(least)) +
              (vary ? ", b = 9(1 + ε₀) = " + exact_text(atlas.patch_factor()) : "") + advice};
}

/// What is compared of density, radii and domains where radii vary.
template <int m>
std::string details_of_radii(const FlatAtlas<m>& atlas) {
  const SamplingRadii& radii = atlas.radii();
  return "ε_i from " + exact_text(radii.greatest() * Rational::exactly(radii.least_unit())) + " to " +
         exact_text(radii.greatest());
}

template <int m>
InputItem patches_of_ball(const FlatAtlas<m>& atlas) {
  std::size_t interior = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) interior += atlas.is_interior(Label(index)) ? 1U : 0U;
  return {"patches: B(p_i, 8ε) within the ball that the net covers", verdict_of(interior > 0),
          std::to_string(interior) + " of " + std::to_string(atlas.size()) +
              " labels; stars are claimed for these, there must be at least one"};
}

}  // namespace

template <int m>
std::vector<InputItem> check_input(const FlatAtlas<m>& atlas, const Rational& separation,
                                   const Rational& perturbation) {
  const bool vary = atlas.radii().vary();
  const Rational tilde = (Rational(1) + atlas.radius_variation()) * perturbation;
  std::vector<InputItem> items;
  items.push_back({"separation: distances at least μ₀ε in every chart", Verdict::proved,
                   "μ₀ = " + exact_text(separation) + ", measured"});
  items.push_back(
      {vary ? "density: B(p_i, 8ε_i) is within ε_i of the net" : "density: B(p_i, 8ε) is within ε of the net",
       Verdict::proved,
       (vary ? details_of_radii<m>(atlas) : "ε = " + exact_text(atlas.sampling_radius())) +
           ", certified by a covering with smaller balls"});
  items.push_back(atlas.space().is_torus() ? patches_of_torus<m>(atlas) : patches_of_ball<m>(atlas));
  items.push_back({"radius variation: |ε_i − ε_j| ≤ ε₀ min(ε_i, ε_j)",
                   verdict_of(atlas.radius_variation() <= Rational(1)),
                   vary ? "ε₀ = " + exact_text(atlas.radius_variation()) + ", measured within b·max(ε_i, ε_j)"
                        : "ε₀ = 0, one radius"});
  items.push_back({vary ? "domains: B(p_i, 6ε_i) ∩ B(p_j, 9ε_i) in U_ij" : "domains: B(p_i, 6ε) ∩ B(p_j, 9ε) in U_ij",
                   items[2].verdict, "U_ij is the intersection of the patches"});
  items.push_back({"transitions: inverse to each other, compatible with the labels, distortion ξ₀", items[2].verdict,
                   "translations, ξ₀ = 0"});
  items.push_back({vary ? "perturbation: (1 + ε₀)ρ₀ ≤ μ₀/4" : "perturbation: ρ₀ ≤ μ₀/4",
                   verdict_of(tilde * Rational(4) <= separation),
                   "ρ₀ = " + exact_text(perturbation) + ", μ₀/4 = " + exact_text(separation / Rational(4))});
  return items;
}

#define DELCERT_INSTANTIATE(m) \
  template std::vector<InputItem> check_input<m>(const FlatAtlas<m>&, const Rational&, const Rational&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
