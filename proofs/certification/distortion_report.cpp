#include "proofs/certification/distortion_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certification/report_parts.hpp"
#include "support/text_table.hpp"

namespace delcert {

namespace {

constexpr int digits = 4;

std::string above(const Rational& x) { return decimal_upper(x, digits); }
std::string below(const Rational& x) { return decimal_lower(x, digits); }
std::string above(double x) { return above(Rational::exactly(x)); }
std::string below(double x) { return below(Rational::exactly(x)); }

/// "2^-253.1", not above it, or not below.
std::string lower_power(const PowerProduct& x) { return "2^" + below(x.log2().lower); }
std::string upper_power(const PowerProduct& x) { return "2^" + above(x.log2().upper); }

std::string change_text(const std::optional<Rational>& change, const Rational& allowed) {
  if (!change) return "an unknown amount";
  const Rational margin = allowed - *change;
  return fmt::format("≤ {}: margin ≥ {}", above(*change), below(margin));
}

std::string stability_text(const StabilityMargin& margin) {
  return fmt::format(
      "stability    stars stay as they are if distances in balls of radius {} change by ≤ {} (stability lemma)\n"
      "             transitions change them by {}\n"
      "             from charts to the manifold they change by {}\n",
      above(margin.radius), below(margin.allowed), change_text(margin.by_transitions, margin.allowed),
      change_text(margin.by_charts, margin.allowed));
}

/// What Theorem 3 and what it rests on ask for or guarantee, and what there is.
std::string ledger_text(const SpaceFormDistortion& found) {
  const Ledger& ledger = found.ledger;
  const auto asked = [](const PowerProduct& x) { return "≤ " + lower_power(x); };
  const auto guaranteed = [](const PowerProduct& x) { return "≥ " + lower_power(x); };
  std::vector<std::vector<std::string>> rows{
      {"ledger", "theorems", "here"},
      {"  ε", asked(found.demand.printed_radius) + ", mended " + asked(found.demand.mended_radius),
       exact_text(found.net.sampling_radius)},
      {"  points", guaranteed(found.demand.least_points), std::to_string(found.net.points)},
      {"  ξ₀", asked(ledger.distortion_bound), "≤ " + above(found.transitions.of_pairs.upper)},
      {"  η", asked(ledger.metric_distortion_bound), "≤ " + above(found.metric)},
      {"  tolerance/ε", lower_power(ledger.tolerance), exact_text(found.tolerance)}};
  if (found.stars) {
    rows.push_back({"  protection/ε", guaranteed(ledger.protection),
                    "≥ " + below(found.stars->protection / found.net.sampling_radius)});
    rows.push_back({"  thickness", guaranteed(power(ledger.flake_parameter, ledger.dimension.value)),
                    "≥ " + below(found.stars->thickness)});
  }
  return text_table(rows);
}

nlohmann::ordered_json logarithm_json(const PowerProduct& x) {
  const Bounds bounds = x.log2();
  return {lower_json(bounds.lower), upper_json(bounds.upper)};
}

}  // namespace

std::string distortion_text(const SpaceFormDistortion& found) {
  const TransitionDistortion& transitions = found.transitions;
  std::string out = fmt::format("distortion   of transitions ξ₀ ≤ {} (by each chart alone ≤ {})",
                                above(transitions.of_pairs.upper), above(transitions.proved));
  if (found.needed > 0) out += fmt::format("; some pair has ≥ {}", below(found.needed));
  out += fmt::format("\n             of charts against the manifold η ≤ {}\n", above(found.metric));
  if (found.stability) out += stability_text(*found.stability);
  return out + ledger_text(found);
}

nlohmann::ordered_json distortion_json(const SpaceFormDistortion& found) {
  const Rational& unit = found.net.sampling_radius;
  const auto longest = [&unit](const Rational& x) { return upper_json(x, Margin::Unit::length, unit); };
  const auto shortest = [&unit](const Rational& x) { return lower_json(x, Margin::Unit::length, unit); };
  const TransitionDistortion& transitions = found.transitions;
  nlohmann::ordered_json json{{"distortion",
                               {{"proved", upper_json(Rational::exactly(transitions.proved))},
                                {"at_most", upper_json(Rational::exactly(transitions.of_pairs.upper))},
                                {"farthest_pair", shortest(found.farthest)},
                                {"of_that_pair_at_least", lower_json(Rational::exactly(found.needed))}}},
                              {"metric_distortion", upper_json(Rational::exactly(found.metric))}};
  if (found.stability) {
    const StabilityMargin& margin = *found.stability;
    const auto change = [&](const std::optional<Rational>& at_most) -> nlohmann::ordered_json {
      if (!at_most) return nullptr;
      return {{"at_most", longest(*at_most)},
              {"margin", shortest(margin.allowed - *at_most)},
              {"is_enough", *at_most <= margin.allowed}};
    };
    json["stability"] = {{"radius", longest(margin.radius)},
                         {"centres", longest(margin.centres)},
                         {"allowed", shortest(margin.allowed)},
                         {"transitions", change(margin.by_transitions)},
                         {"charts", change(margin.by_charts)}};
  }
  json["hypotheses_2"] = {{"distortion_bound_log2", logarithm_json(found.ledger.distortion_bound)},
                          {"metric_distortion_bound_log2", logarithm_json(found.ledger.metric_distortion_bound)},
                          {"tolerance_log2", logarithm_json(found.ledger.tolerance)},
                          {"protection_log2", logarithm_json(found.ledger.protection)}};
  json["theorem_3"] = {{"sampling_radius_log2", logarithm_json(found.demand.printed_radius)},
                       {"sampling_radius_mended_log2", logarithm_json(found.demand.mended_radius)},
                       {"points_at_least_log2", logarithm_json(found.demand.least_points)},
                       {"is_met", found.demand.is_met}};
  return json;
}

std::string theory_refusal(const Ledger& ledger, const MeasuredNet& net) {
  const RiemannianDemand demand = riemannian_demand(ledger, net);
  return fmt::format(
      "mode theory on a curved manifold: Theorem 3 asks for a sampling radius of {} at most and so for at least {} "
      "points, Hypotheses 2 for a distortion of {} at most (delcert constants has all of it); here it is {} with {} "
      "points: use --mode measured",
      demand.printed_radius.text(), lower_power(demand.least_points), upper_power(ledger.distortion_bound),
      exact_text(net.sampling_radius), net.points);
}

}  // namespace delcert
