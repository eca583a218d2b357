#include "proofs/checker/certificate/gluing.hpp"

#include "proofs/checker/arithmetic/rational_function.hpp"
#include "proofs/checker/certificate/certificate.hpp"

namespace delcert::checker {
namespace {

Sides parse_sides(Cursor& cursor, std::size_t m) {
  Sides result;
  cursor.row(static_cast<int>(m), [&] {
    cursor.expect("[");
    const Quantity from(exact_value(cursor.number()));
    cursor.expect(",");
    result.push_back({from, Quantity(exact_value(cursor.number()))});
    cursor.expect("]");
    if (less(from.exact, result.back()[1].exact) != Verdict::proved)
      throw Malformed("form.ranges", "a side of a box is empty");
  });
  return result;
}

FormulaMap parse_formulas(Cursor& cursor, const std::vector<std::string_view>& variables, std::size_t number,
                          bool folds) {
  std::vector<std::string_view> formulas;
  cursor.array([&] { formulas.push_back(cursor.string()); });
  if (number != 0 && formulas.size() != number)
    throw Malformed("form.formula", "a transition has not as many formulas as variables");
  FormulaMap result(variables, formulas, folds);
  if (!is_rational(result, folds)) throw Malformed("form.formula", "a transition is no rational function");
  return result;
}

}  // namespace

Gluing::Gluing(int dimension, Cursor& cursor) : m(static_cast<std::size_t>(dimension)) {
  constexpr std::size_t most_charts = 64, most_transitions = 512;
  cursor.expect(",\"charts\":");
  cursor.array([&] {
    Chart chart;
    cursor.expect("{\"name\":");
    cursor.string();
    cursor.expect(",\"variables\":");
    cursor.array([&] { chart.variables.push_back(cursor.string()); });
    if (chart.variables.size() != m) throw Malformed("form.formula", "a chart has not as many variables as dimensions");
    require_names(chart.variables);
    cursor.expect(",\"domain\":");
    chart.domain = parse_sides(cursor, m);
    cursor.expect(",\"core\":");
    chart.core = parse_sides(cursor, m);
    for (std::size_t k = 0; k < m; ++k) {
      const bool inside = less(chart.domain[k][0].exact, chart.core[k][0].exact) == Verdict::proved &&
                          less(chart.core[k][1].exact, chart.domain[k][1].exact) == Verdict::proved;
      if (!inside) throw Malformed("form.ranges", "a core is not inside its domain");
    }
    cursor.expect("}");
    if (charts.size() == most_charts) throw Malformed("form.ranges", "there are too many charts");
    charts.push_back(std::move(chart));
  });
  cursor.expect(",\"transitions\":");
  cursor.array([&] {
    Transition transition;
    cursor.expect("{\"from\":");
    transition.from = cursor.count(UINT32_MAX);
    cursor.expect(",\"to\":");
    transition.to = cursor.count(UINT32_MAX);
    if (transition.from >= charts.size() || transition.to >= charts.size() || transition.from == transition.to)
      throw Malformed("form.ranges", "a transition does not join two of the charts");
    const auto &here = charts[transition.from].variables, &there = charts[transition.to].variables;
    cursor.expect(",\"map\":");
    transition.map = parse_formulas(cursor, here, m, true);
    cursor.expect(",\"inverse\":");
    transition.inverse = parse_formulas(cursor, there, m, true);
    cursor.expect(",\"where\":");
    transition.where = parse_formulas(cursor, here, 0, false);
    cursor.expect("}");
    if (transitions.size() == most_transitions) throw Malformed("form.ranges", "there are too many transitions");
    transitions.push_back(std::move(transition));
  });
  cursor.expect(",\"patch_radius\":");
  patch_radius = Quantity(exact_value(cursor.number()));
  Report::require("form.ranges", patch_radius.exact.sign() > 0, "patch_radius is not positive");
}

std::size_t Certificate::home_chart(Label i) const {
  const Rational stated = exact_value(chart_text[i * chart_size()]);
  std::size_t home = 0;
  while (home < gluing->charts.size() && !(stated == Rational(static_cast<int>(home)))) ++home;
  return home;
}

/// Without a home nothing can be looked at: no switch leaves that out.
void Certificate::require_gluing() const {
  const auto require = [](bool holds, const char* what) { Report::require("form.ranges", holds, what); };
  require(!claimed[level_2s] || reach_2s.exact.sign() > 0, "reach is not positive");
  require(
      !claimed[level_5] || (contraction.exact.sign() >= 0 && less(contraction.exact, Rational(1)) == Verdict::proved),
      "contraction is not in [0, 1)");
  require(!claimed[level_5] || displacement.exact.sign() >= 0, "displacement is negative");
  for (Label i = 0; i < n; ++i) {
    if (home_chart(i) == gluing->charts.size())
      throw Malformed("form.charts", "the home of " + std::to_string(i) + " is no chart");
  }
}

}  // namespace delcert::checker
