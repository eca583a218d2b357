#pragma once

#include <optional>
#include <utility>

#include "kernel/number/verdict.hpp"

namespace delcert {

/// The value of a quantity that not every simplex has: an optional that also says how sure its absence is.
/// `exists()` is proved exactly when there is a value, refuted when the quantity certainly does not exist, undecided
/// when the arithmetic at hand could not tell.
template <class T>
class Partial : public std::optional<T> {
 public:
  Partial(T value) : std::optional<T>(std::move(value)) {}
  /// No value. Precondition: why is not `proved`.
  [[nodiscard]] static Partial absent(Verdict why) { return Partial(why); }

  [[nodiscard]] Verdict exists() const { return this->has_value() ? Verdict::proved : absence_; }

 private:
  explicit Partial(Verdict why) : absence_(why) {}
  Verdict absence_ = Verdict::undecided;
};

}  // namespace delcert
