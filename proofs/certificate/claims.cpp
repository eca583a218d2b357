#include "proofs/certificate/claims.hpp"

#include <algorithm>
#include <array>

#include "kernel/topology/homology.hpp"
#include "proofs/certificate/document.hpp"

namespace delcert {

namespace {

using Side = Margin::Side;
using Unit = Margin::Unit;

LevelEntry fact(std::string key, std::string json) { return {std::move(key), {}, std::move(json)}; }
LevelEntry truth(std::string key, bool value) { return fact(std::move(key), value ? "true" : "false"); }
LevelEntry stated_bound(std::string key, const Rational& value, Side side, Unit unit) {
  return {std::move(key), {{value, side, unit}}, number(value)};
}
LevelEntry at_least(std::string key, const Rational& value, Unit unit = Unit::length) {
  return stated_bound(std::move(key), value, Side::lower, unit);
}
LevelEntry at_most(std::string key, const Rational& value, Unit unit = Unit::length) {
  return stated_bound(std::move(key), value, Side::upper, unit);
}

using Entries = std::vector<LevelEntry>;

Entries entries_of(const InputClaim& claim) {
  if (claim.hypotheses_2) {
    Entries result{truth("hypotheses_2", *claim.hypotheses_2)};
    // The printed ones go without saying.
    if (*claim.hypotheses_2 && claim.constraints != ParameterConstraints::printed)
      result.push_back(fact("hypotheses", quoted(std::string(name_of(claim.constraints)))));
    return result;
  }
  return {at_most("density", claim.density->density), at_most("distortion", claim.density->distortion, Unit::one),
          at_most("metric_distortion", claim.density->metric_distortion, Unit::one)};
}

Entries entries_of(const StarMargins& margins) {
  return {at_least("protection", margins.protection), at_least("thickness", margins.thickness, Unit::one),
          at_most("circumradius", margins.circumradius)};
}

Entries entries_of(const ManifoldClaim& claim) {
  return {fact("simplices", std::to_string(claim.simplices)),
          fact("euler_characteristic", std::to_string(claim.euler_characteristic)), truth("closed", claim.closed),
          fact("homology", listed(claim.homology, [](const AbelianGroup& g) { return quoted(group_text(g)); }))};
}

Entries entries_of(const StableStarsClaim& claim) {
  return claim.reach ? Entries{at_most("reach", *claim.reach)} : Entries{};
}

Entries entries_of(const std::string& no_forbidden) { return {fact("tested", quoted(no_forbidden))}; }

Entries entries_of(const DelaunayClaim& claim) {
  if (claim.balls)
    return {at_least("protection", claim.balls->protection), at_most("circumradius", claim.balls->circumradius)};
  if (claim.stability)
    return {at_least("edge", claim.stability->edge), at_least("margin", claim.stability->margin, Unit::squared_length)};
  if (claim.restricted) {
    const auto& [extrinsic, intrinsic, density] = *claim.restricted;
    return {fact("metric", quoted(!intrinsic  ? "extrinsic"
                                  : extrinsic ? "both"
                                              : "intrinsic")),
            at_most("density", density)};
  }
  return {};
}

Entries entries_of(const TriangulationClaim& claim) {
  Entries result{fact("route", quoted(claim.route))};
  if (claim.riemannian) {
    result.push_back(at_least("thickness", claim.riemannian->thickness, Unit::one));
    result.push_back(at_most("radius", claim.riemannian->radius));
  }
  if (claim.graph) {
    result.push_back(at_most("contraction", claim.graph->contraction, Unit::one));
    result.push_back(at_most("displacement", claim.graph->displacement));
  }
  return result;
}

Entries entries_of(const IsotopyClaim& claim) {
  if (claim.cosine) return {at_least("cosine", *claim.cosine, Unit::one)};
  return {at_least("margin", *claim.margin)};
}

Entries entries_of(const FullStarsClaim&) { return {}; }

Entries entries_of(const MetricClaim& claim) {
  Entries result{truth("self_delaunay", claim.self_delaunay)};
  if (claim.weight) result.push_back(at_least("weight", *claim.weight, Unit::one));
  const bool is_isometric = claim.least_stretch == Rational(1) && claim.greatest_stretch == Rational(1);
  result.push_back(
      {"bilipschitz",
       {{claim.least_stretch, Side::lower, Unit::one}, {claim.greatest_stretch, Side::upper, Unit::one}},
       is_isometric ? number(Rational(1)) : listed(std::array{claim.least_stretch, claim.greatest_stretch}, number)});
  if (claim.normal) result.push_back(at_most("normal", *claim.normal, Unit::one));
  return result;
}

}  // namespace

std::vector<ClaimedLevel> claimed_levels(const Claims& claims) {
  std::vector<ClaimedLevel> result;
  const auto add = [&result](const char* name, const auto& claim) {
    if (claim) result.push_back({name, entries_of(*claim)});
  };
  add("0", claims.input);
  add("1", claims.stars);
  add("1f", claims.full_stars);
  add("2", claims.manifold);
  add("2s", claims.stable_stars);
  add("3", claims.no_forbidden);
  add("4", claims.delaunay);
  add("5", claims.triangulation);
  add("5i", claims.isotopy);
  add("6", claims.metric);
  return result;
}

std::vector<std::string> Claims::names() const {
  std::vector<std::string> result;
  for (const ClaimedLevel& level : claimed_levels(*this)) result.push_back(level.name);
  return result;
}

ManifoldClaim manifold_claim(const PureComplex& complex, std::size_t simplices, bool closed) {
  return {simplices, static_cast<long>(complex.euler_characteristic()), closed, homology(complex)};
}

const LevelSelection& all_levels() {
  static const LevelSelection levels{"0", "1", "1f", "2", "2s", "3", "4", "5", "5i", "6"};
  return levels;
}

bool selects(const LevelSelection& selection, std::string_view level) {
  return std::find(selection.begin(), selection.end(), level) != selection.end();
}

}  // namespace delcert
