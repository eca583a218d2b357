#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proofs/formula/point_rules.hpp"
#include "proofs/formula/vocabulary.hpp"
#include "properties/instances/choices.hpp"

namespace delcert {

/// The dimensions of an instance: a k-simplex in ℝᵐ, a net in ℝᵐ (k = 0).
struct Shape {
  int k = 0;
  int m = 0;
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// What is remarkable about an instance, counted in reports.
enum class Trait : unsigned char {
  boundary,           ///< a hypothesis holds with equality, or up to 2⁻⁴⁰ of it
  nearly_degenerate,  ///< thickness below 2⁻²⁰
  cospherical,        ///< more points on a sphere than dimensions explain, or up to 2⁻²⁰ of it
};

struct Instance {
  Bindings bindings;
  std::set<Trait> traits;
};

/// How large a number of an instance may be, as the hypotheses of the claim at hand say.
class Limits {
 public:
  Limits() = default;
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  virtual ~Limits() = default;

  /// The largest value of `name` with which every hypothesis of the form `name <= term` or `name < term` holds, for
  /// the names that are bound already: exactly the term if it is rational and `exact`, else a lower bound of it, within
  /// 2⁻³⁰ of it. Nothing if there is no such hypothesis. 0 if the term has no value.
  [[nodiscard]] virtual std::optional<Rational> most(const std::string& name, const Bindings& bound,
                                                     bool exact) const = 0;

  /// What the points of the claim are, for the class `point-set`; nullptr if the claim does not say.
  [[nodiscard]] virtual const PointRules* points() const { return nullptr; }
  /// The constraints of its points, formulas about the names of the class and the claim's parameters.
  [[nodiscard]] virtual std::vector<ExpressionPointer> constraints() const { return {}; }
};

/// No limits at all.
class NoLimits : public Limits {
 public:
  [[nodiscard]] std::optional<Rational> most(const std::string&, const Bindings&, bool) const override {
    return std::nullopt;
  }
};

/// A class of instances: what it binds, how one is drawn, how one is made simpler. One file for each class; the list
/// of all is in instance_classes.cpp. Objects of a class have no state.
class InstanceClass {
 public:
  InstanceClass() = default;
  InstanceClass(const InstanceClass&) = delete;
  InstanceClass& operator=(const InstanceClass&) = delete;
  virtual ~InstanceClass() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  /// One sentence for the manual.
  [[nodiscard]] virtual std::string meaning() const = 0;
  /// What it binds; every claim about the class can use these names.
  [[nodiscard]] virtual Signature signature() const = 0;
  /// Adds the kinds and quantities that only this class has.
  virtual void extend(Vocabulary& vocabulary) const;

  /// Where an instance lives, a word or two for tables: ℝᵐ unless the class says otherwise.
  [[nodiscard]] virtual std::string manifold(const Bindings& bindings) const;

  /// The shapes that an attack goes through unless told otherwise, from small to large.
  [[nodiscard]] virtual std::vector<Shape> shapes() const = 0;

  /// Whether an attack can be told to use a shape: one of `shapes()`, or, for simplices, one of a higher dimension up
  /// to 8 with as many dimensions to spare as one of these.
  [[nodiscard]] virtual bool has(const Shape& shape) const;

  /// About how many simplices cost as much as one instance of this shape: a campaign of N samples has N/cost of it.
  [[nodiscard]] virtual std::uint64_t cost(const Shape& shape) const;

  /// One instance. `given` holds the parameters of the claim (its `forall`), and belongs to the instance. What the
  /// class promises holds by construction; hypotheses that limit a number (a distortion, say) are met by asking
  /// `limits`, and reached now and then. Nothing if these choices lead to none.
  [[nodiscard]] virtual std::optional<Instance> draw(const Shape& shape, const Bindings& given, const Limits& limits,
                                                     Choices& choices) const = 0;

  /// Whether there are structured instances of this shape: those next to which the known bounds are nearly attained,
  /// such as two flat groups of vertices. A directed search begins with some of them; an attack does not draw them.
  [[nodiscard]] virtual bool has_structure(const Shape& shape) const;
  /// One of them, as `draw`. Nothing where there are none.
  [[nodiscard]] virtual std::optional<Instance> draw_structured(const Shape& shape, const Bindings& given,
                                                                const Limits& limits, Choices& choices) const;

  /// Simpler instances near this one, the simplest first: fewer, smaller, rounder numbers. Each is an instance of the
  /// class again; that the hypotheses still hold is not asked. Finite descent: what is simpler than itself never ends.
  [[nodiscard]] virtual std::vector<Bindings> simpler(const Bindings& bindings) const = 0;

  /// Throws InputError, saying why, for bindings that are no instance of the class: names or types that are not those
  /// of the signature, and a broken promise (a distortion that is not one, say). Decided exactly.
  virtual void require(const Bindings& bindings) const = 0;
};

/// All instance classes, by name in alphabetical order.
[[nodiscard]] const std::vector<const InstanceClass*>& instance_classes();

/// Throws InputError, with a suggestion, for a class that does not exist.
[[nodiscard]] const InstanceClass& instance_class(const std::string& name);

/// The standard vocabulary and what all the classes add.
[[nodiscard]] const Vocabulary& full_vocabulary();

/// Throws InputError unless the names of the signature are bound to what it says. What else is bound are parameters of
/// a claim, which are numbers.
void require_signature(const InstanceClass& instance_class, const Bindings& bindings);

/// "k=2 m=3", "m=2" for a class without k.
[[nodiscard]] std::string text_of(const Shape& shape);

}  // namespace delcert
