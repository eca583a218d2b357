#include "kernel/formula/trigonometric_polynomial.hpp"

#include <algorithm>
#include <optional>

#include "kernel/formula/formula_error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_waves_of_formula = 1000;
constexpr int greatest_factor = 1000;

[[noreturn]] void refuse(const Expression& at, const std::string& what) { throw FormulaError(at.offset, what); }

/// The rational number that a formula without variables and functions is.
std::optional<Rational> number_of(const Expression& formula) {
  if (formula.operation == Operation::literal) return formula.value;
  std::vector<Rational> values;
  for (const auto& child : formula.children) {
    const auto value = number_of(*child);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  switch (formula.operation) {
    case Operation::negate:
      return -values[0];
    case Operation::add:
      return values[0] + values[1];
    case Operation::subtract:
      return values[0] - values[1];
    case Operation::multiply:
      return values[0] * values[1];
    case Operation::divide:
      if (values[1] == Rational(0)) refuse(formula, "a division by 0");
      return values[0] / values[1];
    default:
      return std::nullopt;
  }
}

/// The integers k of a sum k·u of variables, which a sine or a cosine is taken of.
std::vector<int> frequency_of(const Expression& formula, const std::vector<std::string>& variables) {
  const auto combined = [&](std::size_t first, std::size_t second, int sign) {
    std::vector<int> result = frequency_of(*formula.children[first], variables);
    const std::vector<int> other = frequency_of(*formula.children[second], variables);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += sign * other[k];
    return result;
  };
  const auto scaled = [&](std::vector<int> result, const Rational& by) {
    if (by.denominator() != 1 || absolute(by) > Rational(greatest_factor))
      refuse(formula, "a factor that is no small integer in a sine or a cosine");
    for (int& k : result) k *= by.numerator().convert_to<int>();
    return result;
  };
  switch (formula.operation) {
    case Operation::name: {
      std::vector<int> result(variables.size(), 0);
      const auto found = std::find(variables.begin(), variables.end(), formula.text);
      result[static_cast<std::size_t>(found - variables.begin())] = 1;
      return result;
    }
    case Operation::negate:
      return scaled(frequency_of(*formula.children[0], variables), Rational(-1));
    case Operation::add:
      return combined(0, 1, 1);
    case Operation::subtract:
      return combined(0, 1, -1);
    case Operation::multiply:
      for (const std::size_t factor : {0U, 1U}) {
        if (const auto by = number_of(*formula.children[factor]))
          return scaled(frequency_of(*formula.children[1 - factor], variables), *by);
      }
      break;
    default:
      break;
  }
  refuse(formula, "no sum of variables times integers in a sine or a cosine");
}

}  // namespace

TrigonometricPolynomial::TrigonometricPolynomial(std::size_t variables, const Rational& constant)
    : variables_(variables) {
  add(std::vector<int>(variables, 0), {constant, Rational(0)});
}

TrigonometricPolynomial TrigonometricPolynomial::cosine(const std::vector<int>& frequency) {
  TrigonometricPolynomial result(frequency.size());
  result.add(frequency, {Rational(1), Rational(0)});
  return result;
}

TrigonometricPolynomial TrigonometricPolynomial::sine(const std::vector<int>& frequency) {
  TrigonometricPolynomial result(frequency.size());
  result.add(frequency, {Rational(0), Rational(1)});
  return result;
}

void TrigonometricPolynomial::add(std::vector<int> frequency, Wave wave) {
  const auto first = std::find_if(frequency.begin(), frequency.end(), [](int k) { return k != 0; });
  if (first == frequency.end()) wave.sine = Rational(0);
  if (first != frequency.end() && *first < 0) {
    for (int& k : frequency) k = -k;
    wave.sine = -wave.sine;
  }
  Wave& sum = waves_[frequency];
  sum.cosine += wave.cosine;
  sum.sine += wave.sine;
  if (sum.cosine == Rational(0) && sum.sine == Rational(0)) waves_.erase(frequency);
}

TrigonometricPolynomial TrigonometricPolynomial::derivative(std::size_t variable) const {
  TrigonometricPolynomial result(variables_);
  for (const auto& [k, wave] : waves_)
    result.add(k, {Rational(k[variable]) * wave.sine, -Rational(k[variable]) * wave.cosine});
  return result;
}

TrigonometricPolynomial operator+(TrigonometricPolynomial a, const TrigonometricPolynomial& b) {
  for (const auto& [k, wave] : b.waves_) a.add(k, wave);
  return a;
}

// cos x cos y = (cos(x − y) + cos(x + y))/2, and so on.
TrigonometricPolynomial operator*(const TrigonometricPolynomial& a, const TrigonometricPolynomial& b) {
  TrigonometricPolynomial result(a.variables_);
  const Rational half(Integer(1), Integer(2));
  for (const auto& [k, p] : a.waves_) {
    for (const auto& [l, q] : b.waves_) {
      std::vector<int> sum = k;
      std::vector<int> difference = k;
      for (std::size_t at = 0; at < l.size(); ++at) {
        sum[at] += l[at];
        difference[at] -= l[at];
      }
      result.add(sum, {half * (p.cosine * q.cosine - p.sine * q.sine), half * (p.cosine * q.sine + p.sine * q.cosine)});
      result.add(difference,
                 {half * (p.cosine * q.cosine + p.sine * q.sine), half * (p.sine * q.cosine - p.cosine * q.sine)});
    }
  }
  return result;
}

TrigonometricPolynomial trigonometric_polynomial_of(const Expression& formula,
                                                    const std::vector<std::string>& variables) {
  const auto child = [&](std::size_t at) { return trigonometric_polynomial_of(*formula.children[at], variables); };
  const auto constant = [&](const Rational& value) { return TrigonometricPolynomial(variables.size(), value); };
  const auto moderate = [&](TrigonometricPolynomial result) {
    if (result.waves().size() > most_waves_of_formula)
      refuse(formula, "a trigonometric polynomial of more than 1000 waves");
    return result;
  };
  if (const auto number = number_of(formula)) return constant(*number);
  switch (formula.operation) {
    case Operation::negate:
      return constant(Rational(-1)) * child(0);
    case Operation::add:
      return moderate(child(0) + child(1));
    case Operation::subtract:
      return moderate(child(0) + constant(Rational(-1)) * child(1));
    case Operation::multiply:
      return moderate(child(0) * child(1));
    case Operation::divide:
      if (const auto by = number_of(*formula.children[1])) {
        if (*by == Rational(0)) refuse(formula, "a division by 0");
        return constant(Rational(1) / *by) * child(0);
      }
      refuse(formula, "a division by what is no number");
    case Operation::power: {
      const auto exponent = formula.children[1]->value.numerator().convert_to<int>();
      const TrigonometricPolynomial base = child(0);
      TrigonometricPolynomial result = constant(Rational(1));
      for (int factor = 0; factor < exponent; ++factor) result = moderate(result * base);
      return result;
    }
    case Operation::call:
      if (formula.text == "cos") return TrigonometricPolynomial::cosine(frequency_of(*formula.children[0], variables));
      if (formula.text == "sin") return TrigonometricPolynomial::sine(frequency_of(*formula.children[0], variables));
      refuse(formula, formula.text + " where a trigonometric polynomial was expected");
    case Operation::name:
      refuse(formula, "the variable " + formula.text + " outside of a sine or a cosine");
    default:
      refuse(formula, "something other than a trigonometric polynomial");
  }
}

}  // namespace delcert
