#include <algorithm>
#include <optional>
#include <set>

#include "proofs/checker/arithmetic/cofactors.hpp"
#include "proofs/checker/atlases/blend_volume.hpp"
#include "proofs/checker/atlases/glued_charts.hpp"

namespace delcert::checker {
namespace {

Interval interval_of(double x) { return Interval::between(x, x); }

Interval central(const Interval& x) { return interval_of(std::clamp(NearPoints::middle(x), x.lower(), x.upper())); }

Matrix<Interval> matrix_of(const SquareMatrix<Interval>& a) {
  Matrix<Interval> result(a.order(), a.order());
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = a(k / a.order(), k % a.order());
  return result;
}

/// The rules of level 5, in the notation of docs/levels/atlases.md.
class BlendChecker {
 public:
  BlendChecker(const GluedCharts& charts, Report& report)
      : charts_(charts), c_(charts.certificate()), m_(c_.m_size()), report_(report) {}

  std::string check() {
    std::vector<std::size_t> seams;
    for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
      const Label* labels = c_.simplex(s);
      std::set<std::size_t> homes;
      for (std::size_t v = 0; v <= m_; ++v) homes.insert(charts_.home(labels[v]));
      if (homes.size() == 1) continue;
      seams.push_back(s);
      check_seam(labels, {homes.begin(), homes.end()});
    }
    check_clear_labels(seams);
    check_components();
    return std::to_string(seams.size()) + " simplices between charts, gamma <= " + rounded_up(c_.contraction.exact) +
           ", displacement <= " + rounded_up(c_.displacement.exact);
  }

 private:
  /// What is known of a blend; all numbers are upper bounds.
  struct Step {
    double kappa = 0, factor = 0, change = 0, back = 0, residual = 0, slope = 0;
  };
  /// What is known of all blends of a simplex.
  struct Blend {
    double displacement = 0, contraction = 0, fold = 0;
    bool known = true;                     // the numbers are not too large to be of use
    std::vector<PassageValues*> passages;  // of the last blend
  };

  Label representative(const Label* labels, std::size_t home) const {
    while (charts_.home(*labels) != home) ++labels;
    return *labels;
  }
  Cell place(std::size_t chart, Label v) const {
    const Vector<Interval>& x = *charts_.place(chart, v);
    Cell result(m_, 1);
    for (std::size_t k = 0; k < m_; ++k) result[k] = x[k];
    return result;
  }
  Matrix<Interval> matrix(Label i) const { return matrix_of(charts_.enclosed_matrix(i)); }
  Matrix<Interval> inverse(Label i) const { return matrix_of(enclosure(charts_.inverse(i))); }

  /// About the vertices in a home chart, and what is moved by this from between them.
  Cell box_about(const Label* labels, std::size_t chart, double displacement) const {
    const auto& stretch = charts_.stretch(representative(labels, chart));
    Cell result = place(chart, labels[0]);
    for (std::size_t v = 1; v <= m_; ++v) {
      const Cell x = place(chart, labels[v]);
      for (std::size_t k = 0; k < m_; ++k)
        result[k] =
            Interval::between(std::min(result[k].lower(), x[k].lower()), std::max(result[k].upper(), x[k].upper()));
    }
    for (std::size_t k = 0; k < m_; ++k) {
      const double more = displacement * stretch[k];
      result[k] = result[k] + Interval::between(-more, more);
    }
    return result;
  }
  bool is_in_chart(const Cell& cell, std::size_t chart) const {
    return is_inside_open(cell, charts_.gluing().charts[chart].domain);
  }
  /// The passages of one number that may meet the box, if they are defined on all of it; or none.
  std::vector<PassageValues*> passages_on(const Cell& box, std::size_t from, std::size_t to) const {
    for (const std::vector<std::size_t>& pieces : by_number(charts_.passages())) {
      if (charts_.passages()[pieces[0]].from != from || charts_.passages()[pieces[0]].to != to) continue;
      std::vector<PassageValues*> met;
      bool defined = true;
      for (const std::size_t t : pieces) {
        const OnCell found = charts_.values(t).on(box);
        if (found.here == Verdict::refuted) continue;
        met.push_back(&charts_.values(t));
        defined = defined && found.regular && is_in_chart(found.image, to);
      }
      if (defined) return met;
    }
    return {};
  }

