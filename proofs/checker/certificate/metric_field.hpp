#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "proofs/checker/arithmetic/square_matrix.hpp"
#include "proofs/checker/certificate/cursor.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

struct Certificate;

/// The points x of R^m with x_k in the k-th interval.
using Box = std::vector<Interval>;

/// A symmetric matrix that depends on a point of R^m, periodic by Z^m: constant + sum over the waves of
/// cosine cos(2 pi k x) + sine sin(2 pi k x), as a certificate states it; and what it states of its charts.
struct MetricField {
  /// The part of the manifold block from the key "constant" on. Throws Malformed.
  MetricField(int dimension, Cursor& cursor);

  struct Wave {
    std::vector<int> frequency;
    SquareMatrix<Rational> cosine, sine;
    SquareMatrix<Interval> cosine_filter, sine_filter;
  };
  std::size_t m;
  SquareMatrix<Rational> constant;
  SquareMatrix<Interval> constant_filter;
  std::vector<Wave> waves;
  Quantity rounding, patch_radius, metric_distortion;

  /// An enclosure of the value at a point, with the precision of balls.
  SquareMatrix<Ball> at(const std::vector<Rational>& point) const;
  /// An enclosure of the values in the box.
  SquareMatrix<Interval> within(const Box& box) const;
};

/// Whether the property holds of the values in the box: of an enclosure of all of them, or of the halves of the box.
/// Throws Undecided when it has looked at `most` boxes and does not know. The property takes a matrix of intervals and
/// returns a Verdict that, if it is not undecided, holds of every matrix in it.
bool holds_within(const MetricField& field, const Box& box, std::size_t most,
                  const std::function<Verdict(const SquareMatrix<Interval>&)>& property);

SquareMatrix<Interval> enclosure(const SquareMatrix<Rational>& a);

/// B = A^T A of the chart of a label, A upper triangular.
SquareMatrix<Rational> gram_of_chart(const Certificate& c, std::uint32_t label);
}  // namespace delcert::checker
