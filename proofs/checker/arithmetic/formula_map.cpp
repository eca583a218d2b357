#include "proofs/checker/arithmetic/formula_map.hpp"

#include <algorithm>

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker {

using Operation = FormulaMap::Operation;

/// sum := product { ('+' | '-') product };  product := signed { ('*' | '/') signed };  signed := '-' signed | power;
/// power := atom [ '^' digits ];  atom := digits | variable | function '(' sum ')' | '(' sum ')'.
class FormulaReader {
 public:
  FormulaReader(FormulaMap& map, const std::vector<std::string_view>& variables, std::string_view text, bool folds)
      : map_(map), variables_(variables), text_(text), folds_(folds) {}

  std::size_t read() {
    const std::size_t result = sum();
    if (at_ != text_.size()) fail();
    return result;
  }

 private:
  static constexpr int deepest = 200;
  static constexpr std::size_t most_digits = 1000, greatest_exponent = 1000;

  [[noreturn]] void fail() const {
    throw Malformed("form.formula", "an equation is no formula from its character " + std::to_string(at_) + " on");
  }
  bool accept(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  /// The longest run of characters of which the predicate is true.
  template <class Predicate>
  std::string_view run(const Predicate& predicate) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && predicate(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_word(char c) { return (c >= 'a' && c <= 'z') || is_digit(c) || c == '_'; }

  std::size_t sum() {
    std::size_t result = product();
    while (true) {
      if (accept('+')) {
        const std::size_t term = product();
        result = map_.append({Operation::sum, result, term});
      } else if (accept('-')) {
        const std::size_t term = product();
        result = map_.append({Operation::difference, result, term});
      } else {
        return result;
      }
    }
  }
  std::size_t product() {
    std::size_t result = with_sign();
    while (true) {
      if (accept('*')) {
        const std::size_t factor = with_sign();
        result = map_.append({Operation::product, result, factor});
      } else if (accept('/')) {
        const std::size_t inverse = map_.append({Operation::reciprocal, with_sign()});
        result = map_.append({Operation::product, result, inverse});
      } else {
        return result;
      }
    }
  }
  std::size_t with_sign() {
    if (++depth_ > deepest) fail();
    const std::size_t result = accept('-') ? map_.append({Operation::negative, with_sign()}) : power();
    --depth_;
    return result;
  }
  std::size_t power() {
    const std::size_t base = atom();
    if (!accept('^')) return base;
    const std::string_view digits = run(is_digit);
    if (digits.empty() || digits.size() > 4) fail();
    const auto exponent = static_cast<std::size_t>(std::stoi(std::string(digits)));
    if (exponent > greatest_exponent || (at_ < text_.size() && text_[at_] == '^')) fail();
    return map_.append({Operation::power, base, exponent});
  }
  std::size_t atom() {
    if (accept('(')) return closed(sum());
    const std::string_view digits = run(is_digit);
    if (digits.size() > most_digits) fail();
    if (!digits.empty()) return map_.append_constant(exact_value(digits));
    const std::string_view word = run(is_word);
    for (const auto& [name, operation] : {std::pair{"sqrt", Operation::root},
                                          {"exp", Operation::exp},
                                          {"sin", Operation::sin},
                                          {"cos", Operation::cos},
                                          {"abs", Operation::absolute}}) {
      if (word != name) continue;
      // A variable may have this name.
      if (operation == Operation::absolute && (!folds_ || at_ == text_.size() || text_[at_] != '(')) continue;
      if (!accept('(')) fail();
      return map_.append({operation, closed(sum())});
    }
    const auto variable = std::find(variables_.begin(), variables_.end(), word);
    if (variable == variables_.end()) fail();
    return map_.append({Operation::variable, static_cast<std::size_t>(variable - variables_.begin())});
  }
  std::size_t closed(std::size_t inner) {
    if (!accept(')')) fail();
    return inner;
  }

  FormulaMap& map_;
  const std::vector<std::string_view>& variables_;
  std::string_view text_;
  bool folds_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

namespace {

bool is_variable(std::string_view name) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= 16 && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }) &&
         name != "sqrt" && name != "exp" && name != "sin" && name != "cos";
}

}  // namespace

void require_names(const std::vector<std::string_view>& variables) {
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (!is_variable(variables[k]) || std::count(variables.begin(), variables.end(), variables[k]) != 1)
      throw Malformed("form.formula", "variable " + std::to_string(k) + " has no name of its own");
  }
}

