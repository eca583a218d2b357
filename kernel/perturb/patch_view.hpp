#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/chart/atlas.hpp"

namespace delcert {

/// A set of positions in a patch view, as bits.
using BitRow = std::vector<std::uint64_t>;

/// The points of a set as one chart sees them, and which pairs of them may be close.
template <int m>
class PatchView {
 public:
  /// Empty, in the chart of label 0.
  PatchView(const Atlas<m>& atlas, const PointSet<m>& points) : atlas_(&atlas), points_(&points) {}

  /// Empty again, in the chart of this label.
  void clear(Label chart) {
    chart_ = chart;
    seen_.clear();
    position_.clear();
    adjacency_.clear();
  }
  /// Precondition: a `FilterGuard` is alive.
  void add(const Sighting<m>& sighting) {
    add(sighting, atlas_->carry(chart_, sighting, points_->enclosure(label_of<m>(sighting))));
  }
  /// The same where the position is known already: what `Atlas::carry` returns.
  void add(const Sighting<m>& sighting, const Vector<Filter, m>& position) {
    seen_.push_back(sighting);
    position_.push_back(position);
  }

  /// Marks as adjacent all pairs but those certainly at squared distance ≥ the bound; without a bound all pairs.
  void connect(const MetricOn<Filter, m>& metric, const Filter* squared_bound) {
    if (squared_bound == nullptr) {
      connect_pairs([](std::size_t, std::size_t) { return true; });
    } else {
      connect(metric, *squared_bound, [](std::size_t, std::size_t) { return Verdict::undecided; });
    }
  }
  /// The same where `is_below(a, b)` is sure about most pairs of positions.
  template <class IsBelow>
  void connect(const MetricOn<Filter, m>& metric, const Filter& squared_bound, const IsBelow& is_below) {
    connect_pairs([&](std::size_t a, std::size_t b) {
      const Verdict known = is_below(a, b);
      if (!is_undecided(known)) return is_proved(known);
      return !is_refuted(less(metric.squared_norm(difference(position_[b], position_[a])), squared_bound));
    });
  }

  [[nodiscard]] std::size_t size() const { return seen_.size(); }
  [[nodiscard]] Label chart() const { return chart_; }
  [[nodiscard]] std::size_t words() const { return words_; }
  [[nodiscard]] const Sighting<m>& sighting(std::size_t at) const { return seen_[at]; }
  [[nodiscard]] Label label(std::size_t at) const { return label_of<m>(seen_[at]); }
  /// The adjacent positions after this one.
  [[nodiscard]] std::span<const std::uint64_t> later_neighbours(std::size_t at) const {
    return {adjacency_.data() + at * words_, words_};
  }

  [[nodiscard]] const Vector<Filter, m>& position(std::size_t at) const { return position_[at]; }
  /// An enclosure; on the last rung exact, or where the family has no exact transitions the middle of the filter's
  /// enclosure: good enough to choose by, and nothing may rest on it.
  template <class S>
  [[nodiscard]] Vector<S, m> position_in(std::size_t at) const {
    if constexpr (std::same_as<S, Filter>) {
      return position_[at];
    } else {
      const auto carried = atlas_->carry(chart_, seen_[at], points_->template coordinates<S>(label_of<m>(seen_[at])));
      if constexpr (std::same_as<S, Rational>) {
        return carried ? *carried : middle_of(position_[at]);
      } else {
        return carried;
      }
    }
  }

 private:
  template <class Are>
  void connect_pairs(const Are& are_adjacent) {
    words_ = (size() + 63) / 64;
    adjacency_.assign(size() * words_, 0);
    for (std::size_t a = 0; a < size(); ++a) {
      for (std::size_t word = (a + 1) / 64; word < words_; ++word) {
        // No processor predicts which are adjacent.
        std::uint64_t bits = 0;
        const std::size_t last = std::min(size(), 64 * word + 64);
        for (std::size_t b = std::max(a + 1, 64 * word); b < last; ++b) {
          bits |= static_cast<std::uint64_t>(are_adjacent(a, b)) << (b % 64);
        }
        adjacency_[a * words_ + word] = bits;
      }
    }
  }

  static Vector<Rational, m> middle_of(const Vector<Filter, m>& enclosure) {
    Vector<Rational, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) {
      result[axis] = (Rational::exactly(enclosure[axis].lower()) + Rational::exactly(enclosure[axis].upper())) *
                     Rational::power_of_two(-1);
    }
    return result;
  }

  const Atlas<m>* atlas_;
  const PointSet<m>* points_;
  Label chart_{0};
  std::vector<Sighting<m>> seen_;
  std::vector<Vector<Filter, m>> position_;
  BitRow adjacency_;
  std::size_t words_ = 0;
};

}  // namespace delcert
