#pragma once

namespace delcert::checker {

/// The outcome of a comparison. There is no conversion to bool: whoever asks says what undecided means.
enum class Verdict { refuted, undecided, proved };

constexpr Verdict negation(Verdict v) {
  if (v == Verdict::undecided) return v;
  return v == Verdict::proved ? Verdict::refuted : Verdict::proved;
}

constexpr Verdict conjunction(Verdict a, Verdict b) {
  if (a == Verdict::refuted || b == Verdict::refuted) return Verdict::refuted;
  return a == Verdict::proved ? b : a;
}

constexpr Verdict disjunction(Verdict a, Verdict b) { return negation(conjunction(negation(a), negation(b))); }

constexpr Verdict verdict(bool truth) { return truth ? Verdict::proved : Verdict::refuted; }

}  // namespace delcert::checker
