#pragma once

#include <arb.h>
#include <arf.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert::test {

/// A point of 𝕊ᵐ in ℝᵐ⁺¹ as balls of Arb.
class ArbVector {
 public:
  static constexpr slong bits = 256;

  template <class Entries>
  explicit ArbVector(const Entries& x) : size_(static_cast<slong>(x.size())), entries_(_arb_vec_init(size_)) {
    fmpq_t exact;
    fmpq_init(exact);
    for (slong at = 0; at < size_; ++at) {
      fmpq_set_mpq(exact, x[static_cast<std::size_t>(at)].gmp());
      arb_set_fmpq(entries_ + at, exact, bits);
    }
    fmpq_clear(exact);
  }
  ArbVector(ArbVector&& other) noexcept : size_(other.size_), entries_(std::exchange(other.entries_, nullptr)) {}
  ArbVector(const ArbVector&) = delete;
  ArbVector& operator=(const ArbVector&) = delete;
  ArbVector& operator=(ArbVector&&) = delete;
  ~ArbVector() {
    if (entries_ != nullptr) _arb_vec_clear(entries_, size_);
  }

  /// exp⁻¹ of this point in the tangent space of `centre`, with the basis that parallel transport along the geodesic
  /// from (1, 0, …, 0) gives: y·θ/sin θ, where (cos θ, y) is this point q after the rotation that takes the centre p
  /// there and leaves the complement of their plane: cos θ = ⟨p, q⟩, y = q′ − (q₀ + ⟨p′, q′⟩/(1 + p₀))·p′.
  /// The middles of balls narrower than 2⁻²⁰⁰.
  template <int m>
  [[nodiscard]] Vector<Rational, m> seen_from(const ArbVector& centre) const {
    arb_ptr scratch = _arb_vec_init(4);
    arb_ptr factor = scratch;
    arb_ptr cosine = scratch + 1;
    arb_ptr sine = scratch + 2;
    arb_ptr entry = scratch + 3;
    arb_dot(factor, nullptr, 0, entries_ + 1, 1, centre.entries_ + 1, 1, m, bits);
    arb_mul(cosine, entries_, centre.entries_, bits);
    arb_add(cosine, cosine, factor, bits);
    arb_add_ui(sine, centre.entries_, 1, bits);
    arb_div(factor, factor, sine, bits);
    arb_add(factor, factor, entries_, bits);
    // θ/sin θ
    arb_mul(sine, cosine, cosine, bits);
    arb_sub_ui(sine, sine, 1, bits);
    arb_neg(sine, sine);
    arb_sqrt(sine, sine, bits);
    arb_acos(cosine, cosine, bits);
    arb_div(sine, cosine, sine, bits);
    Vector<Rational, m> result;
    for (int axis = 0; axis < m; ++axis) {
      arb_mul(entry, factor, centre.entries_ + 1 + axis, bits);
      arb_sub(entry, entries_ + 1 + axis, entry, bits);
      arb_mul(entry, entry, sine, bits);
      EXPECT_LT(mag_cmp_2exp_si(arb_radref(entry), -200), 0);
      result[static_cast<std::size_t>(axis)] = middle(entry);
    }
    _arb_vec_clear(scratch, 4);
    return result;
  }

 private:
  static Rational middle(arb_srcptr ball) {
    fmpq_t exact;
    fmpq_init(exact);
    arf_get_fmpq(exact, arb_midref(ball));
    Rational::Wrapped result;
    fmpq_get_mpq(result.backend().data(), exact);
    fmpq_clear(exact);
    return Rational(std::move(result));
  }

  slong size_;
  arb_ptr entries_;
};

}  // namespace delcert::test
