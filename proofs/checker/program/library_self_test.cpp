#include "proofs/checker/program/library_self_test.hpp"

#include <flint/fmpz_mat.h>

#include <cfenv>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/arithmetic/number_field.hpp"
#include "proofs/checker/arithmetic/smith_form.hpp"

namespace delcert::checker {
namespace {

/// P diag(1, 2, 6, 0) Q for integer matrices P, Q of determinant 1, by columns.
std::vector<Column> disguised() {
  constexpr std::int64_t d[] = {1, 2, 6, 0};
  std::int64_t P[4][4], Q[4][4];
  // Products of a lower and an upper triangular matrix with ones on the diagonal.
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      P[i][k] = Q[i][k] = 0;
      for (int j = 0; j <= std::min(i, k); ++j) {
        P[i][k] += (i == j ? 1 : 3 * i - 5 * j) * (j == k ? 1 : 2 * k + 7 * j);
        Q[i][k] += (i == j ? 1 : i + 4 * j) * (j == k ? 1 : 3 * j - k);
      }
    }
  }
  std::vector<Column> columns(4);
  for (int k = 0; k < 4; ++k) {
    for (int i = 4; i-- > 0;) {
      std::int64_t sum = 0;
      for (int j = 0; j < 4; ++j) sum += P[i][j] * d[j] * Q[j][k];
      if (sum != 0) columns[static_cast<std::size_t>(k)].push_back({static_cast<std::uint32_t>(i), sum});
    }
  }
  return columns;
}

bool finds_smith_forms() {
  std::vector<bool> rows(4), columns(4);
  const SmithForm form = reduce(disguised(), 4, rows, columns);
  if (form.rank != 3 || form.torsion != std::vector<std::string>{"2", "6"}) return false;
  // By FLINT alone, with entries beyond a word: 2^70 is the greatest divisor.
  fmpz_mat_t a, s;
  fmpz_mat_init(a, 2, 2);
  fmpz_mat_init(s, 2, 2);
  fmpz_one(fmpz_mat_entry(a, 0, 0));
  fmpz_mul_2exp(fmpz_mat_entry(a, 0, 0), fmpz_mat_entry(a, 0, 0), 70);
  fmpz_mul_ui(fmpz_mat_entry(a, 0, 1), fmpz_mat_entry(a, 0, 0), 3);
  fmpz_mul_ui(fmpz_mat_entry(a, 1, 0), fmpz_mat_entry(a, 0, 0), 5);
  fmpz_mul_ui(fmpz_mat_entry(a, 1, 1), fmpz_mat_entry(a, 0, 0), 29);  // determinant 14 2^140
  fmpz_mat_snf(s, a);
  const bool right = fmpz_equal(fmpz_mat_entry(s, 0, 0), fmpz_mat_entry(a, 0, 0)) != 0 &&
                     fmpz_fdiv_ui(fmpz_mat_entry(s, 1, 1), 14) == 0 && fmpz_bits(fmpz_mat_entry(s, 1, 1)) == 74;
  fmpz_mat_clear(a);
  fmpz_mat_clear(s);
  return right;
}

std::vector<Rational> rationals(const std::vector<int>& x) {
  std::vector<Rational> result;
  for (const int k : x) result.emplace_back(k);
  return result;
}

bool computes_in_fields() {
  // t = 2 cos(2 pi / 7): t^3 + t^2 - 2 t - 1.
  const NumberField field(rationals({-1, -2, 1, 1}), Rational(1), Rational(2));
  const FieldElement t(field, rationals({0, 1})), one(1), u = FieldElement(field, rationals({3, -5, 7}));
  if (!(t * t * t + t * t == t + t + one) || !(u * (one / u) == one) || (t * t - one).sign() != 1) return false;
  if ((t - FieldElement(field, {exact_value("12469796038/10000000000")})).sign() != -1) return false;
  if ((t - FieldElement(field, {exact_value("12469796037/10000000000")})).sign() != 1) return false;
  // x^4 + 4 = (x^2 + 2x + 2)(x^2 - 2x + 2) has no root, x^4 - 10x^2 + 1 is irreducible though it is not modulo any
  // prime.
  const NumberField roots(rationals({1, 0, -10, 0, 1}), Rational(3), Rational(4));
  try {
    const NumberField reducible(rationals({-6, 2, 3, -3, 0, 1}), Rational(1), Rational(2));
    return false;  // (x^2 - 2)(x^3 - x + 3)
  } catch (const Malformed&) {
    return roots.degree() == 4;
  }
}

/// Whether f(x) is enclosed: the digits of the right value, cut and with one more at the end, are around it.
bool encloses(void (*f)(arb_t, const arb_t, slong), const char* x, const char* below, const char* above) {
  for (const slong precision : {64, 128, 256}) {
    const slong before = Ball::precision;
    Ball::precision = precision;
    const Ball value = Ball::apply(f, Ball(exact_value(x)));
    const bool right = arb_lt(Ball(exact_value(below)).raw(), value.raw()) != 0 &&
                       arb_lt(value.raw(), Ball(exact_value(above)).raw()) != 0;
    Ball::precision = before;
    if (!right) return false;
  }
  return true;
}

bool encloses_functions() {
  Ball pi;
  arb_const_pi(pi.raw(), 128);
  return arb_lt(Ball(exact_value("31415926535897932/10000000000000000")).raw(), pi.raw()) != 0 &&
         arb_lt(pi.raw(), Ball(exact_value("31415926535897933/10000000000000000")).raw()) != 0 &&
         encloses(arb_sin, "1", "8414709848078965/10000000000000000", "8414709848078966/10000000000000000") &&
         encloses(arb_cos, "1", "5403023058681397/10000000000000000", "5403023058681398/10000000000000000") &&
         encloses(arb_sinh, "1", "11752011936438014/10000000000000000", "11752011936438015/10000000000000000") &&
         encloses(arb_cosh, "1", "15430806348152437/10000000000000000", "15430806348152438/10000000000000000") &&
         encloses(arb_tanh, "1", "7615941559557648/10000000000000000", "7615941559557649/10000000000000000") &&
         encloses(arb_acosh, "2", "13169578969248167/10000000000000000", "13169578969248168/10000000000000000") &&
         encloses(arb_acos, "1/2", "10471975511965977/10000000000000000", "10471975511965978/10000000000000000") &&
         encloses(arb_sqrt, "2", "14142135623730950/10000000000000000", "14142135623730951/10000000000000000");
}

std::string fault_in_this_mode() {
  if (!finds_smith_forms()) return "FLINT's Smith normal form is wrong";
  if (!computes_in_fields()) return "FLINT's arithmetic of number fields is wrong";
  if (!encloses_functions()) return "Arb does not enclose";
  return "";
}

}  // namespace

std::string library_self_test() {
  const int before = std::fegetround();
  std::string fault;
  for (const int mode : {FE_TONEAREST, FE_UPWARD}) {
    std::fesetround(mode);
    if (fault.empty()) fault = fault_in_this_mode();
    if (!fault.empty() && mode == FE_UPWARD) fault += " under upward rounding";
  }
  std::fesetround(before);
  return fault;
}

}  // namespace delcert::checker