  void check_seam(const Label* labels, const std::vector<std::size_t>& homes) {
    const auto which = [&] { return "simplex " + label_set(labels, labels + m_ + 1); };
    for (const std::size_t chart : homes) {
      for (std::size_t v = 0; v <= m_; ++v) {
        if (charts_.place(chart, labels[v]) != nullptr) continue;
        return report_.reject("5.blend", [&] {
          return which() + ": chart " + std::to_string(chart) + " does not show " + std::to_string(labels[v]);
        });
      }
    }
    // By parts of boxes, and where they are too large, by parts of half the size.
    std::optional<Blend> blend;
    for (std::size_t halvings = m_ == 2 ? 4 : 2, finer = 0; finer < 2; ++halvings, ++finer) {
      blend = blend_of(labels, homes, halvings);
      const bool moves_little = blend && blend->known &&
                                less_equal(interval_of(blend->displacement), c_.displacement.filter) == Verdict::proved;
      if (!moves_little) continue;
      const bool is_contraction =
          blend->fold < 1 && less_equal(interval_of(blend->contraction), c_.contraction.filter) == Verdict::proved;
      if (is_contraction || keeps_volumes(labels, homes, *blend)) return;
      break;
    }
    if (!blend) {
      return report_.reject("5.blend", [&] { return which() + ": no transition is certainly defined on all of it"; });
    }
    report_.reject("5.blend", [&] {
      return which() + ": gamma <= " + about(interval_of(blend->contraction)) +
             ", displacement <= " + about(interval_of(blend->displacement)) + " are all that is known";
    });
  }

  /// None if no transition is certainly defined on all of it.
  std::optional<Blend> blend_of(const Label* labels, const std::vector<std::size_t>& homes,
                                std::size_t halvings) const {
    Blend result;
    for (std::size_t l = 1; l < homes.size(); ++l) {
      const Cell box = box_about(labels, homes[l - 1], result.displacement);
      result.passages.clear();
      if (is_in_chart(box, homes[l - 1])) result.passages = passages_on(box, homes[l - 1], homes[l]);
      if (result.passages.empty()) return std::nullopt;
      const Step step = step_of(labels, homes[l - 1], homes[l], result.passages, box, result.displacement, halvings);
      result.fold = std::max(result.fold, step.kappa);
      // One by one, so that what is no number is not known.
      for (const double number : {step.kappa, step.factor, step.change, step.back, step.residual, step.slope})
        result.known = result.known && number < 0x1p100;
      // Rounding upwards, and no number is negative.
      result.contraction = step.kappa + step.factor * step.back * result.contraction +
                           step.slope * (step.residual + 2 * step.change * result.displacement);
      result.displacement = step.residual + step.factor * result.displacement;
    }
    const Cell box = box_about(labels, homes.back(), result.displacement);
    for (std::size_t l = 0; l + 1 < homes.size(); ++l) {
      if (!is_in_chart(box, homes.back()) || passages_on(box, homes.back(), homes[l]).empty()) return std::nullopt;
    }
    return result;
  }

  /// Whether it is a blend of two homes that makes volumes smaller by (1 - contraction)^m at most.
  bool keeps_volumes(const Label* labels, const std::vector<std::size_t>& homes, const Blend& blend) const {
    if (homes.size() != 2 || blend.passages.size() != 1) return false;
    const std::size_t from = homes[0], to = homes[1];
    SimplexOfTwoHomes simplex;
    for (std::size_t v = 0; v <= m_; ++v) {
      simplex.here.push_back(place(from, labels[v]));
      simplex.there.push_back(place(to, labels[v]));
      simplex.first.push_back(charts_.home(labels[v]) == from);
    }
    Interval least(1);
    for (std::size_t k = 0; k < m_; ++k) least = least * (Interval(1) - c_.contraction.filter);
    return is_blend_volume_at_least(simplex, *blend.passages[0], least);
  }

  /// Of the second derivatives in a box, by parts, with each side halved so often: for each axis the matrix of
  /// d(df_row/dx_k)/dx_axis.
  std::vector<Matrix<Interval>> seconds_in(PassageValues& passage, const Cell& box, std::size_t halvings) const {
    std::vector<Cell> cells{box};
    for (std::size_t halving = 0; halving < halvings * m_; ++halving) {
      std::vector<Cell> smaller;
      for (const Cell& cell : cells) {
        for (const Cell& half : halves(cell, halving % m_)) smaller.push_back(half);
      }
      cells = std::move(smaller);
    }
    std::vector<Matrix<Interval>> result;
    for (const Cell& cell : cells) {
      passage.jacobian(cell);
      const bool is_first = result.empty();
      if (is_first) result.assign(m_, Matrix<Interval>(m_, m_));
      for (std::size_t axis = 0; axis < m_; ++axis) {
        for (std::size_t k = 0; k < m_ * m_; ++k) {
          const Interval& here = passage.second(k / m_, k % m_, axis);
          Interval& all = result[axis][k];
          all = is_first ? here
                         : Interval::between(std::min(all.lower(), here.lower()), std::max(all.upper(), here.upper()));
        }
      }
    }
    return result;
  }

