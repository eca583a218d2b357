#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "proofs/formal/polynomial_text.hpp"

namespace delcert::test {

/// The polynomials in x and y.
inline RingPointer plane() {
  static const RingPointer ring = std::make_shared<PolynomialRing>(std::vector<std::string>{"x", "y"});
  return ring;
}
inline Polynomial x() { return Polynomial::variable(plane(), 0); }
inline Polynomial y() { return Polynomial::variable(plane(), 1); }
inline Polynomial number(long value) { return Polynomial(plane(), Rational(value)); }

/// A variable in [lower, upper], without an upper end if that is less.
inline FormalVariable between(const std::string& name, long lower, long upper) {
  FormalVariable result{name, Rational(lower), std::nullopt, false, false};
  if (upper >= lower) result.upper = Rational(upper);
  return result;
}

/// The value of a term in x and y made of + − * ^, numbers and parentheses, which is what certificates are.
class Value {
 public:
  Value(std::string text, Rational x, Rational y) : text_(std::move(text)), x_(std::move(x)), y_(std::move(y)) {}
  Rational operator()() {
    Rational result = sum();
    EXPECT_EQ(at_, text_.size()) << text_;
    return result;
  }

 private:
  char here() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (here() != c) return false;
    ++at_;
    return true;
  }
  Rational sum() {
    const bool negative = take('-');
    Rational result = negative ? -product() : product();
    for (;;) {
      if (take('+')) {
        result += product();
      } else if (take('-')) {
        result -= product();
      } else {
        return result;
      }
    }
  }
  Rational product() {
    Rational result = raised();
    for (;;) {
      if (take('*')) {
        result *= raised();
      } else if (take('/')) {
        result /= raised();
      } else {
        return result;
      }
    }
  }
  Rational raised() {
    const Rational base = atom();
    return take('^') ? power(base, static_cast<long>(atom().numerator())) : base;
  }
  Rational atom() {
    if (take('(')) {
      Rational result = sum();
      EXPECT_TRUE(take(')')) << text_;
      return result;
    }
    if (take('x')) return x_;
    if (take('y')) return y_;
    std::string digits;
    while (here() >= '0' && here() <= '9') digits += text_[at_++];
    EXPECT_FALSE(digits.empty()) << text_ << " at " << at_;
    return digits.empty() ? Rational(0) : Rational(Integer(digits));
  }

  std::string text_;
  Rational x_;
  Rational y_;
  std::size_t at_ = 0;
};

/// That two terms have the same values on a grid fine enough for their degrees.
inline void expect_equal_terms(const std::string& a, const std::string& b) {
  for (long i = -6; i <= 6; ++i) {
    for (long j = -6; j <= 6; ++j) EXPECT_EQ(Value(a, i, j)(), Value(b, i, j)()) << a << " = " << b;
  }
}

}  // namespace delcert::test
