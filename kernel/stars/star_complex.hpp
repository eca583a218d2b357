#pragma once

#include <string>
#include <vector>

#include "kernel/stars/proposal.hpp"
#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// What is wrong with a star.
enum class FailureCause : unsigned char {
  undecided,       ///< a decision was left open, or too little was seen: the star may be right
  occupied_ball,   ///< the closed circumball of a simplex has another point in it: shown, not only not refuted
  less_protected,  ///< a simplex is less protected than required, or not certainly as much
  combinatorial,   ///< no simplices, labels twice, faces in other than two simplices, stars that disagree
};

/// Why a star is not certified.
struct StarFailure {
  Label label;
  std::string reason;            ///< for people
  std::vector<Label> concerned;  ///< the points that it lies with
  FailureCause cause = FailureCause::undecided;
};

/// All points that failures lie with, each once, in increasing order.
[[nodiscard]] std::vector<Label> labels_concerned_by(const std::vector<StarFailure>& failures);

/// What is certified of all simplices together: lengths, not multiples of ε.
struct StarMargins {
  Rational protection;    ///< δ > 0: every simplex is δ-protected
  Rational thickness;     ///< every simplex is at least this thick
  Rational circumradius;  ///< no circumradius is larger
};

/// The simplices of the stars of all interior labels, mod the lattice, in increasing order.
template <int m>
class StarComplex {
 public:
  StarComplex(std::vector<LiftedSimplex<m>> simplices, const std::vector<bool>& interior);

  [[nodiscard]] const std::vector<LiftedSimplex<m>>& simplices() const { return simplices_; }
  /// The other labels of each simplex of star(i), sorted, in increasing order; empty unless i is interior.
  [[nodiscard]] std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> star(Label i) const;
  /// Of the complex of all faces, a face being its set of labels.
  [[nodiscard]] long euler_characteristic() const;
  /// The complex of all faces, a face being its set of labels. Throws InputError if a simplex meets itself.
  [[nodiscard]] PureComplex label_complex() const;
  /// Stars that are empty, or in which a face of dimension m−1 at the label is not in exactly two simplices, and
  /// simplices that meet themselves. In parallel.
  [[nodiscard]] std::vector<StarFailure> combinatorial_failures() const;

 private:
  /// Of the stars of these labels, where no simplex meets itself.
  [[nodiscard]] std::vector<StarFailure> failures_at(std::size_t first_label, std::size_t last_label) const;

  std::vector<LiftedSimplex<m>> simplices_;
  std::vector<bool> interior_;
  std::vector<std::size_t> first_;  // simplices of label i: at_[first_[i]] … at_[first_[i+1] − 1]
  std::vector<std::uint32_t> at_;
};

}  // namespace delcert
