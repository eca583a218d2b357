#include "proofs/replay/enclosure.hpp"

#include <algorithm>
#include <functional>

namespace delcert::replay {

namespace {

using Value = std::optional<Enclosure>;

arf_rnd_t outwards(bool is_lower) { return is_lower ? ARF_RND_FLOOR : ARF_RND_CEIL; }

End infinite(int sign) {
  End result;
  if (sign > 0) arf_pos_inf(result.raw());
  if (sign < 0) arf_neg_inf(result.raw());
  result.is_open = true;
  return result;
}

End integer_end(long value, bool is_open) {
  End result;
  arf_set_si(result.raw(), value);
  result.is_open = is_open;
  return result;
}

Enclosure point(long value) { return {integer_end(value, false), integer_end(value, false)}; }

/// What an operation of arf with directed rounding makes; it returns whether it had to round.
End directed(bool is_lower, bool is_open, const std::function<int(arf_ptr, arf_rnd_t)>& operation) {
  End result;
  const int rounded = operation(result.raw(), outwards(is_lower));
  result.is_open = is_open || rounded != 0 || result.is_infinite();
  return result;
}

/// The end of a ball: exact if the ball is.
End of_ball(const arb_t ball, bool is_lower, bool is_open, slong precision) {
  End result;
  if (is_lower) {
    arb_get_lbound_arf(result.raw(), ball, precision);
  } else {
    arb_get_ubound_arf(result.raw(), ball, precision);
  }
  if (arf_is_nan(result.raw())) return infinite(is_lower ? -1 : 1);
  const bool is_same = arb_is_exact(ball) && arf_equal(result.raw(), arb_midref(ball));
  result.is_open = is_open || !is_same || result.is_infinite();
  return result;
}

End outermost(std::vector<End> ends, bool is_lower) {
  End best = ends[0];
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const int order = arf_cmp(ends[i].raw(), best.raw());
    if (order == 0) {
      best.is_open = best.is_open && ends[i].is_open;
    } else if ((order < 0) == is_lower) {
      best = ends[i];
    }
  }
  return best;
}

End innermost(const End& a, const End& b, bool is_lower) {
  const int order = arf_cmp(a.raw(), b.raw());
  End result = (order < 0) == is_lower ? b : a;
  if (order == 0) result.is_open = a.is_open || b.is_open;
  return result;
}

End negated(const End& a) {
  End result = a;
  arf_neg(result.raw(), a.raw());
  return result;
}

Enclosure opposite(const Enclosure& a) { return {negated(a.upper), negated(a.lower)}; }

Enclosure sum(const Enclosure& a, const Enclosure& b, slong precision) {
  const auto add = [&](const End& x, const End& y, bool is_lower) {
    return directed(is_lower, x.is_open || y.is_open,
                    [&](arf_ptr to, arf_rnd_t mode) { return arf_add(to, x.raw(), y.raw(), precision, mode); });
  };
  return {add(a.lower, b.lower, true), add(a.upper, b.upper, false)};
}

/// One corner of a product; numbers are finite, so 0 times an infinite end is 0.
End product_corner(const End& a, const End& b, bool is_lower, slong precision) {
  if (a.sign() == 0 || b.sign() == 0) {
    const bool attained = (a.sign() == 0 && !a.is_open) || (b.sign() == 0 && !b.is_open);
    return integer_end(0, !attained);
  }
  return directed(is_lower, a.is_open || b.is_open,
                  [&](arf_ptr to, arf_rnd_t mode) { return arf_mul(to, a.raw(), b.raw(), precision, mode); });
}

template <class Corner>
Enclosure of_corners(const Enclosure& a, const Enclosure& b, const Corner& corner) {
  const auto extreme = [&](bool is_lower) {
    return outermost({corner(a.lower, b.lower, is_lower), corner(a.lower, b.upper, is_lower),
                      corner(a.upper, b.lower, is_lower), corner(a.upper, b.upper, is_lower)},
                     is_lower);
  };
  return {extreme(true), extreme(false)};
}

Enclosure product(const Enclosure& a, const Enclosure& b, slong precision) {
  return of_corners(
      a, b, [&](const End& x, const End& y, bool is_lower) { return product_corner(x, y, is_lower, precision); });
}

Value quotient(const Enclosure& a, const Enclosure& b, slong precision) {
  if (!b.is_positive() && !b.is_negative()) return std::nullopt;
  const auto inverse = [&](const End& x, bool is_lower) {
    if (x.sign() == 0) return infinite(is_lower ? -1 : 1);
    return directed(is_lower, x.is_open,
                    [&](arf_ptr to, arf_rnd_t mode) { return arf_ui_div(to, 1, x.raw(), precision, mode); });
  };
  return product(a, {inverse(b.upper, true), inverse(b.lower, false)}, precision);
}

Enclosure absolute(const Enclosure& a) {
  if (a.lower.sign() >= 0) return a;
  if (a.upper.sign() <= 0) return opposite(a);
  return {integer_end(0, false), outermost({negated(a.lower), a.upper}, false)};
}

Enclosure hull(const Enclosure& a, const Enclosure& b) {
  return {outermost({a.lower, b.lower}, true), outermost({a.upper, b.upper}, false)};
}

/// x^n for an end x and n > 0.
End power_end(const End& x, unsigned long n, bool is_lower, slong precision) {
  if (x.is_infinite()) return infinite(x.sign() > 0 || n % 2 == 0 ? 1 : -1);
  arb_t ball;
  arb_init(ball);
  arb_set_arf(ball, x.raw());
  arb_pow_ui(ball, ball, n, precision);
  End result = of_ball(ball, is_lower, x.is_open, precision);
  arb_clear(ball);
  return result;
}

Value integer_power(const Enclosure& a, long exponent, slong precision) {
  if (exponent == 0) return point(1);
  const auto n = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
  const Enclosure base = n % 2 == 0 ? absolute(a) : a;
  const Enclosure result{power_end(base.lower, n, true, precision), power_end(base.upper, n, false, precision)};
  return exponent < 0 ? quotient(point(1), result, precision) : Value(result);
}

/// x^y for an end x of positive numbers. 1^y and x^0 are 1, also where the other end is infinite.
End real_power_corner(const End& x, const End& y, bool is_lower, slong precision) {
  const int order = arf_cmp_si(x.raw(), 1);
  if (order == 0 || y.sign() == 0) {
    const bool attained = (order == 0 && !x.is_open) || (y.sign() == 0 && !y.is_open);
    return integer_end(1, !attained);
  }
  if (y.is_infinite() || x.is_infinite() || x.sign() == 0) {
    const bool grows = (order > 0) == (y.sign() > 0);
    return grows ? infinite(1) : integer_end(0, true);
  }
  arb_t base;
  arb_t exponent;
  arb_init(base);
  arb_init(exponent);
  arb_set_arf(base, x.raw());
  arb_set_arf(exponent, y.raw());
  arb_pow(base, base, exponent, precision);
  End result = of_ball(base, is_lower, x.is_open || y.is_open, precision);
  // A power of a positive number is positive, however wide the ball.
  if (is_lower && result.sign() < 0) result = integer_end(0, true);
  arb_clear(base);
  arb_clear(exponent);
  return result;
}

Value real_power(const Enclosure& a, const Enclosure& b, slong precision) {
  if (!a.is_positive()) return std::nullopt;
  return of_corners(
      a, b, [&](const End& x, const End& y, bool is_lower) { return real_power_corner(x, y, is_lower, precision); });
}

Value root(const Enclosure& a, slong precision) {
  if (a.lower.sign() < 0) return std::nullopt;
  const auto of_end = [&](const End& x, bool is_lower) {
    return directed(is_lower, x.is_open,
                    [&](arf_ptr to, arf_rnd_t mode) { return arf_sqrt(to, x.raw(), precision, mode); });
  };
  return Enclosure{of_end(a.lower, true), of_end(a.upper, false)};
}

End logarithm_end(const End& x, bool is_lower, slong precision) {
  if (x.sign() == 0) return infinite(-1);
  if (x.is_infinite()) return infinite(1);
  fmpz_t mantissa;
  fmpz_t exponent;
  fmpz_init(mantissa);
  fmpz_init(exponent);
  arf_get_fmpz_2exp(mantissa, exponent, x.raw());
  End result;
  if (fmpz_is_one(mantissa)) {
    arf_set_fmpz(result.raw(), exponent);
    result.is_open = x.is_open;
  } else {
    arb_t ball;
    arb_t two;
    arb_init(ball);
    arb_init(two);
    arb_set_arf(ball, x.raw());
    arb_log(ball, ball, precision + 8);
    arb_const_log2(two, precision + 8);
    arb_div(ball, ball, two, precision + 8);
    result = of_ball(ball, is_lower, x.is_open, precision);
    arb_clear(ball);
    arb_clear(two);
  }
  fmpz_clear(mantissa);
  fmpz_clear(exponent);
  return result;
}

Value logarithm(const Enclosure& a, slong precision) {
  if (!a.is_positive()) return std::nullopt;
  return Enclosure{logarithm_end(a.lower, true, precision), logarithm_end(a.upper, false, precision)};
}

Enclosure natural_logarithm_of_two(slong precision) {
  arb_t ball;
  arb_init(ball);
  arb_const_log2(ball, precision);
  Enclosure result{of_ball(ball, true, true, precision), of_ball(ball, false, true, precision)};
  arb_clear(ball);
  return result;
}

Enclosure of_number(const Number& x, slong precision) {
  const auto end = [&](bool is_lower) {
    return directed(is_lower, false, [&](arf_ptr to, arf_rnd_t mode) {
      return arf_fmpz_div_fmpz(to, fmpq_numref(x.raw()), fmpq_denref(x.raw()), precision, mode);
    });
  };
  return {end(true), end(false)};
}

/// The value of a term without names, if it is rational and small enough.
std::optional<Number> exact(const Node& term) {
  if (term.is_number()) return term.value;
  if (term.is_name()) return std::nullopt;
  std::vector<Number> parts;
  for (const NodePointer& part : term.parts) {
    auto value = exact(*part);
    if (!value) return std::nullopt;
    parts.push_back(std::move(*value));
  }
  if (term.head == "-") return parts.size() == 1 ? Number(0) - parts[0] : parts[0] - parts[1];
  if (term.head == "+") return parts[0] + parts[1];
  if (term.head == "*") return parts[0] * parts[1];
  if (term.head == "/" && parts[1].sign() != 0) return parts[0] / parts[1];
  if (term.head == "^" && parts[1].is_integer() && fmpz_cmp_si(fmpq_numref(parts[1].raw()), 64) <= 0 &&
      parts[1].sign() >= 0) {
    Number result;
    fmpq_pow_si(result.raw(), parts[0].raw(), fmpz_get_si(fmpq_numref(parts[1].raw())));
    return result;
  }
  return std::nullopt;
}

/// Twice the exponent of a power if it is a constant that is a small number of halves.
std::optional<long> halves_of(const Node& exponent) {
  const auto value = exact(exponent);
  if (!value) return std::nullopt;
  const Number twice = *value + *value;
  if (!twice.is_integer() || fmpz_bits(fmpq_numref(twice.raw())) > 20) return std::nullopt;
  return fmpz_get_si(fmpq_numref(twice.raw()));
}

}  // namespace

