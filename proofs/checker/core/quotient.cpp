#include "proofs/checker/core/rules.hpp"

namespace delcert::checker::core {
namespace {

bool is_isometry(const Data& data, const FieldMatrix& g) {
  if (data.K != 0) {
    return g.transposed() * data.form * g == data.form && (data.K > 0 || g(0, 0).sign() > 0);
  }
  FieldMatrix linear(data.m);
  bool affine = g(0, 0) == FieldElement(1);
  for (std::size_t i = 0; i < data.m; ++i) {
    affine = affine && g(0, i + 1).is_zero();
    for (std::size_t k = 0; k < data.m; ++k) linear(i, k) = g(i + 1, k + 1);
  }
  return affine && linear.transposed() * data.form * linear == data.form;
}

/// Whether the path is one of edges that begins and ends at label 0.
bool is_closed_at_0(const Complex& complex, const std::vector<Step>& loop) {
  Label at = 0;
  for (const Step& step : loop) {
    if (complex.label(step.simplex, step.from) != at) return false;
    at = complex.label(step.simplex, step.to);
  }
  return at == 0;
}

Elements::Id product_along(Complex& complex, const std::vector<Step>& loop) {
  Elements::Id product = 0;
  for (const Step& step : loop) {
    const Elements::Id phi =
        complex.elements.relative(complex.element(step.simplex, step.from), complex.element(step.simplex, step.to));
    product = complex.elements.product(product, phi);
  }
  return product;
}

void check_loops(Complex& complex, Report& report) {
  const Data& data = complex.data;
  if (data.loops.size() != data.generators.size()) {
    report.reject("core.group", [&] {
      return std::to_string(data.generators.size()) + " generators have " + std::to_string(data.loops.size()) +
             " loops";
    });
    return;
  }
  for (std::size_t k = 0; k < data.loops.size(); ++k) {
    if (is_closed_at_0(complex, data.loops[k]) &&
        product_along(complex, data.loops[k]) == complex.elements.find(data.generators[k]))
      continue;
    report.reject("core.group", [&] {
      return "loop " + std::to_string(k + 1) + " is not a closed path at label 0 along generator " +
             std::to_string(k + 1);
    });
  }
}

void check_connected(const Complex& complex, Report& report) {
  std::vector<bool> reached(complex.size(), false);
  std::vector<Label> front{0};
  reached[0] = true;
  std::size_t number = 1;
  while (!front.empty()) {
    const Label i = front.back();
    front.pop_back();
    for (std::size_t at = 0; at < complex.neighbours.size(i); ++at) {
      const Label j = complex.neighbours.of(i)[at].label;
      if (reached[j]) continue;
      reached[j] = true;
      front.push_back(j);
      ++number;
    }
  }
  if (number == complex.size()) return;
  report.reject("core.connected",
                [&] { return std::to_string(complex.size() - number) + " labels are not connected with label 0"; });
}

}  // namespace

bool are_isometries(const Data& data, Report& report) {
  for (std::size_t k = 0; k < data.generators.size(); ++k) {
    if (is_isometry(data, data.generators[k])) continue;
    report.reject("core.group", [&] { return "generator " + std::to_string(k + 1) + " is no isometry"; });
    return false;
  }
  return true;
}

void check_quotient(Complex& complex, Report& report) {
  check_loops(complex, report);
  check_connected(complex, report);
}

}  // namespace delcert::checker::core
