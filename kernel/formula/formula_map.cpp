#include "kernel/formula/formula_map.hpp"

#include <cmath>
#include <concepts>
#include <utility>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/formula_functions.hpp"
#include "kernel/formula/plain_formula.hpp"

namespace delcert {

namespace {

using Node = FormulaGraph::Node;

template <class S>
S scalar_of(const Rational& x) {
  if constexpr (std::same_as<S, double>) {
    return approximate_double(x);
  } else {
    return scalar_from<S>(x);
  }
}

template <class S>
bool is_certainly_positive(const S& x) {
  if constexpr (std::same_as<S, double>) {
    return x > 0;
  } else if constexpr (std::same_as<S, Interval>) {
    return x.lower() > 0;
  } else {
    return is_proved(less(BigInterval(0), x));
  }
}

template <class S>
bool is_certainly_not_zero(const S& x) {
  return is_certainly_positive(x) || is_certainly_positive(-x);
}

double value_of_root(double x) { return std::sqrt(x); }
Interval value_of_root(const Interval& x) { return square_root(x); }
BigInterval value_of_root(const BigInterval& x) { return square_root(x); }

template <class S>
S value_of_function(FormulaStep step, const S& x) {
  if constexpr (std::same_as<S, double>) {
    if (step == FormulaStep::exponential) return approximate_exponential(x);
    return step == FormulaStep::sine ? approximate_sine(x) : approximate_cosine(x);
  } else {
    if (step == FormulaStep::exponential) return exponential(x);
    return step == FormulaStep::sine ? sine(x) : cosine(x);
  }
}

}  // namespace

FormulaMap::FormulaMap(std::vector<std::string> variables, const std::vector<std::string>& formulas)
    : variables_(std::move(variables)) {
  std::vector<Node> functions;
  for (const std::string& formula : formulas) {
    try {
      const ExpressionPointer tree = parse_plain_formula(formula, variables_);
      texts_.push_back(canonical_text(*tree));
      functions.push_back(graph_.add_formula(*tree, variables_));
    } catch (const FormulaError& error) {
      if (formulas.size() == 1) throw;
      throw FormulaError(error.offset(), "formula " + std::to_string(functions.size() + 1) + ": " + error.what());
    }
  }
  std::vector<Node> results = functions;
  programs_[0] = program_for(results);
  for (const Node function : functions)
    for (std::size_t i = 0; i < variable_count(); ++i) results.push_back(graph_.derivative(function, i));
  programs_[1] = program_for(results);
  for (const Node function : functions)
    for (std::size_t i = 0; i < variable_count(); ++i)
      for (std::size_t j = i; j < variable_count(); ++j)
        results.push_back(graph_.derivative(graph_.derivative(function, i), j));
  programs_[2] = program_for(std::move(results));
}

FormulaMap::Program FormulaMap::program_for(std::vector<FormulaGraph::Node> results) const {
  std::vector<bool> is_needed(graph_.size());
  for (const Node node : results) is_needed[node] = true;
  for (const Node node : graph_.partial_nodes()) is_needed[node] = true;
  for (std::size_t at = graph_.size(); at-- > 0;) {
    if (!is_needed[at]) continue;
    const FormulaGraph::Data& data = graph_[static_cast<Node>(at)];
    if (data.step == FormulaStep::constant || data.step == FormulaStep::variable) continue;
    is_needed[data.first] = true;
    if (data.step == FormulaStep::add || data.step == FormulaStep::subtract || data.step == FormulaStep::multiply ||
        data.step == FormulaStep::divide)
      is_needed[data.second] = true;
  }
  Program result;
  result.results = std::move(results);
  for (std::size_t at = 0; at < graph_.size(); ++at) {
    const auto node = static_cast<Node>(at);
    const FormulaGraph::Data& data = graph_[node];
    if (is_needed[at] && data.step != FormulaStep::constant)
      result.steps.push_back({data.step, node, data.first, data.second});
  }
  return result;
}

template <class S>
FormulaEvaluation<S>::FormulaEvaluation(const FormulaMap& map) : map_(map), values_(map.graph().size(), S(0)) {
  for (std::size_t at = 0; at < values_.size(); ++at) {
    const FormulaGraph::Data& data = map.graph()[static_cast<Node>(at)];
    if (data.step == FormulaStep::constant) values_[at] = scalar_of<S>(data.value);
  }
}

template <class S>
bool FormulaEvaluation<S>::run(const FormulaMap::Program& program, const S* x) {
  S* const values = values_.data();
  for (const FormulaMap::Step& data : program.steps) {
    const Node node = data.node;
    const S& a = values[data.step == FormulaStep::variable ? 0 : data.first];
    switch (data.step) {
      case FormulaStep::constant:
        break;
      case FormulaStep::variable:
        values[node] = x[data.first];
        break;
      case FormulaStep::add:
        values[node] = a + values[data.second];
        break;
      case FormulaStep::subtract:
        values[node] = a - values[data.second];
        break;
      case FormulaStep::negate:
        values[node] = -a;
        break;
      case FormulaStep::multiply:
        values[node] = a * values[data.second];
        break;
      case FormulaStep::divide:
        if (!is_certainly_not_zero(values[data.second])) return false;
        values[node] = a / values[data.second];
        break;
      case FormulaStep::power:
        values[node] = whole_power(a, data.second);
        break;
      case FormulaStep::root:
        if (!is_certainly_positive(a)) return false;
        values[node] = value_of_root(a);
        break;
      default:
        values[node] = value_of_function(data.step, a);
    }
  }
  return true;
}

template <class S>
bool FormulaEvaluation<S>::value(const S* x, S* f) {
  const FormulaMap::Program& program = map_.program(0);
  if (!run(program, x)) return false;
  for (std::size_t k = 0; k < map_.function_count(); ++k) f[k] = values_[program.results[k]];
  return true;
}

template <class S>
bool FormulaEvaluation<S>::first(const S* x, S* f, S* df) {
  const FormulaMap::Program& program = map_.program(1);
  if (!run(program, x)) return false;
  const std::size_t q = map_.function_count();
  for (std::size_t k = 0; k < q; ++k) f[k] = values_[program.results[k]];
  for (std::size_t k = 0; k < q * map_.variable_count(); ++k) df[k] = values_[program.results[q + k]];
  return true;
}

template <class S>
bool FormulaEvaluation<S>::second(const S* x, S* f, S* df, S* ddf) {
  const FormulaMap::Program& program = map_.program(2);
  if (!run(program, x)) return false;
  const std::size_t q = map_.function_count();
  const std::size_t n = map_.variable_count();
  const Node* result = program.results.data();
  for (std::size_t k = 0; k < q; ++k) f[k] = values_[*result++];
  for (std::size_t k = 0; k < q * n; ++k) df[k] = values_[*result++];
  for (std::size_t k = 0; k < q; ++k) {
    S* const square = ddf + k * n * n;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) square[i * n + j] = square[j * n + i] = values_[*result++];
  }
  return true;
}

template class FormulaEvaluation<double>;
template class FormulaEvaluation<Interval>;
template class FormulaEvaluation<BigInterval>;

}  // namespace delcert