  /// The derivatives on a box, in the charts of i and j: each is `mean`, one of the convex hull of `changes`, and a
  /// rest.
  struct Slopes {
    Matrix<Interval> mean;
    std::vector<Matrix<Interval>> changes;
    double rest = 0;
    std::vector<Matrix<Interval>> bend;  // the second derivatives, a matrix for each direction; none of several pieces
  };

  /// Of several pieces, which are affine.
  Slopes slopes_of_pieces(Label i, Label j, const std::vector<PassageValues*>& passages, const Cell& box) const {
    Slopes result{Matrix<Interval>(m_, m_), {}, 0, {}};
    for (PassageValues* passage : passages)
      result.changes.push_back(matrix(j) * passage->jacobian(middle_of(box)) * inverse(i));
    for (std::size_t k = 0; k < m_ * m_; ++k) {
      Interval sum(0);
      for (const Matrix<Interval>& linear : result.changes) sum = sum + linear[k];
      result.mean[k] = central(sum / Interval(static_cast<int>(passages.size())));
      for (Matrix<Interval>& linear : result.changes) linear[k] = linear[k] - result.mean[k];
    }
    return result;
  }

  Slopes slopes_of(const Label* labels, std::size_t from, std::size_t to, PassageValues& passage, const Cell& box,
                   double displacement, std::size_t halvings) const {
    const Label i = representative(labels, from), j = representative(labels, to);
    const Matrix<Interval> A = matrix(i), back_to_i = inverse(i), B = matrix(j);
    const Cell centre = middle_of(box);
    Slopes result;
    result.mean = B * passage.jacobian(centre) * back_to_i;
    std::vector<Matrix<Interval>> along_axes = seconds_in(passage, box, halvings);
    for (Matrix<Interval>& along : along_axes) along = B * along * back_to_i;
    // D^2 of the passage between the charts of i and j: a matrix for each direction, its middle, and the sizes.
    result.bend.assign(m_, Matrix<Interval>(m_, m_));
    std::vector<Matrix<Interval>> mean = result.bend;
    Interval size(0), spread(0);
    for (std::size_t direction = 0; direction < m_; ++direction) {
      Matrix<Interval>& bend = result.bend[direction];
      for (std::size_t axis = 0; axis < m_; ++axis) bend = bend + back_to_i(axis, direction) * along_axes[axis];
      for (std::size_t k = 0; k < m_ * m_; ++k) {
        mean[direction][k] = central(bend[k]);
        size = size + square(bend[k]);
        spread = spread + square(bend[k] - mean[direction][k]);
      }
    }
    double reach = 0;
    for (std::size_t v = 0; v <= m_; ++v) {
      const Cell offset = A * (place(from, labels[v]) - centre);
      reach = std::max(reach, norm_above(offset));
      result.changes.push_back(combined(mean, offset));
    }
    result.rest = upper_root(spread) * reach + upper_root(size) * displacement;
    return result;
  }

  Matrix<Interval> combined(const std::vector<Matrix<Interval>>& matrices, const Cell& w) const {
    Matrix<Interval> sum(m_, m_);
    for (std::size_t k = 0; k < m_; ++k) sum = sum + w[k] * matrices[k];
    return sum;
  }

