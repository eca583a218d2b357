#include "proofs/formula/arithmetic_vocabulary.hpp"

#include <mpfi.h>

#include "proofs/formula/evaluation.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// log2 at the working precision.
BigInterval binary_logarithm(const BigInterval& x) {
  mpfi_t value;
  mpfi_init2(value, BigInterval::working_precision().value);
  mpfi_log2(value, x.mpfi());
  Rational::Wrapped lower;
  Rational::Wrapped upper;
  mpfr_get_q(lower.backend().data(), &value->left);
  mpfr_get_q(upper.backend().data(), &value->right);
  mpfi_clear(value);
  return BigInterval::between(Rational(std::move(lower)), Rational(std::move(upper)));
}

template <class S>
Partial<S> logarithm(const S& x) {
  const Verdict positive = less(S(0), x);
  if (!is_proved(positive)) return Partial<S>::absent(positive);
  if constexpr (std::same_as<S, BigInterval>) {
    if (!x.is_bounded()) return Partial<S>::absent(Verdict::undecided);
    return binary_logarithm(x);
  } else if constexpr (std::same_as<S, Interval>) {
    if (x.upper() > std::numeric_limits<double>::max()) return Partial<S>::absent(Verdict::undecided);
    const auto result =
        binary_logarithm(BigInterval::between(Rational::exactly(x.lower()), Rational::exactly(x.upper())));
    const auto lower = scalar_from<Interval>(result.lower());
    const auto upper = scalar_from<Interval>(result.upper());
    return Interval::between(lower.lower(), upper.upper());
  } else if constexpr (std::same_as<S, Surd>) {
    return Partial<S>::absent(Verdict::undecided);
  } else {
    // Transcendental unless x is a power of two.
    if (x.degree() != 1) return Partial<S>::absent(Verdict::undecided);
    const Rational value = x.rational();
    const long exponent = binary_exponent(value);
    if (value != Rational::power_of_two(exponent)) return Partial<S>::absent(Verdict::undecided);
    return Algebraic(Rational(exponent));
  }
}

}  // namespace

void add_arithmetic(Vocabulary& vocabulary) {
  vocabulary.add(number_function("sqrt", {types::number}, "The square root, undefined for negative numbers.",
                                 "\\sqrt{#1}", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   const S& x = std::get<S>(a[0]);
                                   const Verdict negative = less(x, S(0));
                                   return is_refuted(negative) ? Partial<S>(square_root(x))
                                                               : Partial<S>::absent(negation(negative));
                                 }));
  vocabulary.add(number_function(
      "abs", {types::number}, "The absolute value.", "\\lvert #1\\rvert",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> { return absolute(std::get<S>(a[0])); }));
  vocabulary.add(number_function(
      "log2", {types::number}, "The binary logarithm, undefined unless positive.", "\\log_2 #1",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> { return logarithm(std::get<S>(a[0])); }));
  Function minimum_of = number_function("min", {types::number}, "The least of two or more numbers.", "\\min\\{#*\\}",
                                        []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                          S result = std::get<S>(a[0]);
                                          for (const auto& x : a) result = minimum(result, std::get<S>(x));
                                          return result;
                                        });
  minimum_of.is_variadic = true;
  vocabulary.add(std::move(minimum_of));
  Function maximum_of = number_function("max", {types::number}, "The greatest of two or more numbers.", "\\max\\{#*\\}",
                                        []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                          S result = std::get<S>(a[0]);
                                          for (const auto& x : a) result = maximum(result, std::get<S>(x));
                                          return result;
                                        });
  maximum_of.is_variadic = true;
  vocabulary.add(std::move(maximum_of));
  vocabulary.add({"range",
                  {types::integer, types::integer},
                  types::integers,
                  "The integers from the first to the last, written a .. b; empty if b < a.",
                  "\\{#1, \\ldots, #2\\}",
                  false,
                  SetFunction([](std::span<const Item> a) {
                    constexpr long most = 100000;
                    const long first = std::get<long>(a[0]);
                    const long last = std::get<long>(a[1]);
                    if (last - first > most) throw InputError("a range of more than 100 000 integers");
                    std::vector<Item> result;
                    for (long i = first; i <= last; ++i) result.emplace_back(i);
                    return result;
                  })});
}

void add_constants_of_the_paper(Vocabulary& vocabulary) {
  vocabulary.add_definition("constant_c", {"m", "mu0"}, "m^(3/2)*(2/mu0)^(4*m^2 + 5*m + 21)", "C of hyps:param.bnds.",
                            "C");
  vocabulary.add_definition("constant_c_tilde", {"m", "mu0"}, "m^(3/2)*(2/mu0)^(5*m^2 + 5*m + 21)",
                            "C̃ of thm:riem.del.tri.", "\\tilde{C}");
  vocabulary.add_definition("flake_parameter", {"m", "mu0", "rho0"}, "rho0/(m^(3/2)*(2/mu0)^(4*m^2 + 5*m + 21))",
                            "Γ₀ = ρ₀/C of lem:loc.eucl.protect.", "\\Gamma_0");
  vocabulary.add_definition("hoop_bound", {"gamma0", "mu0"}, "2^13*gamma0/mu0^3", "α₀ of lem:prop.forbid.cfg.",
                            "\\alpha_0");
  vocabulary.add_definition("hoop_bound_tilde", {"m", "gamma0", "mu0"}, "2^16*m^(3/2)*gamma0/mu0^3",
                            "α̃₀ of lem:hoop.distort.", "\\tilde{\\alpha}_0");
}

}  // namespace delcert