std::optional<int> Enclosure::sign() const {
  if (lower.sign() >= 0 && upper.sign() <= 0) return 0;
  if (is_positive()) return 2;
  if (is_negative()) return -2;
  if (lower.sign() >= 0) return 1;
  if (upper.sign() <= 0) return -1;
  return std::nullopt;
}

Encloser::Encloser(const std::vector<std::string>& names, const std::vector<Side>& box, slong precision)
    : names_(names), precision_(precision) {
  for (const Side& side : box) {
    Enclosure range{infinite(-1), infinite(1)};
    if (side.lower) range.lower = of_number(*side.lower, precision).lower;
    if (side.upper) range.upper = of_number(*side.upper, precision).upper;
    range.lower.is_open = range.lower.is_open || side.lower_open;
    range.upper.is_open = range.upper.is_open || side.upper_open;
    parameters_.push_back(std::move(range));
  }
}

std::optional<Enclosure> Encloser::apply(const std::string& head, const std::vector<Enclosure>& parts,
                                         const Node& term) const {
  const Enclosure& a = parts[0];
  if (head == "-" && parts.size() == 1) return opposite(a);
  if (head == "sqrt") return root(a, precision_);
  if (head == "log2") return logarithm(a, precision_);
  if (head == "abs") return absolute(a);
  if (head == "^") {
    if (const auto halves = halves_of(*term.parts[1])) {
      if (*halves % 2 == 0) return integer_power(a, *halves / 2, precision_);
      const auto radical = root(a, precision_);
      return radical ? integer_power(*radical, *halves, precision_) : std::nullopt;
    }
    return real_power(a, parts[1], precision_);
  }
  if (head == "min" || head == "max") {
    Enclosure best = a;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const bool least = head == "min";
      best =
          least
              ? Enclosure{outermost({best.lower, parts[i].lower}, true), innermost(best.upper, parts[i].upper, false)}
              : Enclosure{innermost(best.lower, parts[i].lower, true), outermost({best.upper, parts[i].upper}, false)};
    }
    return best;
  }
  const Enclosure& b = parts.at(1);
  if (head == "+") return sum(a, b, precision_);
  if (head == "-") return sum(a, opposite(b), precision_);
  if (head == "*") return product(a, b, precision_);
  if (head == "/") return quotient(a, b, precision_);
  throw Malformed("no term has the operator " + head);
}

