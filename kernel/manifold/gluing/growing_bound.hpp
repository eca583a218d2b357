#pragma once

#include <optional>
#include <string>

#include "kernel/manifold/gluing/affine_atlas.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

/// A bound that grows, by a 32nd of itself, until it suffices or reaches a limit.
class GrowingBound {
 public:
  explicit GrowingBound(double limit) : limit_(limit) {}
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool is_below_limit() const { return value_ < limit_; }
  /// With few binary digits, not less.
  [[nodiscard]] Rational rounded() const {
    const Rational exact = Rational::exactly(value_);
    return rounded_up(exact, binary_exponent(exact) - 11);
  }

  /// `suffices(bound)` is a verdict on an interval.
  template <class Suffices>
  void grow_until(const Suffices& suffices) {
    while (is_below_limit() && !is_proved(suffices(Interval::exactly(value_)))) value_ += value_ / 32;
  }

 private:
  double limit_;
  double value_ = 0x1p-40;
};

/// (1 − a)² b < x < (1 + a)² b, as quadratic forms. Needs a `RoundingGuard`.
template <std::size_t m>
[[nodiscard]] Verdict is_within(const std::array<std::array<Interval, m>, m>& x, const Interval& a,
                                const std::array<std::array<Interval, m>, m>& b) {
  return conjunction(is_above(x, square(Interval(1) - a), b), is_below(x, square(Interval(1) + a), b));
}

/// Makes the patches of the atlas smaller until `measure(limit)`, an optional result, has one for the limit 1/4, or
/// they are as small as they can be and it has one for the last limit. Throws Rejection, naming the manifold, if it has
/// none then.
template <int m, class Measure>
[[nodiscard]] auto fitted_patches(AffineAtlas<m>& atlas, const std::string& name, const Rational& last_limit,
                                  const Measure& measure) {
  while (true) {
    const bool is_least = atlas.patch_factor() == AffineAtlas<m>::least_patch_factor;
    if (auto result = measure(is_least ? last_limit : Rational::power_of_two(-2))) return *std::move(result);
    if (is_least)
      throw Rejection(name + ": charts are distorted by " + exact_text(last_limit) + " or more within " +
                      std::to_string(AffineAtlas<m>::least_patch_factor) + " sampling radii: take a smaller radius");
    atlas.set_patch_factor(atlas.patch_factor() - 1);
  }
}

}  // namespace delcert
