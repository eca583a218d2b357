#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "proofs/formula/scene.hpp"

namespace delcert {

/// In bits: what no interval of so many tells is left undecided, or to exact numbers.
inline constexpr unsigned greatest_precision = 4096;

/// The value of formulas on one instance and one rung.
///
/// A number is an enclosure of the exact value, or absent: undecided when the rung cannot enclose it or cannot tell
/// whether it has a value, refuted when it certainly has none (a division by 0, the root of a negative number, the
/// circumradius of three points of a line). A statement about an absent number is undecided. Powers: x^0 is 1; an
/// exponent that is neither an integer nor half of one leaves the power undefined.
/// Throws InputError for an integer beyond ±10^18. Precondition for S = Interval: a `RoundingGuard` is alive.
template <class S>
class Evaluation {
 public:
  explicit Evaluation(Scene& scene);

  [[nodiscard]] Verdict truth(const Expression& statement);
  [[nodiscard]] Partial<S> number(const Expression& term);
  [[nodiscard]] Item item(const Expression& term);

  /// How much of what it allows a statement takes up: the smaller side over the larger one as the comparison has them
  /// (a/b for a ≤ b, b/a for a ≥ b), at most 1 where it holds; the greatest of the parts of a conjunction or a
  /// `forall`, the least for `or` and `exists`. Nothing where the divisor is not certainly positive, both sides are 0,
  /// or there is no comparison.
  [[nodiscard]] std::optional<S> ratio(const Expression& statement);

  /// What a function keeps for an object on this rung, such as a simplex's Gram matrix; `make()` is called once.
  /// It is found again by its type: a type of its own for each use.
  template <class T, class Make>
  [[nodiscard]] const T& attached(const Object& object, const Make& make) {
    return attached_in<T>(scene_.template cache<S>().attachments, object, make);
  }
  /// The same of what is exact, and serves all rungs.
  template <class T, class Make>
  [[nodiscard]] const T& attached_exactly(const Object& object, const Make& make) {
    return attached_in<T>(scene_.template cache<Surd>().attachments, object, make);
  }

 private:
  template <class T, class Attachments, class Make>
  [[nodiscard]] static const T& attached_in(Attachments& attachments, const Object& object, const Make& make) {
    for (const auto& known : attachments) {
      if (known.object == &object && known.type == typeid(T)) return *static_cast<const T*>(known.value.get());
    }
    auto made = std::make_shared<const T>(make());
    const T& result = *made;
    attachments.push_back({&object, typeid(T), std::move(made)});
    return result;
  }

  struct Local {
    std::string name;
    Argument<S> value;
  };

  [[nodiscard]] const Argument<S>* local(const std::string& name) const;
  [[nodiscard]] std::optional<Argument<S>> argument(const Expression& term, const Type& wanted, Verdict& absence);
  [[nodiscard]] Partial<S> call(const Expression& term);
  [[nodiscard]] Partial<S> call_definition(const Expression& term);
  [[nodiscard]] Partial<S> arithmetic(const Expression& term);
  [[nodiscard]] Partial<S> over_set(const Expression& term);
  [[nodiscard]] Verdict leaf(const Expression& statement);
  [[nodiscard]] Verdict leaf_on_this_rung(const Expression& statement);
  [[nodiscard]] Verdict predicate(const Expression& statement);
  [[nodiscard]] Verdict comparison(const Expression& statement);
  [[nodiscard]] Verdict quantified(const Expression& statement);
  [[nodiscard]] std::optional<S> ratio_of_comparison(const Expression& statement);
  [[nodiscard]] std::vector<Item> items_of(const Expression& set);
  [[nodiscard]] std::optional<Rational> exact(const Expression& term);
  [[nodiscard]] long integer(const Expression& term);

  template <class T>
  friend class Evaluation;

  Scene& scene_;
  std::vector<Local> locals_;
  std::size_t visible_from_ = 0;  ///< a definition sees its parameters only
  bool sees_bindings_ = true;
};

extern template class Evaluation<Interval>;
extern template class Evaluation<BigInterval>;
extern template class Evaluation<Surd>;
extern template class Evaluation<Algebraic>;

}  // namespace delcert
