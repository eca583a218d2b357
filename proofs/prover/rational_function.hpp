#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/formula/expression.hpp"
#include "kernel/formula/rational_function.hpp"
#include "proofs/prover/bernstein.hpp"

namespace delcert {

/// Reads terms as rational functions of the variables of a ring. A parameter that is marked *squared* is the square of
/// its variable, which is not negative: so its roots and half-integer powers are polynomials.
class RationalFunctionReader {
 public:
  /// What is known of the sign of a polynomial for all parameters.
  using SignOf = std::function<Sign(const Polynomial&)>;

  /// The variables of the ring are the parameters, in the same order.
  RationalFunctionReader(RingPointer ring, std::vector<bool> squared, SignOf sign_of);

  /// Nothing if the term is no rational function or none of moderate size, or a root in it has no known sign.
  [[nodiscard]] std::optional<RationalFunction> read(const Expression& term);

  /// What must not vanish for the terms read so far to have a value.
  [[nodiscard]] const std::vector<Polynomial>& divisors() const { return divisors_; }
  void forget_divisors() {
    divisors_.clear();
    known_.clear();
  }
  /// The parameters that would have to be squared for a root that was met to be a rational function.
  [[nodiscard]] const std::set<std::size_t>& wanted_squares() const { return wanted_squares_; }

 private:
  using Result = std::optional<RationalFunction>;
  [[nodiscard]] Result compute(const Expression& term);
  [[nodiscard]] Result call(const Expression& term);
  [[nodiscard]] Result power(const Expression& term);
  [[nodiscard]] Result integer_power(const RationalFunction& base, long exponent);
  [[nodiscard]] Result quotient(const RationalFunction& a, const RationalFunction& b);
  [[nodiscard]] Result root(const RationalFunction& a);
  [[nodiscard]] Result extreme(const Expression& term, bool greatest);
  [[nodiscard]] std::optional<Polynomial> size(const Polynomial& p) const;
  [[nodiscard]] Sign sign(const RationalFunction& a) const;
  [[nodiscard]] RationalFunction constant(const Rational& value) const;

  RingPointer ring_;
  std::map<std::string, std::size_t> index_;
  std::vector<bool> squared_;
  SignOf sign_of_;
  std::vector<Polynomial> divisors_;
  std::set<std::size_t> wanted_squares_;
  std::unordered_map<const Expression*, Result> known_;
};

}  // namespace delcert
