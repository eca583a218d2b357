#pragma once

#include <vector>

#include "proofs/checker/lifts.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {

/// The lifts at distance <= radius of the original point p_i, in the chart of it: the inverse of exp.
class Chart {
 public:
  Chart(const Certificate& c, const Lifts& lifts, Label i, const Rational& radius)
      : c_(c), lifts_(lifts), label_(i), seen_(lifts.around(i, radius)) {
    for (const Seen& seen : seen_) {
      filter_.push_back(in_chart(seen.conformal));
      distance_.push_back(square_root(squared(filter_.back(), c.m_size())).lower());
    }
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t size() const { return seen_.size(); }
  Label label(std::size_t at) const { return seen_[at].label; }
  /// A lower bound of the distance from the origin of the coordinates.
  double distance(std::size_t at) const { return distance_[at]; }
  /// The place of the label, or `none`. Throws Undecided if two of its lifts might be within the radius.
  std::size_t find(Label label) const;
  /// The places of these labels and of those in the list; empty if one is missing, which is then in `missing`.
  std::vector<std::size_t> find(Label first, const Label* others, Label& missing) const;

  template <class N>
  Vector<N> position(std::size_t at) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter_[at];
    } else {
      return in_chart(lifts_.conformal_about<N>(label_, seen_[at]));
    }
  }
  template <class N>
  std::vector<Vector<N>> positions(const std::vector<std::size_t>& places) const {
    std::vector<Vector<N>> result;
    for (const std::size_t at : places) result.push_back(position<N>(at));
    return result;
  }

 private:
  template <class N>
  Vector<N> in_chart(const Vector<N>& a) const {
    return add(Vector<N>{}, logarithm_factor(c_.space_form->K, squared(a, c_.m_size()) / N(4)), a);
  }

  const Certificate& c_;
  const Lifts& lifts_;
  Label label_;
  std::vector<Seen> seen_;  // sorted by label
  std::vector<Vector<Interval>> filter_;
  std::vector<double> distance_;
};

/// A simplex of a chart with its circumcentre: predicates on it are decided by enclosures.
class ChartSimplex {
 public:
  ChartSimplex(const Certificate& c, const Chart& chart, std::vector<std::size_t> vertices)
      : c_(c), chart_(chart), vertices_(std::move(vertices)), filter_(c.metric, chart.positions<Interval>(vertices_)) {}

  const std::vector<std::size_t>& vertices() const { return vertices_; }
  const Simplex<Interval>& filter() const { return filter_; }
  bool is_vertex(std::size_t at) const { return std::find(vertices_.begin(), vertices_.end(), at) != vertices_.end(); }

  /// The predicate takes a Simplex<N> and returns a Verdict; undecided while it is not known that the simplex is not
  /// degenerate.
  template <class Predicate>
  bool decide(const Predicate& predicate) const {
    return decide_enclosed([&]<class N>(In<N>) {
      const auto decided = [&](const Simplex<N>& simplex) {
        return simplex.complete == Verdict::proved ? predicate(simplex) : Verdict::undecided;
      };
      if constexpr (std::is_same_v<N, Interval>) {
        return decided(filter_);
      } else {
        return decided(Simplex<N>(c_.metric, chart_.positions<N>(vertices_)));
      }
    });
  }

 private:
  const Certificate& c_;
  const Chart& chart_;
  std::vector<std::size_t> vertices_;
  Simplex<Interval> filter_;
};

}  // namespace delcert::checker
