#pragma once

#include <flint/fmpq.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace delcert::replay {

/// What is wrong with a log: the program says so and ends with status 1.
class Rejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// On this line of the log, counted from 1.
  Rejected(const std::string& what, std::size_t line) : std::runtime_error(what), line_(line) {}

  /// 0 if it is not known.
  std::size_t line() const { return line_; }

 private:
  std::size_t line_ = 0;
};

/// What is no log at all: status 3.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An exact rational number of FLINT.
class Number {
 public:
  Number() { fmpq_init(value_); }
  explicit Number(long value) : Number() { fmpq_set_si(value_, value, 1); }
  Number(const Number& other) : Number() { fmpq_set(value_, other.value_); }
  Number(Number&& other) noexcept : Number() { fmpq_swap(value_, other.value_); }
  Number& operator=(Number other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Number() { fmpq_clear(value_); }

  /// Reads "-3/4". Throws Malformed for anything else.
  static Number read(const std::string& text) {
    Number result;
    const bool has_digit = text.find_first_of("0123456789") != std::string::npos;
    if (!has_digit || text.find_first_not_of("-/0123456789") != std::string::npos ||
        fmpq_set_str(result.value_, text.c_str(), 10) != 0 || fmpz_is_zero(fmpq_denref(result.value_))) {
      throw Malformed("no number: " + text);
    }
    fmpq_canonicalise(result.value_);
    return result;
  }

  fmpq* raw() { return value_; }
  const fmpq* raw() const { return value_; }
  int sign() const { return fmpq_sgn(value_); }
  bool is_integer() const { return fmpz_is_one(fmpq_denref(value_)) != 0; }
  std::string text() const {
    char* raw_text = fmpq_get_str(nullptr, 10, value_);
    std::string result = raw_text;
    flint_free(raw_text);
    return result;
  }

  friend Number operator+(const Number& a, const Number& b) { return apply(fmpq_add, a, b); }
  friend Number operator-(const Number& a, const Number& b) { return apply(fmpq_sub, a, b); }
  friend Number operator*(const Number& a, const Number& b) { return apply(fmpq_mul, a, b); }
  /// Precondition: b is not 0.
  friend Number operator/(const Number& a, const Number& b) { return apply(fmpq_div, a, b); }
  friend bool operator==(const Number& a, const Number& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend bool operator<(const Number& a, const Number& b) { return fmpq_cmp(a.value_, b.value_) < 0; }
  friend bool operator<=(const Number& a, const Number& b) { return fmpq_cmp(a.value_, b.value_) <= 0; }

 private:
  static Number apply(void (*operation)(fmpq*, const fmpq*, const fmpq*), const Number& a, const Number& b) {
    Number result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }
  fmpq_t value_;
};

/// One parameter on a box: the numbers from the lower to the upper end, nothing for an infinite one.
struct Side {
  std::optional<Number> lower;
  std::optional<Number> upper;
  bool lower_open = true;
  bool upper_open = true;
  bool is_integer = false;
  bool is_squared = false;  ///< the variable of polynomials is the root of the parameter

  bool is_point() const { return lower && upper && *lower == *upper; }
};

}  // namespace delcert::replay
