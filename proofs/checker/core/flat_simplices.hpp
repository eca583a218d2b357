#pragma once

#include <vector>

#include "proofs/checker/core/circumball.hpp"
#include "proofs/checker/parts/shared_array.hpp"

namespace delcert::checker::core {

/// What is known of a simplex of a flat torus. But for the power, all are squares of lengths.
struct FlatSimplex {
  double power = 0;                  // half of it, of all points of P' that are no vertices, at least
  double radius = 0, nearest = 0;    // the circumradius, at most; from the circumcentre to these points, at least
  double altitude = 0, longest = 0;  // the least altitude, at least; the longest edge, at most
};

/// Finds that out, from the neighbours of the vertices, which it has in doubles for each label (docs/levels/core.md,
/// Powers in doubles). Precondition: core.edges holds, and the thread rounds upwards.
class FlatSimplices {
 public:
  /// Whether there is such a thing: for translations only, and m = 2 or 3.
  static bool are(const Data& data) { return data.K == 0 && data.words.empty() && (data.m == 2 || data.m == 3); }
  /// Keeps a reference.
  explicit FlatSimplices(Complex& complex);

  /// Each simplex is looked at once. If little is known of it, nothing follows: power and nearest are not positive, the
  /// radius is infinite or not a number.
  const FlatSimplex& of(std::uint32_t s) {
    return found_.of(s, [&] { return look_at(s); });
  }

 private:
  /// A neighbour from a label, in doubles: coordinates and half of the squared length.
  struct Row {
    std::array<double, 3> x;
    double half_square;
  };
  struct Reach {
    double reach = 0, error = 0;  // the greatest coordinate; what half of a square is wrong by, at most
  };
  FlatSimplex look_at(std::uint32_t s);
  double least_power(Label i, const Vector<Interval>& linear) const;

  Complex& complex_;
  const Form<Interval> form_;
  double width_ = 0;       // of the widest enclosure of a coordinate
  std::vector<Row> rows_;  // as the neighbours in the complex
  std::vector<Reach> reach_;
  SharedFindings<FlatSimplex> found_;
};

}  // namespace delcert::checker::core