  Step step_of(const Label* labels, std::size_t from, std::size_t to, const std::vector<PassageValues*>& passages,
               const Cell& box, double displacement, std::size_t halvings) const {
    const Label i = representative(labels, from), j = representative(labels, to);
    const Matrix<Interval> A = matrix(i), B = matrix(j);
    const Slopes slopes = passages.size() > 1 ? slopes_of_pieces(i, j, passages, box)
                                              : slopes_of(labels, from, to, *passages[0], box, displacement, halvings);
    Matrix<Interval> edges_i(m_, m_), edges_j(m_, m_);
    for (std::size_t v = 1; v <= m_; ++v) {
      const Cell in_i = A * (place(from, labels[v]) - place(from, labels[0])),
                 in_j = B * (place(to, labels[v]) - place(to, labels[0]));
      for (std::size_t k = 0; k < m_; ++k) {
        edges_i(k, v - 1) = in_i[k];
        edges_j(k, v - 1) = in_j[k];
      }
    }
    const Matrix<Interval> weights = inverse_by_cofactors(edges_j), M = edges_i * weights;
    Step result;
    result.back = spectral_norm_above(M);
    for (const Matrix<Interval>& change : slopes.changes) {
      const Matrix<Interval> whole = slopes.mean + change;
      result.change = std::max(result.change, spectral_norm_above(change));
      result.factor = std::max(result.factor, spectral_norm_above(whole));
      result.kappa = std::max(result.kappa, spectral_norm_above(one_less(whole * M)));
    }
    double longest = 0, turn = 0;
    for (std::size_t v = 0; v <= m_; ++v) {
      for (std::size_t w = 0; w < v; ++w) {
        const Cell edge = A * (place(from, labels[v]) - place(from, labels[w]));
        longest = std::max(longest, norm_above(edge));
        if (!slopes.bend.empty()) turn = std::max(turn, norm_above(combined(slopes.bend, edge) * edge));
      }
    }
    result.kappa += result.back * slopes.rest;
    result.factor += slopes.rest;
    result.change += slopes.rest;
    const Interval share = Interval(static_cast<int>(m_)) / Interval(static_cast<int>(m_) + 1);
    result.residual = result.change * upper_root(share / Interval(2)) * longest;
    if (!slopes.bend.empty()) result.residual = std::min(result.residual, (share / Interval(4)).upper() * turn);
    // The weights of the vertices with a home up to `from` sum to T, the others to 1 - T.
    const bool with_first = charts_.home(labels[0]) <= from;
    Matrix<Interval> gradient(1, m_);
    for (std::size_t v = 1; v <= m_; ++v) {
      if ((charts_.home(labels[v]) <= from) == with_first) continue;
      for (std::size_t k = 0; k < m_; ++k) gradient[k] = gradient[k] + weights(v - 1, k);
    }
    result.slope = norm_above(gradient);
    return result;
  }

  /// 5.clear: each component has a label whose star is at home in one chart, with which no seam may collide.
  void check_clear_labels(const std::vector<std::size_t>& seams) const {
    std::vector<bool> pure(c_.n, true);
    for (const std::size_t s : seams) {
      for (std::size_t v = 0; v <= m_; ++v) pure[c_.simplex(s)[v]] = false;
    }
    require_clear_labels(
        c_, "5.clear",
        [&](Label k, const std::vector<Label>&) {
          return pure[k] &&
                 std::all_of(seams.begin(), seams.end(), [&](std::size_t s) { return is_away(k, c_.simplex(s)); });
        },
        report_);
  }
  /// In the last home chart of the seam. What does not show its vertices is rejected elsewhere.
  bool is_away(Label k, const Label* labels) const {
    Budget::spend(100);
    std::size_t chart = 0;
    for (std::size_t v = 0; v <= m_; ++v) chart = std::max(chart, charts_.home(labels[v]));
    if (charts_.place(chart, k) == nullptr) return true;
    const Matrix<Interval> A = matrix(representative(labels, chart));
    double longest = 0;
    for (std::size_t v = 0; v <= m_; ++v) {
      if (charts_.place(chart, labels[v]) == nullptr) return false;
      longest = std::max(longest, norm_above(A * (place(chart, labels[v]) - place(chart, labels[0]))));
    }
    const Interval distance = square_root(squared_norm(A * (place(chart, k) - place(chart, labels[0]))));
    return less(interval_of(longest) + c_.displacement.filter, distance) == Verdict::proved;
  }

  /// 5.components: every chart shows some label.
  void check_components() const {
    for (std::size_t chart = 0; chart < charts_.gluing().charts.size(); ++chart) {
      bool any = false;
      for (Label k = 0; k < c_.n && !any; ++k) any = charts_.place(chart, k) != nullptr;
      if (!any) report_.reject("5.components", [&] { return "chart " + std::to_string(chart) + " shows no label"; });
    }
  }

  const GluedCharts& charts_;
  const Certificate& c_;
  std::size_t m_;
  Report& report_;
};

}  // namespace

std::string check_blended_triangulation(const GluedCharts& charts, Report& report) {
  return BlendChecker(charts, report).check();
}

}  // namespace delcert::checker