FormulaMap::FormulaMap(const std::vector<std::string_view>& variables, const std::vector<std::string_view>& formulas,
                       bool folds)
    : variables_(variables.size()) {
  for (const std::string_view formula : formulas)
    results_.push_back(FormulaReader(*this, variables, formula, folds).read());
}

/// The same operation on the same operands is done once.
std::size_t FormulaMap::append(const Step& step) {
  const auto [place, is_new] = known_.try_emplace(step, steps_.size());
  if (!is_new) return place->second;
  if (steps_.size() == most_steps) throw Malformed("form.formula", "the equations have too many operations");
  unsigned depends = 0;
  if (step.operation == Operation::variable) {
    depends = 1U << step.first;
  } else if (step.operation != Operation::constant) {
    depends = depends_[step.first];
    if (step.operation <= Operation::product) depends |= depends_[step.second];
  }
  steps_.push_back(step);
  depends_.push_back(depends);
  return place->second;
}

std::size_t FormulaMap::append_constant(const Rational& value) {
  constants_.emplace_back(value);
  return append({Operation::constant, constants_.size() - 1});
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// x^exponent; what is not defined has no power.
template <class N>
N whole_power(const N& x, std::size_t exponent) {
  if (exponent == 0) return N(1) + N(0) * x;
  if (exponent == 1) return x;
  const N half = whole_power(x, exponent / 2), whole = square(half);
  return exponent % 2 == 0 ? whole : whole * x;
}

Interval reciprocal(const Interval& x) { return Interval(1) / x; }
Ball reciprocal(const Ball& x) { return Ball(1) / x; }

/// The root of what may be 0 or negative is not known.
Interval certain_root(const Interval& x) {
  return x.lower() > 0 ? square_root(x) : Interval::between(-infinity, infinity);
}
Ball certain_root(const Ball& x) {
  if (arb_is_positive(x.raw()) != 0) return square_root(x);
  Ball unknown;
  arb_indeterminate(unknown.raw());
  return unknown;
}

Ball apply(void (*f)(arb_t, const arb_t, slong), const Ball& x) { return Ball::apply(f, x); }
Interval apply(void (*f)(arb_t, const arb_t, slong), const Interval& x) {
  if (!(x.lower() > -0x1p100 && x.upper() < 0x1p100)) return Interval::between(-infinity, infinity);
  return in_balls(64, [&] {
    Ball lower, upper;
    arb_set_d(lower.raw(), x.lower());
    arb_set_d(upper.raw(), x.upper());
    if (f == arb_exp) return joined(Ball::apply(f, lower), Ball::apply(f, upper)).enclosure();  // monotone
    return Ball::apply(f, joined(lower, upper)).enclosure();
  });
}

}  // namespace

template <class N>
FormulaValues<N>::FormulaValues(const FormulaMap& map)
    : map_(map),
      pairs_(map.variable_count() * (map.variable_count() + 1) / 2),
      values_(map.steps().size()),
      firsts_(map.steps().size() * map.variable_count(), N(0)),
      seconds_(map.steps().size() * pairs_, N(0)) {}

/// The derivatives of g(u), u the step `of`, from g' and g''.
template <class N>
void FormulaValues<N>::compose(std::size_t at, std::size_t of, const N& slope, const N& bend, int order) {
  const std::size_t n = map_.variable_count();
  const N *du = &firsts_[of * n], *ddu = &seconds_[of * pairs_];
  for (std::size_t k = 0, kl = 0; k < n; ++k) {
    const bool moves = map_.depends(of, k);
    if (moves) firsts_[at * n + k] = slope * du[k];
    if (order < 2) continue;
    for (std::size_t l = 0; l <= k; ++l, ++kl) {
      if (moves && map_.depends(of, l))
        seconds_[at * pairs_ + kl] = slope * ddu[kl] + (k == l ? bend * square(du[k]) : bend * (du[k] * du[l]));
    }
  }
}