std::optional<Enclosure> Encloser::value(const Node& term) {
  if (term.is_number()) return of_number(term.value, precision_);
  if (term.is_name()) {
    const auto found = std::find(names_.begin(), names_.end(), term.head);
    if (found == names_.end()) throw Malformed("no parameter is called " + term.head);
    return parameters_[static_cast<std::size_t>(found - names_.begin())];
  }
  const auto known = known_.find(&term);
  if (known != known_.end()) return known->second;
  std::vector<Enclosure> parts;
  Value result;
  for (const NodePointer& part : term.parts) {
    auto next = value(*part);
    if (!next) return known_[&term] = std::nullopt;
    parts.push_back(std::move(*next));
  }
  return known_[&term] = apply(term.head, parts, term);
}

Encloser::Jet Encloser::jet(const Node& term, std::size_t parameter) {
  if (term.is_number()) return {value(term), point(0)};
  if (term.is_name()) return {value(term), point(term.head == names_[parameter] ? 1 : 0)};
  const Value whole = value(term);
  if (!whole) return {};
  std::vector<Jet> parts;
  for (const NodePointer& part : term.parts) parts.push_back(jet(*part, parameter));
  if (!parts[0].value || !parts[0].slope) return {whole, std::nullopt};
  const Enclosure& a = *parts[0].value;
  const Enclosure& da = *parts[0].slope;
  const auto is_zero = [](const Enclosure& x) { return x.sign() == std::optional<int>(0); };
  if (term.parts.size() == 1) {
    if (term.head == "-") return {whole, opposite(da)};
    if (is_zero(da)) return {whole, da};
    if (term.head == "sqrt") return {whole, quotient(da, product(point(2), *whole, precision_), precision_)};
    if (term.head == "log2")
      return {whole, quotient(da, product(a, natural_logarithm_of_two(precision_), precision_), precision_)};
    if (a.lower.sign() >= 0) return {whole, da};
    return {whole, a.upper.sign() <= 0 ? opposite(da) : hull(da, opposite(da))};
  }
  if (term.head == "min" || term.head == "max") {
    Enclosure all = da;
    for (const Jet& part : parts) {
      if (!part.slope) return {whole, std::nullopt};
      all = hull(all, *part.slope);
    }
    return {whole, all};
  }
  if (term.head == "^") {
    if (const auto halves = halves_of(*term.parts[1])) {
      if (*halves == 0 || is_zero(da)) return {whole, point(0)};
      // n/2·a^(n/2 − 1)·a'
      Value lower_power;
      if (*halves % 2 == 0) {
        lower_power = integer_power(a, *halves / 2 - 1, precision_);
      } else if (const auto radical = root(a, precision_)) {
        lower_power = integer_power(*radical, *halves - 2, precision_);
      }
      if (!lower_power) return {whole, std::nullopt};
      const auto factor = quotient(point(*halves), point(2), precision_);
      return {whole, product(product(*factor, *lower_power, precision_), da, precision_)};
    }
  }
  if (!parts[1].value || !parts[1].slope) return {whole, std::nullopt};
  const Enclosure& b = *parts[1].value;
  const Enclosure& db = *parts[1].slope;
  if (term.head == "+") return {whole, sum(da, db, precision_)};
  if (term.head == "-") return {whole, sum(da, opposite(db), precision_)};
  if (term.head == "*") return {whole, sum(product(da, b, precision_), product(a, db, precision_), precision_)};
  if (term.head == "/")
    return {whole, quotient(sum(da, opposite(product(*whole, db, precision_)), precision_), b, precision_)};
  // a^b (b' ln a + b a'/a)
  const auto of_a = logarithm(a, precision_);
  const auto relative = quotient(da, a, precision_);
  if (!of_a || !relative) return {whole, std::nullopt};
  const Enclosure natural = product(*of_a, natural_logarithm_of_two(precision_), precision_);
  return {whole, product(*whole, sum(product(db, natural, precision_), product(b, *relative, precision_), precision_),
                         precision_)};
}

