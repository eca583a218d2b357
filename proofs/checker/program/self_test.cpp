#include "proofs/checker/program/self_test.hpp"

#include <gmp.h>

#include <cfenv>
#include <cfloat>
#include <cmath>
#include <string_view>

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker {
namespace {

static_assert(FLT_EVAL_METHOD == 0 && FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024);

// Hidden from constant folding, as data is.
volatile double one = 1, two = 2, three = 3, tiny = 0x1p-60, smallest = 0x1p-1074, largest = 0x1.fffffffffffffp1023;

[[gnu::noinline]] double product_plus(double a, double b, double c) { return a * b + c; }

bool rounds_upwards() {
  return one + tiny == 1 + 0x1p-52 && -one - tiny == -1 && one / three * three > 1 && -one / three * three > -1 &&
         smallest / two == smallest && -smallest / two == 0 && largest * two > largest && -largest * two == -largest &&
         std::ldexp(one, -1080) == smallest && std::ldexp(-one, -1080) == 0;
}

bool fuses() {
  // (1 + h)^2 - (1 + 2h) is 2^-52 when the product is rounded upwards first, and 2^-60 when it is not.
  const double h = two * tiny * 0x1p29;
  return product_plus(one + h, one + h, -(one + 2 * h)) != 0x1p-52;
}

bool encloses() {
  const Interval third = Interval(static_cast<int>(one)) / Interval(static_cast<int>(three));
  const Interval both = Interval::between(-two, three), ninth = third * -third,
                 rational = enclosure(exact_value("-1/3"));
  return third.lower() == 0x1.5555555555555p-2 && third.upper() == 0x1.5555555555556p-2 &&
         (both * both).lower() == -6 && (both * both).upper() == 9 && square(both).lower() == 0 &&
         square(both).upper() == 9 && (third - third).lower() == -0x1p-54 && ninth.lower() < ninth.upper() &&
         -ninth.lower() == square(third).upper() && -ninth.upper() == square(third).lower() &&
         rational.lower() <= -third.upper() && -third.lower() <= rational.upper() &&
         upper_root(Interval(static_cast<int>(two))) == 0x1.6a09e667f3bcdp0;
}

bool rationals_are_exact() {
  Rational sum;
  for (int k = 1; k <= 60; ++k) sum = sum + Rational(1) / (Rational(k) * Rational(k + 1));
  return sum == exact_value("60/61") && power(Rational(2), 100) == exact_value("1267650600228229401496703205376") &&
         power(Rational(2), 71) * exact_value("-0x1.8p-70") == Rational(-3);
}

}  // namespace

std::string self_test() {
  const std::string gmp_built = std::to_string(__GNU_MP_VERSION) + "." + std::to_string(__GNU_MP_VERSION_MINOR) + "." +
                                std::to_string(__GNU_MP_VERSION_PATCHLEVEL);
  if (gmp_built != gmp_version) return std::string("built with GMP ") + gmp_built + ", running with " + gmp_version;
  if (std::string_view(FLINT_VERSION) != flint_version)
    return std::string("built with FLINT ") + FLINT_VERSION + ", running with " + flint_version;
  if (std::fesetround(FE_UPWARD) != 0 || !rounds_upwards()) return "doubles are not rounded upwards";
  if (fuses()) return "products are fused into sums";
  if (!encloses()) return "intervals do not enclose";
  if (!rationals_are_exact()) return "rational arithmetic is wrong";
  return "";
}

}  // namespace delcert::checker
