#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kernel/formula/formula_graph.hpp"
#include "kernel/number/big_interval.hpp"
#include "kernel/number/interval.hpp"

namespace delcert {

/// A map f: ℝᴺ → ℝ^q by plain formulas (kernel/formula/plain_formula.hpp), prepared for evaluation with first and
/// second derivatives.
class FormulaMap {
 public:
  /// Throws FormulaError, with the offset in its formula, for what `parse_plain_formula` refuses, for a division by a
  /// constant that is 0, and for the root of one that is not positive; the message names the formula if there are
  /// several. Precondition: the variables are distinct names (`is_name_of_variable`).
  FormulaMap(std::vector<std::string> variables, const std::vector<std::string>& formulas);

  [[nodiscard]] std::size_t variable_count() const { return variables_.size(); }
  [[nodiscard]] std::size_t function_count() const { return texts_.size(); }
  [[nodiscard]] const std::vector<std::string>& variables() const { return variables_; }
  /// The formulas as certificates have them: `canonical_text`.
  [[nodiscard]] const std::vector<std::string>& canonical_texts() const { return texts_; }

  struct Step {
    FormulaStep step;
    FormulaGraph::Node node;
    FormulaGraph::Node first;
    FormulaGraph::Node second;
  };
  /// What has to be worked out, in this order, for the values (0), with the first derivatives (1), with the second (2),
  /// and the nodes of the results: f, row by row Df, and of D²f the entries i ≤ j of each function.
  struct Program {
    std::vector<Step> steps;
    std::vector<FormulaGraph::Node> results;
  };
  [[nodiscard]] const Program& program(std::size_t order) const { return programs_[order]; }
  [[nodiscard]] const FormulaGraph& graph() const { return graph_; }

 private:
  [[nodiscard]] Program program_for(std::vector<FormulaGraph::Node> results) const;

  std::vector<std::string> variables_;
  std::vector<std::string> texts_;
  FormulaGraph graph_;
  std::array<Program, 3> programs_;
};

/// Values and derivatives of a map at a point or on a box; S is double (rounding to nearest, without error bounds),
/// Interval (needs a `RoundingGuard`, in the constructor too) or BigInterval (constants have the precision at which the
/// evaluation was made). On intervals what is returned encloses the values at all points of the box. Has scratch
/// memory: one for each thread.
template <class S>
class FormulaEvaluation {
 public:
  /// Keeps a reference.
  explicit FormulaEvaluation(const FormulaMap& map);

  // All return false where a value is not certainly defined: division by what may be 0, the root of what may be ≤ 0.
  // Then nothing is written.

  /// x[N], f[q].
  [[nodiscard]] bool value(const S* x, S* f);
  /// df[q·N], row by row.
  [[nodiscard]] bool first(const S* x, S* f, S* df);
  /// ddf[q·N·N], symmetric for each function.
  [[nodiscard]] bool second(const S* x, S* f, S* df, S* ddf);

 private:
  bool run(const FormulaMap::Program& program, const S* x);

  const FormulaMap& map_;
  std::vector<S> values_;  ///< of the nodes of the graph
};

extern template class FormulaEvaluation<double>;
extern template class FormulaEvaluation<Interval>;
extern template class FormulaEvaluation<BigInterval>;

}  // namespace delcert
