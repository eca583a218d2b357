#include "proofs/formal/formal_parameters.hpp"

namespace delcert {

namespace {

/// A rational lower or upper bound of the root: the root itself if it is rational.
Rational enclosed_root(const Rational& x, bool upper) {
  constexpr long precision = -30;
  const Rational scaled = x * Rational::power_of_two(-2 * precision) * square(Rational(x.denominator()));
  const Integer floor = sqrt(floor_of(scaled));
  const bool exact = Rational(floor) * Rational(floor) == scaled;
  return Rational(upper && !exact ? Integer(floor + 1) : floor) * Rational::power_of_two(precision) /
         Rational(x.denominator());
}

std::string premise(const std::string& left, bool strict, const std::string& right) {
  return left + (strict ? " < " : " <= ") + right;
}

/// The name of the hypothesis on an end.
std::string lower_name(const FormalParameter& parameter) { return coq_name(parameter.name) + "_lower"; }
std::string upper_name(const FormalParameter& parameter) { return coq_name(parameter.name) + "_upper"; }

}  // namespace

std::string FormalParameter::variable_name() const { return is_squared ? "root_" + name : coq_name(name); }

std::string FormalParameter::text() const {
  return is_squared ? "(" + variable_name() + " * " + variable_name() + ")" : coq_name(name);
}

FormalVariable FormalParameter::variable() const {
  FormalVariable result{variable_name(), range.lower, range.upper, !range.has_lower, !range.has_upper};
  if (!is_squared) return result;
  result.lower = range.lower ? enclosed_root(maximum(*range.lower, Rational(0)), false) : Rational(0);
  if (!range.lower || *range.lower < Rational(0)) result.lower_open = false;
  if (range.upper) result.upper = enclosed_root(*range.upper, true);
  return result;
}

FormalParameters formal_parameters(const Step& step) {
  FormalParameters result;
  for (const auto& [name, range] : step.parameters) result.push_back({name, range, false});
  return result;
}

CoqNames coq_names(const FormalParameters& parameters) {
  CoqNames result;
  for (const FormalParameter& parameter : parameters) result[parameter.name] = parameter.text();
  return result;
}

std::string range_premises(const FormalParameters& parameters) {
  std::string result;
  for (const FormalParameter& parameter : parameters) {
    const auto& [is_integer, lower, upper, has_lower, has_upper] = parameter.range;
    std::string line;
    if (lower) line += premise(coq_number(*lower), !has_lower, coq_name(parameter.name)) + " -> ";
    if (upper) line += premise(coq_name(parameter.name), !has_upper, coq_number(*upper)) + " -> ";
    if (line.empty()) continue;
    line.pop_back();
    result += "  " + line + "\n";
  }
  return result;
}

std::string introduction(const FormalParameters& parameters, std::size_t further) {
  std::string names;
  std::string roots;
  for (const FormalParameter& parameter : parameters) names += " " + coq_name(parameter.name);
  for (const FormalParameter& parameter : parameters) {
    if (parameter.range.lower) names += " " + lower_name(parameter);
    if (parameter.range.upper) names += " " + upper_name(parameter);
    if (!parameter.is_squared) continue;
    const std::string name = coq_name(parameter.name);
    const FormalVariable variable = parameter.variable();
    roots += "destruct (root_of " + name + ") as (" + variable.text + " & " + variable.text + "_nonneg & " +
             variable.text + "_square); [lra |]; subst " + name + ".\n";
    if (parameter.range.lower && *parameter.range.lower >= Rational(0)) {
      roots += "assert (" + premise(coq_number(*variable.lower), variable.lower_open, variable.text) + ") by (apply (" +
               (variable.lower_open ? "root_above " : "root_at_least ") + variable.text + " " +
               coq_number(*variable.lower) + " " + coq_number(*parameter.range.lower) + "); lra).\n";
    }
    if (parameter.range.upper) {
      roots += "assert (" + premise(variable.text, variable.upper_open, coq_number(*variable.upper)) + ") by (apply (" +
               (variable.upper_open ? "root_below " : "root_at_most ") + variable.text + " " +
               coq_number(*variable.upper) + " " + coq_number(*parameter.range.upper) + "); lra).\n";
    }
  }
  for (std::size_t at = 1; at <= further; ++at) names += " given_" + std::to_string(at);
  return (names.empty() ? "" : "intros" + names + ".\n") + roots;
}

}  // namespace delcert
