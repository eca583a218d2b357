#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/formula/expression.hpp"
#include "proofs/prover/bernstein.hpp"
#include "proofs/prover/extended_interval.hpp"

namespace delcert {

/// A part of the parameters: one interval for each.
using ParameterBox = std::vector<ExtendedInterval>;

/// Terms of the same parameters, laid out for many evaluations by extended intervals. A term that occurs twice is
/// computed once.
class EnclosureTape {
 public:
  explicit EnclosureTape(const std::vector<std::string>& parameters);

  /// Adds a term; the number by which it is asked for. Precondition: it has no calls but those of sqrt, abs, min, max
  /// and log2.
  std::size_t add(const ExpressionPointer& term);
  /// Adds the difference of two terms.
  std::size_t add_difference(const ExpressionPointer& a, const ExpressionPointer& b);

  /// Encloses all terms on a box.
  void evaluate(const ParameterBox& box);
  /// The enclosure of a term from the last evaluation; nothing if the term may be undefined somewhere on the box.
  [[nodiscard]] const std::optional<ExtendedInterval>& value(std::size_t term) const { return values_[term]; }

  /// The sign of a term on a box: from its enclosure, and where that does not tell, from its enclosures on the faces
  /// on which it is least and greatest, as its derivatives have one sign. Nothing is said of where it is undefined.
  [[nodiscard]] Sign sign(std::size_t term, const ParameterBox& box);

 private:
  enum class Code : unsigned char {
    constant,
    parameter,
    negate,
    add,
    subtract,
    multiply,
    divide,
    integer_power,
    power,
    root,
    logarithm,
    absolute,
    minimum,
    maximum
  };
  struct Node {
    Code code = Code::constant;
    std::size_t first = 0;   ///< a node, or the number of the parameter
    std::size_t second = 0;  ///< a node
    long exponent = 0;
    Rational value;
  };
  using Value = std::optional<ExtendedInterval>;

  std::size_t append(Node node);
  std::size_t extreme(const Expression& term, Code code);
  std::size_t power_node(const Expression& term);
  [[nodiscard]] Value compute(const Node& node, const ParameterBox& box) const;
  void differentiate(std::size_t last, const ParameterBox& box, std::size_t parameter);
  [[nodiscard]] Value derivative_of(const Node& node, std::size_t at, std::size_t parameter,
                                    PrecisionBits precision) const;
  [[nodiscard]] Value bound_on_face(std::size_t term, const ParameterBox& box, const std::vector<Sign>& slopes,
                                    bool least);

  std::map<std::string, std::size_t> index_;
  std::vector<Node> nodes_;
  std::vector<Value> values_;
  std::vector<Value> derivatives_;
  std::unordered_map<const Expression*, std::size_t> known_;
  std::vector<ExpressionPointer> kept_;
};

}  // namespace delcert
