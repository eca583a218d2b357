#include "kernel/number/self_test.hpp"

#include <CGAL/version.h>
#if __has_include(<flint/arb.h>)  // FLINT 3
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#include <flint/flint.h>
#include <gmp.h>
#include <mpfi.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
#include <limits>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/calcium.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/number/rounding_guard.hpp"

// Here the compiler's freedom is what is under test. Values come out of `volatile` where the machine is tested and out
// of plain constants where the compiler is; nothing is marked so that the compiler would leave it alone.

namespace delcert {

namespace {

using Failures = std::vector<std::string>;

double hidden(double x) {
  volatile double kept = x;
  return kept;
}

void expect(Failures& failures, bool truth, const char* complaint) {
  if (!truth) failures.emplace_back(complaint);
}

bool is_nearest() {
  const double one = hidden(1);
  const double little = hidden(0x1p-60);
  const double half_unit = hidden(0x1p-53);
  return hidden(one + little) == one && hidden(-one - little) == -one && hidden(one - little) == one &&
         hidden(one + half_unit) == one && hidden(one + hidden(half_unit + little)) == 0x1.0000000000001p0;
}

std::string fraction_name(double a, const char* operation, double b) {
  std::array<char, 96> text{};
  // Hexadecimal floats are printed exactly in every rounding mode.
  std::snprintf(text.data(), text.size(), "%a %s %a", a, operation, b);
  return text.data();
}

// up and -minus_up are what the machine gives for the result and for the negative of its negation, rounding upwards.
void expect_directed(Failures& failures, const std::string& name, double up, double minus_up, const Rational& exact) {
  const Rational above = Rational::exactly(up);
  const Rational below = -Rational::exactly(minus_up);
  const bool encloses = below <= exact && exact <= above;
  const bool is_tight = below == above ? below == exact : std::nextafter(-minus_up, up) == up;
  if (!encloses || !is_tight) failures.push_back("rounding upwards does not round upwards: " + name);
}

void test_directed_rounding(Failures& failures) {
  constexpr std::array<std::array<double, 2>, 8> pairs = {{{1, 3},
                                                           {-1, 10},
                                                           {0x1.999999999999ap-4, 0x1.3333333333333p-2},
                                                           {0x1p100, -0x1.8p-100},
                                                           {0x1.fffffffffffffp0, 0x1.fffffffffffffp-53},
                                                           {-0x1.23456789abcdep-300, 0x1.fedcba9876543p-290},
                                                           {0x1.0000000000001p0, 0x1.fffffffffffffp-1},
                                                           {6, 2}}};
  for (const auto& [first, second] : pairs) {
    const double a = hidden(first);
    const double b = hidden(second);
    const Rational x = Rational::exactly(a);
    const Rational y = Rational::exactly(b);
    std::array<double, 10> up{};
    {
      const RoundingGuard guard;
      up = {hidden(hidden(a) + hidden(b)),           hidden(hidden(-a) + hidden(-b)),
            hidden(hidden(a) - hidden(b)),           hidden(hidden(-a) - hidden(-b)),
            hidden(hidden(a) * hidden(b)),           hidden(hidden(-a) * hidden(b)),
            hidden(hidden(a) / hidden(b)),           hidden(hidden(-a) / hidden(b)),
            hidden(std::sqrt(hidden(std::fabs(a)))), 0};
    }
    expect_directed(failures, fraction_name(a, "+", b), up[0], up[1], x + y);
    expect_directed(failures, fraction_name(a, "-", b), up[2], up[3], x - y);
    expect_directed(failures, fraction_name(a, "*", b), up[4], up[5], x * y);
    expect_directed(failures, fraction_name(a, "/", b), up[6], up[7], x / y);
    const Rational root = Rational::exactly(up[8]);
    const Rational next_lower = Rational::exactly(std::nextafter(up[8], 0));
    if (square(root) < absolute(x) || square(next_lower) >= absolute(x))
      failures.push_back("rounding upwards does not round upwards: the square root of " + fraction_name(a, "or", -a));
  }
}

// Functions of their own, with an access to volatile memory in each: what they compute cannot be moved out of the
// guard that is alive around the call, but within them the compiler is free.
struct Pair {
  double first;
  double second;
};

[[gnu::noinline]] Pair results_of_constants() {
  const double one = 1;
  const double three = 3;
  const double tenth = 0x1.999999999999ap-4;
  return {hidden(one / three), hidden(tenth * tenth)};
}

[[gnu::noinline]] Pair product_and_minus_its_negative(double a, double b) {
  return {hidden(a * b), hidden(-((-a) * b))};
}

[[gnu::noinline]] Pair sum_and_minus_its_negative(double a, double b) { return {hidden(a + b), hidden(-(-a - b))}; }

void test_that_nothing_is_evaluated_in_advance(Failures& failures) {
  Pair results{};
  {
    const RoundingGuard guard;
    results = results_of_constants();
  }
  expect(failures,
         Rational::exactly(results.first) > Rational(1) / Rational(3) &&
             Rational::exactly(results.second) > square(Rational::exactly(0x1.999999999999ap-4)),
         "the compiler evaluated constants in rounding to nearest: -frounding-math is missing");
}

void test_that_signs_stay_where_they_are(Failures& failures) {
  const double a = hidden(0x1.999999999999ap-4);
  const double b = hidden(0x1.3333333333333p-2);
  Pair product{};
  Pair sum{};
  {
    const RoundingGuard guard;
    product = product_and_minus_its_negative(a, b);
    sum = sum_and_minus_its_negative(a, b);
  }
  expect(failures, product.second < product.first && sum.second < sum.first,
         "the compiler moved a sign out of an operation: -frounding-math is missing");
}

// Two evaluations of one expression, in two rounding modes, may not become one.
void test_that_rounding_modes_are_kept_apart(Failures& failures) {
  const double a = hidden(1);
  const double b = hidden(10);
  const double nearest_before = hidden(hidden(a) / hidden(b));
  double up = 0;
  double minus_up = 0;
  {
    const RoundingGuard guard;
    up = hidden(hidden(a) / hidden(b));
    minus_up = hidden(hidden(-a) / hidden(b));
  }
  const double nearest_after = hidden(hidden(a) / hidden(b));
  expect(failures,
         nearest_before == nearest_after && -minus_up < up && (nearest_before == up || nearest_before == -minus_up),
         "a rounding mode leaks into code outside its guard");
}

void test_that_nothing_is_contracted_or_regrouped(Failures& failures) {
  const double a = hidden(0x1.0000000400000p0);
  const double rounded_square = hidden(0x1.0000000800000p0);
  const double great = hidden(0x1p60);
  const double one = hidden(1);
  const double two = hidden(2);
  // a^2 = rounded_square + 2^-60 exactly.
  // One block of straight code: compilers contract within blocks only.
  const double residue = hidden(a * a - rounded_square);
  const double minus_residue = hidden(hidden(rounded_square) - hidden(a) * hidden(a));
  const double sum = hidden(hidden(a) * hidden(a) + hidden(-rounded_square));
  expect(failures, residue == 0 && minus_residue == 0 && sum == 0,
         "products and sums are contracted to fused operations: -ffp-contract=off is missing");
  expect(failures, hidden((one + great) - great) == 0 && hidden(great + one - great) == 0,
         "the compiler regroups sums: compiled with -ffast-math or a part of it");
  expect(failures,
         hidden(hidden(5) / 3.0) == hidden(hidden(5) / hidden(3)) && hidden(5) / hidden(3) == 0x1.aaaaaaaaaaaabp0,
         "the compiler replaces quotients by products: compiled with -ffast-math or a part of it");
  const double infinite = hidden(std::numeric_limits<double>::infinity());
  const double none = hidden(infinite - infinite);
  expect(failures,
         std::isnan(none) && std::isinf(infinite) && !(none == none) && hidden(one / infinite * infinite) != one,
         "the compiler takes every number for finite: compiled with -ffast-math or a part of it");
  expect(failures, std::signbit(hidden(hidden(-0.0) * two + -0.0)) && !std::signbit(hidden(hidden(-0.0) + 0.0)),
         "the compiler drops the sign of zero: compiled with -ffast-math or a part of it");
#ifdef __FAST_MATH__
  failures.emplace_back("compiled with -ffast-math");
#endif
}

void test_subnormals(Failures& failures) {
  const double least_normal = hidden(std::numeric_limits<double>::min());
  const double least = hidden(std::numeric_limits<double>::denorm_min());
  expect(failures, hidden(least_normal / 4) == 0x1p-1024 && hidden(least_normal - least) < least_normal,
         "results below the normal numbers are flushed to zero");
  expect(failures, hidden(least * 0x1p1000) == 0x1p-74 && hidden(least + least_normal) > least_normal,
         "numbers below the normal ones are taken for zero");
}

void test_enclosures(Failures& failures) {
  const Rational tenth = Rational::exactly(0x1.999999999999ap-4);
  const Rational third = Rational(1) / Rational(3);
  Interval quotient;
  Interval product;
  Interval sum;
  Interval root;
  {
    const RoundingGuard guard;
    quotient = Interval(1) / Interval(3);
    product = square(Interval::exactly(0x1.999999999999ap-4));
    sum = Interval(1) + Interval::exactly(0x1.999999999999ap-4);
    root = square_root(Interval(2));
  }
  const auto holds = [](const Interval& interval, const Rational& exact) {
    return Rational::exactly(interval.lower()) < exact && exact < Rational::exactly(interval.upper()) &&
           std::nextafter(interval.lower(), interval.upper()) == interval.upper();
  };
  expect(failures,
         holds(quotient, third) && holds(product, square(tenth)) && holds(sum, Rational(1) + tenth) &&
             square(Rational::exactly(root.lower())) < Rational(2) &&
             square(Rational::exactly(root.upper())) > Rational(2) &&
             std::nextafter(root.lower(), root.upper()) == root.upper(),
         "an interval of doubles does not enclose its result");

  const BigInterval::Precision precision(PrecisionBits{128});
  const auto big_holds = [](const BigInterval& interval, const Rational& exact) {
    return interval.lower() < exact && exact < interval.upper() &&
           interval.upper() - interval.lower() < Rational::power_of_two(-120);
  };
  const BigInterval big_root = square_root(BigInterval(2));
  expect(failures,
         big_holds(BigInterval(1) / BigInterval(3), third) && big_holds(BigInterval(third), third) &&
             big_holds(BigInterval(third) * BigInterval(third), square(third)) &&
             square(big_root.lower()) < Rational(2) && square(big_root.upper()) > Rational(2) &&
             big_root.upper() - big_root.lower() < Rational::power_of_two(-120),
         "an MPFI interval does not enclose its result");
}

void test_that_threads_are_apart(Failures& failures) {
#if FLINT_USES_TLS
  const bool flint_is = true;
#else
  const bool flint_is = false;
#endif
  expect(failures, flint_is, "FLINT is built without caches of their own for threads");
  expect(failures, mpfr_buildopt_tls_p() != 0, "MPFR is built without caches of their own for threads");
}

std::string numbered(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string gmp_of_headers() { return numbered(__GNU_MP_VERSION, __GNU_MP_VERSION_MINOR, __GNU_MP_VERSION_PATCHLEVEL); }

void test_versions(Failures& failures) {
  const auto compare = [&failures](const char* library, const std::string& of_headers, const char* of_library) {
    std::string complaint = detail::version_mismatch(library, of_headers, of_library);
    if (!complaint.empty()) failures.push_back(std::move(complaint));
  };
  compare("GMP", gmp_of_headers(), gmp_version);
  compare("MPFR", MPFR_VERSION_STRING, mpfr_get_version());
  compare("MPFI", MPFI_VERSION_STRING, mpfi_get_version());
  compare("FLINT", FLINT_VERSION, flint_version);
#if __FLINT_RELEASE < 30000  // FLINT 3 holds the two
  compare("Arb", ARB_VERSION, arb_version);
  compare("Calcium", CALCIUM_VERSION, calcium_version());
#endif
}

}  // namespace

std::string detail::version_mismatch(std::string_view library, std::string_view of_headers,
                                     std::string_view of_library) {
  if (of_headers == of_library) return {};
  return std::string(library) + " " + std::string(of_library) + " is loaded, but compiled were the headers of " +
         std::string(of_headers);
}

std::vector<std::string> arithmetic_self_test() {
  Failures failures;
  if (!is_nearest()) {
    failures.emplace_back("rounding is not to nearest where no guard is alive");
    // What follows has no meaning in another mode.
    return failures;
  }
  test_directed_rounding(failures);
  test_that_nothing_is_evaluated_in_advance(failures);
  test_that_signs_stay_where_they_are(failures);
  test_that_rounding_modes_are_kept_apart(failures);
  test_that_nothing_is_contracted_or_regrouped(failures);
  test_subnormals(failures);
  test_enclosures(failures);
  test_that_threads_are_apart(failures);
  test_versions(failures);
  expect(failures, is_nearest(), "rounding is not to nearest after a guard");
  return failures;
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::vector<std::pair<std::string, std::string>> versions = {
      {"boost", numbered(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"cgal", CGAL_VERSION_STR},
      {"flint", flint_version},
      {"gmp", gmp_version},
      {"mpfi", mpfi_get_version()},
      {"mpfr", mpfr_get_version()}};
#if __FLINT_RELEASE < 30000
  versions.emplace_back("arb", arb_version);
  versions.emplace_back("calcium", calcium_version());
#endif
  std::sort(versions.begin(), versions.end());
  return versions;
}

}  // namespace delcert
