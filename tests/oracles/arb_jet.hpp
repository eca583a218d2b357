#pragma once

#include <arb.h>

#include <array>
#include <utility>

#include "kernel/number/big_interval.hpp"

namespace delcert::test {

/// A function of three variables with its first and second derivatives at a place or on a box: balls of Arb, by rules
/// for sums, products and what is applied to a jet. Formulas are not read: they are written in C++.
class ArbJet {
 public:
  static constexpr slong bits = 200;
  static constexpr std::size_t axes = 3;

  /// 0.
  ArbJet() : entries_(_arb_vec_init(size)) {}
  ArbJet(int number) : ArbJet() { arb_set_si(entries_, number); }  // NOLINT(google-explicit-constructor)
  ArbJet(const ArbJet& other) : ArbJet() { _arb_vec_set(entries_, other.entries_, size); }
  ArbJet(ArbJet&& other) noexcept : entries_(std::exchange(other.entries_, nullptr)) {}
  ArbJet& operator=(ArbJet other) {
    std::swap(entries_, other.entries_);
    return *this;
  }
  ~ArbJet() {
    if (entries_ != nullptr) _arb_vec_clear(entries_, size);
  }

  /// The coordinate of this axis, between these ends.
  static ArbJet variable(std::size_t axis, double from, double to) {
    ArbJet result;
    arb_t end;
    arb_init(end);
    arb_set_d(result.entries_, from);
    arb_set_d(end, to);
    arb_union(result.entries_, result.entries_, end, bits);
    arb_clear(end);
    arb_set_si(result.first(axis), 1);
    return result;
  }

  friend ArbJet operator+(const ArbJet& a, const ArbJet& b) {
    ArbJet result;
    _arb_vec_add(result.entries_, a.entries_, b.entries_, size, bits);
    return result;
  }
  friend ArbJet operator-(const ArbJet& a, const ArbJet& b) {
    ArbJet result;
    _arb_vec_sub(result.entries_, a.entries_, b.entries_, size, bits);
    return result;
  }
  friend ArbJet operator*(const ArbJet& a, const ArbJet& b) {
    ArbJet result;
    for (slong at = 0; at < size; ++at) {
      arb_addmul(result.entries_ + at, a.entries_, b.entries_ + at, bits);
      if (at > 0) arb_addmul(result.entries_ + at, b.entries_, a.entries_ + at, bits);
    }
    for (std::size_t i = 0; i < axes; ++i) {
      for (std::size_t j = i; j < axes; ++j) {
        arb_addmul(result.second(i, j), a.first(i), b.first(j), bits);
        arb_addmul(result.second(i, j), a.first(j), b.first(i), bits);
      }
    }
    return result;
  }
  friend ArbJet operator/(const ArbJet& a, const ArbJet& b) {
    return a * b.applied([](arb_ptr u) {  // 1/v, -1/v², 2/v³
      arb_inv(u, u, bits);
      arb_sqr(u + 1, u, bits);
      arb_neg(u + 1, u + 1);
      arb_mul(u + 2, u, u + 1, bits);
      arb_mul_si(u + 2, u + 2, -2, bits);
    });
  }
  friend ArbJet sqrt(const ArbJet& a) {
    return a.applied([](arb_ptr u) {  // √v, 1/(2√v), -1/(4v√v)
      arb_set(u + 2, u);
      arb_sqrt(u, u, bits);
      arb_mul(u + 2, u + 2, u, bits);
      arb_inv(u + 2, u + 2, bits);
      arb_div_si(u + 2, u + 2, -4, bits);
      arb_inv(u + 1, u, bits);
      arb_div_si(u + 1, u + 1, 2, bits);
    });
  }
  friend ArbJet exp(const ArbJet& a) {
    return a.applied([](arb_ptr u) {
      arb_exp(u, u, bits);
      arb_set(u + 1, u);
      arb_set(u + 2, u);
    });
  }
  friend ArbJet sin(const ArbJet& a) {
    return a.applied([](arb_ptr u) {
      arb_cos(u + 1, u, bits);
      arb_sin(u, u, bits);
      arb_neg(u + 2, u);
    });
  }
  friend ArbJet cos(const ArbJet& a) {
    return a.applied([](arb_ptr u) {
      arb_sin(u + 1, u, bits);
      arb_neg(u + 1, u + 1);
      arb_cos(u, u, bits);
      arb_neg(u + 2, u);
    });
  }

  /// f, Df and D²f, row by row, as `FormulaEvaluation` has them.
  [[nodiscard]] std::array<std::pair<Rational, Rational>, 1 + axes + axes * axes> ends() const {
    std::array<std::pair<Rational, Rational>, 1 + axes + axes * axes> result;
    result[0] = ends_of(entries_);
    for (std::size_t i = 0; i < axes; ++i) {
      result[1 + i] = ends_of(first(i));
      for (std::size_t j = 0; j < axes; ++j) result[1 + axes + axes * i + j] = ends_of(second(i, j));
    }
    return result;
  }

 private:
  static constexpr slong size = 10;

  [[nodiscard]] arb_ptr first(std::size_t i) const { return entries_ + 1 + i; }
  [[nodiscard]] arb_ptr second(std::size_t i, std::size_t j) const {
    constexpr std::array<std::array<int, axes>, axes> place{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
    return entries_ + 4 + place[i][j];
  }

  /// u(this), where `derivatives` takes v to u(v), u′(v), u″(v).
  template <class Derivatives>
  [[nodiscard]] ArbJet applied(const Derivatives& derivatives) const {
    const arb_ptr u = _arb_vec_init(3);
    arb_set(u, entries_);
    derivatives(u);
    ArbJet result;
    arb_set(result.entries_, u);
    for (slong at = 1; at < size; ++at) arb_mul(result.entries_ + at, entries_ + at, u + 1, bits);
    arb_t product;
    arb_init(product);
    for (std::size_t i = 0; i < axes; ++i) {
      for (std::size_t j = i; j < axes; ++j) {
        arb_mul(product, first(i), first(j), bits);
        arb_addmul(result.second(i, j), product, u + 2, bits);
      }
    }
    arb_clear(product);
    _arb_vec_clear(u, 3);
    return result;
  }

  static std::pair<Rational, Rational> ends_of(arb_srcptr ball) {
    mpfi_t interval;
    mpfi_init2(interval, bits);
    arb_get_interval_mpfr(&interval->left, &interval->right, ball);
    const BigInterval copy = BigInterval::copy_of(interval);
    mpfi_clear(interval);
    return {copy.lower(), copy.upper()};
  }

  arb_ptr entries_;
};

}  // namespace delcert::test