template <class N>
void FormulaValues<N>::evaluate(const Matrix<N>& x, int order) {
  const std::size_t n = map_.variable_count();
  Budget::spend(map_.steps().size() * (order == 0 ? 1 : order == 1 ? 1 + n : 1 + n + 3 * pairs_));
  for (std::size_t at = 0; at < map_.steps().size(); ++at) {
    const auto& [operation, a, b] = map_.steps()[at];
    N* d = &firsts_[at * n];
    const auto unary = [&](N value, const auto& slope, const auto& bend) {
      values_[at] = std::move(value);
      if (order > 0) compose(at, a, slope(values_[at]), order > 1 ? bend(values_[at]) : N(0), order);
    };
    switch (operation) {
      case Operation::constant:
        values_[at] = map_.constant(a).template as<N>();
        break;
      case Operation::variable:
        values_[at] = x[a];
        d[a] = N(1);
        break;
      case Operation::sum:
      case Operation::difference: {
        const bool plus = operation == Operation::sum;
        values_[at] = plus ? values_[a] + values_[b] : values_[a] - values_[b];
        const auto combine = [&](std::vector<N>& y, std::size_t width) {
          for (std::size_t k = 0; k < width; ++k)
            y[at * width + k] = plus ? y[a * width + k] + y[b * width + k] : y[a * width + k] - y[b * width + k];
        };
        if (order > 0) combine(firsts_, n);
        if (order > 1) combine(seconds_, pairs_);
        break;
      }
      case Operation::product: {
        values_[at] = values_[a] * values_[b];
        if (order == 0) break;
        const N *du = &firsts_[a * n], *dv = &firsts_[b * n];
        const N *ddu = &seconds_[a * pairs_], *ddv = &seconds_[b * pairs_];
        for (std::size_t k = 0, kl = 0; k < n; ++k) {
          if (!map_.depends(at, k)) {
            kl += k + 1;
            continue;
          }
          d[k] = du[k] * values_[b] + values_[a] * dv[k];
          for (std::size_t l = 0; order > 1 && l <= k; ++l, ++kl) {
            if (!map_.depends(at, l)) continue;
            seconds_[at * pairs_ + kl] = ddu[kl] * values_[b] + values_[a] * ddv[kl] + (du[k] * dv[l] + du[l] * dv[k]);
          }
        }
        break;
      }
      case Operation::negative:
        unary(
            -values_[a], [](const N&) { return N(-1); }, [](const N&) { return N(0); });
        break;
      case Operation::reciprocal:
        unary(
            reciprocal(values_[a]), [](const N& g) { return -square(g); },
            [](const N& g) { return N(2) * whole_power(g, 3); });
        break;
      case Operation::power: {
        const N& u = values_[a];
        const auto factor = [](std::size_t k) { return N(static_cast<int>(k)); };
        unary(
            whole_power(u, b), [&](const N&) { return b == 0 ? N(0) : factor(b) * whole_power(u, b - 1); },
            [&](const N&) { return b < 2 ? N(0) : factor(b * (b - 1)) * whole_power(u, b - 2); });
        break;
      }
      case Operation::root:
        unary(
            certain_root(values_[a]), [](const N& g) { return reciprocal(N(2) * g); },
            [](const N& g) { return -reciprocal(N(4) * whole_power(g, 3)); });
        break;
      case Operation::exp:
        unary(
            apply(arb_exp, values_[a]), [](const N& g) { return g; }, [](const N& g) { return g; });
        break;
      case Operation::sin:
        unary(
            apply(arb_sin, values_[a]), [&](const N&) { return apply(arb_cos, values_[a]); },
            [](const N& g) { return -g; });
        break;
      case Operation::cos:
        unary(
            apply(arb_cos, values_[a]), [&](const N&) { return -apply(arb_sin, values_[a]); },
            [](const N& g) { return -g; });
        break;
      case Operation::absolute:
        throw std::logic_error("a map with folds has values piece by piece");
    }
  }
}

template <class N>
Matrix<N> FormulaValues<N>::value() const {
  Matrix<N> result(map_.function_count(), 1);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = value(k);
  return result;
}

template <class N>
Matrix<N> FormulaValues<N>::jacobian() const {
  const std::size_t n = map_.variable_count();
  Matrix<N> result(map_.function_count(), n);
  for (std::size_t r = 0; r < result.rows(); ++r) {
    for (std::size_t k = 0; k < n; ++k) result(r, k) = firsts_[map_.result(r) * n + k];
  }
  return result;
}

template class FormulaValues<Interval>;
template class FormulaValues<Ball>;

}  // namespace delcert::checker
