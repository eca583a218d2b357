#include "kernel/number/elementary.hpp"

namespace delcert {

namespace {

/// Room for a result at the working precision.
class Result {
 public:
  Result() { mpfi_init2(value_, static_cast<mpfr_prec_t>(BigInterval::working_precision().value)); }
  ~Result() { mpfi_clear(value_); }
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;

  [[nodiscard]] mpfi_ptr get() { return value_; }
  [[nodiscard]] BigInterval copy() const { return BigInterval::copy_of(value_); }

 private:
  mpfi_t value_;
};

template <class Function>
BigInterval value_of(const Function& function, const BigInterval& x) {
  Result result;
  function(result.get(), x.mpfi());
  return result.copy();
}

BigInterval whole_line() {
  Result result;
  mpfr_set_inf(&result.get()->left, -1);
  mpfr_set_inf(&result.get()->right, 1);
  return result.copy();
}

}  // namespace

BigInterval half_turn() {
  Result result;
  mpfi_const_pi(result.get());
  return result.copy();
}

BigInterval natural_logarithm_of_two() {
  Result result;
  mpfi_const_log2(result.get());
  return result.copy();
}

BigInterval exponential(const BigInterval& x) { return value_of(mpfi_exp, x); }
BigInterval sine(const BigInterval& x) { return value_of(mpfi_sin, x); }
BigInterval cosine(const BigInterval& x) { return value_of(mpfi_cos, x); }
BigInterval hyperbolic_sine(const BigInterval& x) { return value_of(mpfi_sinh, x); }
BigInterval hyperbolic_cosine(const BigInterval& x) { return value_of(mpfi_cosh, x); }
BigInterval arctangent(const BigInterval& x) { return value_of(mpfi_atan, x); }

BigInterval area_tangent(const BigInterval& x) {
  if (!is_proved(less(absolute(x), BigInterval(1)))) return whole_line();
  return value_of(mpfi_atanh, x);
}

BigInterval arccosine(const BigInterval& x) {
  return value_of(mpfi_acos, maximum(minimum(x, BigInterval(1)), BigInterval(-1)));
}

BigInterval area_cosine(const BigInterval& x) { return value_of(mpfi_acosh, maximum(x, BigInterval(1))); }

BigInterval lower_end(const BigInterval& x) {
  return value_of([](mpfi_ptr result, mpfi_srcptr value) { mpfi_set_fr(result, &value->left); }, x);
}

BigInterval upper_end(const BigInterval& x) {
  return value_of([](mpfi_ptr result, mpfi_srcptr value) { mpfi_set_fr(result, &value->right); }, x);
}

BigInterval hull(const BigInterval& a, const BigInterval& b) {
  Result result;
  mpfi_union(result.get(), a.mpfi(), b.mpfi());
  return result.copy();
}

Interval in_doubles(const BigInterval& x) {
  return Interval::between(mpfr_get_d(&x.mpfi()->left, MPFR_RNDD), mpfr_get_d(&x.mpfi()->right, MPFR_RNDU));
}

BigInterval in_big(const Interval& x) {
  Result result;
  mpfr_set_d(&result.get()->left, x.lower(), MPFR_RNDD);
  mpfr_set_d(&result.get()->right, x.upper(), MPFR_RNDU);
  return result.copy();
}

}  // namespace delcert
