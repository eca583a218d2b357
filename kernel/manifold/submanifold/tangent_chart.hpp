#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/submanifold/dense.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"

namespace delcert {

/// What a file has of a chart in a plane that is nearly tangent (docs/submanifolds.md); N the dimension of the space
/// around, m of the manifold, q = N − m.
struct ChartData {
  std::vector<Rational> centre;          ///< c, N coordinates near M
  std::vector<int> columns;              ///< s: column k of T is sign(s_k) times column |s_k| of the Cayley matrix
  std::vector<Rational> skew;            ///< a_12, …, a_1N, a_23, …: the skew matrix A above its diagonal
  std::vector<Rational> preconditioner;  ///< Y ≈ (Df(c)N)⁻¹, q×q row by row
  Rational radius{};                     ///< ϱ
  Rational height{};                     ///< ζ
};

/// Centre, frame and preconditioner on a rung of the ladder.
template <class S>
struct EnclosedChart {
  std::size_t dimension = 0;
  std::vector<S> centre;
  Dense<S> frame;           ///< T = [E N], N×N
  Dense<S> preconditioner;  ///< Y, q×q

  [[nodiscard]] std::size_t ambient() const { return centre.size(); }
  [[nodiscard]] std::size_t codimension() const { return centre.size() - dimension; }
  /// Entry `axis` of column `column` of T: the first m columns span the chart's plane.
  [[nodiscard]] const S& at(std::size_t axis, std::size_t column) const { return frame[axis * ambient() + column]; }

  /// c + T(y, z), x[N].
  void position(const S* y_and_z, S* x) const {
    for (std::size_t axis = 0; axis < ambient(); ++axis) {
      S sum = centre[axis];
      for (std::size_t column = 0; column < ambient(); ++column) sum += at(axis, column) * y_and_z[column];
      x[axis] = sum;
    }
  }
  /// Column `column` of T times x − c: a chart coordinate, or from column m on a height.
  [[nodiscard]] S coordinate(const S* x, std::size_t column) const {
    S sum = at(0, column) * (x[0] - centre[0]);
    for (std::size_t axis = 1; axis < ambient(); ++axis) sum += at(axis, column) * (x[axis] - centre[axis]);
    return sum;
  }
};

/// φ(x) = Eᵀ(x − c) in the cylinder |Eᵀ(x − c)| < ϱ, |Nᵀ(x − c)|_∞ < ζ, where T = [E N] = (1 − A)(1 + A)⁻¹ times a
/// signed permutation is orthogonal exactly.
class TangentChart {
 public:
  /// Throws InputError unless everything is there in the right number and `columns` is a signed permutation; ϱ and ζ
  /// may still be 0. Precondition: rounding to nearest.
  TangentChart(ChartData data, std::size_t dimension);

  [[nodiscard]] const ChartData& data() const { return data_; }
  [[nodiscard]] std::size_t dimension() const { return enclosed_.dimension; }
  [[nodiscard]] std::size_t ambient() const { return data_.centre.size(); }
  void set_size(Rational radius, Rational height);

  /// T, exactly.
  [[nodiscard]] Dense<Rational> frame() const;
  [[nodiscard]] const EnclosedChart<Interval>& enclosed() const { return enclosed_; }
  /// The same on BigInterval at its working precision, or exactly on Rational.
  template <class S>
  [[nodiscard]] EnclosedChart<S> on() const;

 private:
  ChartData data_;
  EnclosedChart<Interval> enclosed_;
};

/// The skew matrix, 12 binary digits after the point, whose Cayley matrix takes a coordinate plane nearly to the
/// tangent plane at a point with the derivative Df, q×N, and that plane's axes, first m of them, then the others. None
/// if Df has not the rank q, to double precision. In doubles, without error bounds.
struct ProposedFrame {
  std::vector<int> columns;
  std::vector<double> skew;
  Dense<double> frame;  ///< T
};
[[nodiscard]] std::optional<ProposedFrame> propose_frame(const Dense<double>& derivative, std::size_t codimension,
                                                         std::size_t ambient);

/// A chart about this centre in such a frame, still without ϱ and ζ, its preconditioner the inverse of the derivative's
/// normal part. None if there is no frame or no inverse, to double precision.
[[nodiscard]] std::optional<TangentChart> tangent_chart(const Dense<double>& derivative, std::size_t codimension,
                                                        const std::vector<Rational>& centre);

/// A chart about this centre, still without ϱ and ζ. Throws Rejection if the equations are not independent there, to
/// double precision. `f`: of the zero set. Precondition: rounding to nearest.
[[nodiscard]] TangentChart tangent_chart(const ZeroSet& zero_set, FormulaEvaluation<double>& f,
                                         const std::vector<Rational>& centre);

/// Coordinates in a message: (0.5, -1.25), rounded.
[[nodiscard]] std::string rough_text(const std::vector<double>& x);

}  // namespace delcert
