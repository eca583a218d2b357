#pragma once

#include <string_view>

namespace delcert {

/// The outcome of a decision. `undecided` means that the arithmetic at hand could not tell; it never stands for
/// either of the others. There is no conversion to bool: a caller says which outcome it asks for.
enum class Verdict : signed char { refuted = -1, undecided = 0, proved = 1 };

[[nodiscard]] constexpr Verdict verdict_of(bool truth) { return truth ? Verdict::proved : Verdict::refuted; }

[[nodiscard]] constexpr bool is_proved(Verdict verdict) { return verdict == Verdict::proved; }
[[nodiscard]] constexpr bool is_refuted(Verdict verdict) { return verdict == Verdict::refuted; }
[[nodiscard]] constexpr bool is_undecided(Verdict verdict) { return verdict == Verdict::undecided; }

/// Kleene's three-valued connectives.
[[nodiscard]] constexpr Verdict negation(Verdict a) { return static_cast<Verdict>(-static_cast<int>(a)); }
[[nodiscard]] constexpr Verdict conjunction(Verdict a, Verdict b) { return a < b ? a : b; }
[[nodiscard]] constexpr Verdict disjunction(Verdict a, Verdict b) { return a < b ? b : a; }

[[nodiscard]] constexpr std::string_view name_of(Verdict verdict) {
  return is_proved(verdict) ? "proved" : is_refuted(verdict) ? "refuted" : "undecided";
}

}  // namespace delcert
