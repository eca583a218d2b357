#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "proofs/checker/arithmetic/matrix.hpp"

namespace delcert::checker {

/// Throws Malformed (form.formula) unless these are names of variables, each another one.
void require_names(const std::vector<std::string_view>& variables);

/// A map from R^n to R^q by formulas, as one list of operations.
class FormulaMap {
 public:
  static constexpr std::size_t most_variables = 9, most_steps = 10'000;

  FormulaMap() = default;
  /// The formulas are those of docs/certificate-format.md. Throws Malformed (form.formula).
  /// `folds`: abs() is allowed; such a map has no values here, only pieces (map_piece.hpp).
  FormulaMap(const std::vector<std::string_view>& variables, const std::vector<std::string_view>& formulas,
             bool folds = false);

  enum class Operation {
    constant,
    variable,
    sum,
    difference,
    product,
    negative,
    reciprocal,
    power,
    root,
    exp,
    sin,
    cos,
    absolute
  };
  /// What an operation is done to: earlier steps; the number of a constant or a variable; an exponent second.
  struct Step {
    Operation operation;
    std::size_t first = 0, second = 0;
    auto operator<=>(const Step&) const = default;
  };

  std::size_t variable_count() const { return variables_; }
  std::size_t function_count() const { return results_.size(); }
  const std::vector<Step>& steps() const { return steps_; }
  const Quantity& constant(std::size_t k) const { return constants_[k]; }
  /// The step whose value is the function.
  std::size_t result(std::size_t function) const { return results_[function]; }
  /// Whether the value of a step depends on a variable, on this one.
  bool depends(std::size_t step) const { return depends_[step] != 0; }
  bool depends(std::size_t step, std::size_t variable) const { return (depends_[step] >> variable & 1U) != 0; }

 private:
  friend class FormulaReader;
  std::size_t append(const Step& step);
  std::size_t append_constant(const Rational& value);

  std::size_t variables_ = 0;
  std::vector<Step> steps_;
  std::vector<unsigned> depends_;  // bit k: on variable k
  std::vector<Quantity> constants_;
  std::vector<std::size_t> results_;
  std::map<Step, std::size_t> known_;
};

/// Values and derivatives of a map at a point, or on a box, whose coordinates are enclosed: of all points in it. Where
/// a value is not certainly defined, enclosures are infinite.
template <class N>
class FormulaValues {
 public:
  /// Keeps a reference.
  explicit FormulaValues(const FormulaMap& map);

  /// `order` derivatives are computed: 0, 1 or 2.
  void evaluate(const Matrix<N>& x, int order);
  const N& value(std::size_t function) const { return values_[map_.result(function)]; }
  Matrix<N> value() const;
  /// Row by row the gradients.
  Matrix<N> jacobian() const;
  const N& second(std::size_t function, std::size_t k, std::size_t l) const {
    return seconds_[map_.result(function) * pairs_ + pair(k, l)];
  }

 private:
  std::size_t pair(std::size_t k, std::size_t l) const { return k < l ? l * (l + 1) / 2 + k : k * (k + 1) / 2 + l; }
  void compose(std::size_t at, std::size_t of, const N& slope, const N& bend, int order);

  const FormulaMap& map_;
  std::size_t pairs_;
  std::vector<N> values_, firsts_, seconds_;  // of each step one; one a variable; one a pair of variables
};

}  // namespace delcert::checker
