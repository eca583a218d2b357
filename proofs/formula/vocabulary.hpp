#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/formula/expression.hpp"
#include "kernel/number/algebraic.hpp"
#include "kernel/number/surd.hpp"
#include "kernel/simplex/partial.hpp"
#include "proofs/formula/object.hpp"

namespace delcert {

template <class S>
class Evaluation;
class Scene;

/// An argument of a function on the rung S: a number, or what is the same on every rung.
template <class S>
using Argument = std::variant<S, Item>;

template <class S>
using Arguments = std::span<const Argument<S>>;

/// A function of numbers and objects, on each rung. Absent: undecided on this rung, or refuted, the function has no
/// value there.
template <class S>
using NumberOn = std::function<Partial<S>(Evaluation<S>&, Arguments<S>)>;
template <class S>
using TruthOn = std::function<Verdict(Evaluation<S>&, Arguments<S>)>;

struct NumberFunction {
  NumberOn<Interval> interval;
  NumberOn<BigInterval> big_interval;
  NumberOn<Surd> surd;
  NumberOn<Algebraic> algebraic;

  template <class S>
  [[nodiscard]] const NumberOn<S>& on() const {
    if constexpr (std::same_as<S, Interval>) return interval;
    if constexpr (std::same_as<S, BigInterval>) return big_interval;
    if constexpr (std::same_as<S, Surd>) return surd;
    if constexpr (std::same_as<S, Algebraic>) return algebraic;
  }
};

struct TruthFunction {
  TruthOn<Interval> interval;
  TruthOn<BigInterval> big_interval;
  TruthOn<Surd> surd;
  TruthOn<Algebraic> algebraic;

  template <class S>
  [[nodiscard]] const TruthOn<S>& on() const {
    if constexpr (std::same_as<S, Interval>) return interval;
    if constexpr (std::same_as<S, BigInterval>) return big_interval;
    if constexpr (std::same_as<S, Surd>) return surd;
    if constexpr (std::same_as<S, Algebraic>) return algebraic;
  }
};

/// Functions whose arguments and value do not depend on the rung.
using ItemFunction = std::function<Item(std::span<const Item>)>;
using SetFunction = std::function<std::vector<Item>(std::span<const Item>)>;

/// A function that formulas can use.
struct Function {
  std::string name;
  std::vector<Type> parameters;
  Type result;
  std::string meaning;       ///< what it is, its unit, where it is undefined; one sentence for the manual
  std::string latex;         ///< with #1, #2 … for the arguments
  bool is_variadic = false;  ///< takes two or more arguments of the type of its only parameter
  std::variant<NumberFunction, TruthFunction, ItemFunction, SetFunction> value;
};

/// A number that is defined by a formula, such as a constant of the paper.
struct Definition {
  std::string name;
  std::vector<std::string> parameters;  ///< names of numbers or integers
  std::string text;
  std::string meaning;
  std::string latex;
  ExpressionPointer body;
};

/// What formulas can use: functions, definitions, and the kinds of objects with their readers.
class Vocabulary {
 public:
  using Reader = std::function<ObjectPointer(const nlohmann::ordered_json&)>;

  /// Throw std::logic_error for a name that is taken or is none, a function whose types do not fit its kind, or a
  /// definition that is no correct formula.
  void add(Function function);
  void add_definition(const std::string& name, std::vector<std::string> parameters, const std::string& text,
                      const std::string& meaning, const std::string& latex);
  void add_kind(const std::string& kind, Reader reader);

  /// nullptr if there is none of the name.
  [[nodiscard]] const Function* function(const std::string& name) const;
  [[nodiscard]] const Definition* definition(const std::string& name) const;
  /// Throws InputError for a kind that is not known.
  [[nodiscard]] ObjectPointer read(const std::string& kind, const nlohmann::ordered_json& json) const;

  [[nodiscard]] const std::map<std::string, Function>& functions() const { return functions_; }
  [[nodiscard]] const std::map<std::string, Definition>& definitions() const { return definitions_; }
  /// All names that can be called.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  void require_free(const std::string& name) const;
  std::map<std::string, Function> functions_;
  std::map<std::string, Definition> definitions_;
  std::map<std::string, Reader> kinds_;
};

/// Makes a number function of one generic callable `f.template operator()<S>(evaluation, arguments)`.
template <class F>
[[nodiscard]] Function number_function(std::string name, std::vector<Type> parameters, std::string meaning,
                                       std::string latex, const F& f) {
  const auto on = [&f]<class S>() -> NumberOn<S> {
    return [f](Evaluation<S>& evaluation, Arguments<S> arguments) -> Partial<S> {
      return f.template operator()<S>(evaluation, arguments);
    };
  };
  NumberFunction value{on.template operator()<Interval>(), on.template operator()<BigInterval>(),
                       on.template operator()<Surd>(), on.template operator()<Algebraic>()};
  return {std::move(name), std::move(parameters), types::number, std::move(meaning), std::move(latex),
          false,           std::move(value)};
}

/// Makes a function with a verdict of one generic callable.
template <class F>
[[nodiscard]] Function truth_function(std::string name, std::vector<Type> parameters, std::string meaning,
                                      std::string latex, const F& f) {
  const auto on = [&f]<class S>() -> TruthOn<S> {
    return [f](Evaluation<S>& evaluation, Arguments<S> arguments) -> Verdict {
      return f.template operator()<S>(evaluation, arguments);
    };
  };
  TruthFunction value{on.template operator()<Interval>(), on.template operator()<BigInterval>(),
                      on.template operator()<Surd>(), on.template operator()<Algebraic>()};
  return {std::move(name), std::move(parameters), types::truth, std::move(meaning), std::move(latex),
          false,           std::move(value)};
}

/// The object of an argument, as the class that its kind is known to have.
template <class T>
[[nodiscard]] const T& object_of(const Item& item) {
  return dynamic_cast<const T&>(*std::get<ObjectPointer>(item));
}
template <class T, class S>
[[nodiscard]] const T& object_of(const Argument<S>& argument) {
  return object_of<T>(std::get<Item>(argument));
}

/// What a name is bound to, of which the instance class knows that it is an object of this class, or a number.
template <class T>
[[nodiscard]] const T& object_in(const Bindings& bindings, const std::string& name) {
  return object_of<T>(std::get<ObjectPointer>(bindings.at(name)));
}
[[nodiscard]] inline const Rational& number_in(const Bindings& bindings, const std::string& name) {
  return std::get<Rational>(bindings.at(name));
}

/// The integer of an argument, and as an index.
template <class S>
[[nodiscard]] long integer_of(const Argument<S>& argument) {
  return std::get<long>(std::get<Item>(argument));
}

/// What a name of an instance class is bound to.
using Signature = std::map<std::string, Type>;

}  // namespace delcert