std::optional<Enclosure> Encloser::on_face(const Node& difference, const std::vector<int>& slopes, bool least) {
  Encloser face = *this;
  face.known_.clear();
  bool strict = false;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (slopes[i] == 0) continue;
    const bool at_lower = (slopes[i] > 0) == least;
    End end = at_lower ? parameters_[i].lower : parameters_[i].upper;
    if (end.is_infinite()) continue;
    strict = strict || (end.is_open && (slopes[i] == 2 || slopes[i] == -2));
    end.is_open = false;
    face.parameters_[i] = {end, end};
  }
  Value result = face.value(difference);
  if (result && strict) (least ? result->lower : result->upper).is_open = true;
  return result;
}

std::optional<int> Encloser::direct_sign(const Node& difference) {
  const Value whole = value(difference);
  if (!whole) return std::nullopt;
  if (const auto sign = whole->sign()) return sign;
  std::vector<int> slopes(parameters_.size(), 0);
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Value slope = jet(difference, i).slope;
    if (!slope) continue;
    const auto sign = slope->sign();
    // A slope of 0 may be taken for either.
    if (sign) slopes[i] = *sign == 0 ? 1 : *sign;
  }
  Enclosure best = *whole;
  if (const auto least = on_face(difference, slopes, true)) best.lower = least->lower;
  if (const auto greatest = on_face(difference, slopes, false)) best.upper = greatest->upper;
  return best.sign();
}

std::optional<int> Encloser::sign_of_difference(const NodePointer& a, const NodePointer& b) {
  const auto applied = [](const std::string& head, const NodePointer& x, const NodePointer& y) {
    auto result = std::make_shared<Node>();
    result->head = head;
    result->parts = {x, y};
    return result;
  };
  NodePointer left = a;
  NodePointer right = b;
  // A quotient by what is positive is multiplied out if need be.
  while (true) {
    kept_.push_back(applied("-", left, right));
    if (const auto sign = direct_sign(*kept_.back())) return sign;
    const auto divides_by_positive = [&](const NodePointer& term) {
      if (term->head != "/") return false;
      const Value divisor = value(*term->parts[1]);
      return divisor && divisor->is_positive();
    };
    if (divides_by_positive(left)) {
      right = applied("*", right, left->parts[1]);
      left = left->parts[0];
    } else if (divides_by_positive(right)) {
      left = applied("*", left, right->parts[1]);
      right = right->parts[0];
    } else {
      return std::nullopt;
    }
  }
}

}  // namespace delcert::replay
