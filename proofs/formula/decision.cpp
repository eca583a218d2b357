#include "proofs/formula/decision.hpp"

#include <mpfr.h>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {

namespace {

constexpr unsigned first_precision = 128;

/// As a fraction, 2^(10^12) would not fit into memory.
bool has_moderate_exponents(const BigInterval& x) {
  constexpr mpfr_exp_t greatest = mpfr_exp_t{1} << 24;
  const auto is_moderate = [](mpfr_srcptr end) {
    return mpfr_zero_p(end) != 0 || (mpfr_get_exp(end) <= greatest && mpfr_get_exp(end) >= -greatest);
  };
  return is_moderate(&x.mpfi()->left) && is_moderate(&x.mpfi()->right);
}

}  // namespace

Verdict decide_statement(const Expression& statement, Scene& scene) {
  const auto truth = [&]<class S>() { return Evaluation<S>(scene).truth(statement); };
  const auto in_intervals = [&] { return truth.template operator()<BigInterval>(); };
  Ladder ladder;
  {
    const RoundingGuard guard;
    ladder.ask(Rung::interval, [&] { return truth.template operator()<Interval>(); });
  }
  ladder.ask_in_bits(first_precision, first_precision, in_intervals);
  // Most of what 128 bits cannot tell is a tie.
  ladder.ask(Rung::rational, [&] { return truth.template operator()<Surd>(); });
  ladder.ask_in_bits(2 * first_precision, greatest_precision, in_intervals);
  ladder.ask(Rung::algebraic, [&] {
    try {
      return truth.template operator()<Algebraic>();
    } catch (const Algebraic::TooLarge&) {
      return Verdict::undecided;  // like a predicate that gives up
    }
  });
  return ladder.finish();
}

std::optional<DoubleBounds> ratio_bounds(const Expression& statement, Scene& scene, bool sharp) {
  if (!sharp) {
    const RoundingGuard guard;
    const auto ratio = Evaluation<Interval>(scene).ratio(statement);
    if (!ratio) return std::nullopt;
    return DoubleBounds{ratio->lower(), ratio->upper()};
  }
  const BigInterval::Precision precision(PrecisionBits{256});
  const auto ratio = Evaluation<BigInterval>(scene).ratio(statement);
  if (!ratio) return std::nullopt;
  return DoubleBounds{mpfr_get_d(&ratio->mpfi()->left, MPFR_RNDD), mpfr_get_d(&ratio->mpfi()->right, MPFR_RNDU)};
}

std::optional<Rational> exact_value(const Expression& term, Scene& scene) {
  try {
    const Partial<Algebraic> value = Evaluation<Algebraic>(scene).number(term);
    if (!value || value->degree() != 1) return std::nullopt;
    return value->rational();
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

std::optional<Rational> lower_bound(const Expression& term, Scene& scene, unsigned bits) {
  const Rational relative = Rational::power_of_two(-static_cast<long>(bits));
  for (unsigned precision_bits = first_precision; precision_bits <= greatest_precision; precision_bits *= 2) {
    const BigInterval::Precision precision(PrecisionBits{precision_bits});
    const Partial<BigInterval> value = Evaluation<BigInterval>(scene).number(term);
    if (!value) {
      if (is_refuted(value.exists())) return std::nullopt;
      continue;
    }
    if (!value->is_bounded() || !has_moderate_exponents(*value)) continue;
    const Rational lower = value->lower();
    const Rational upper = value->upper();
    if (upper - lower <= relative * maximum(absolute(lower), absolute(upper))) return lower;
  }
  return std::nullopt;
}

}  // namespace delcert
