#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "proofs/checker/arithmetic/ball.hpp"
#include "proofs/checker/certificate/certificate.hpp"

namespace delcert::checker {

/// The perturbed points that a chart shows within a radius, perhaps some that are a little farther, sorted by label.
/// E, Rational or Ball, is the arithmetic that decides where intervals do not.
template <class E>
class ShownPoints {
 public:
  explicit ShownPoints(std::size_t m) : m_(m) {}

  void add(Label label, const Vector<Interval>& x) {
    labels_.push_back(label);
    filter_.push_back(x);
    distance_.push_back(square_root(dot(x, x, m_)).lower());
  }
  /// Where the point at a place of the list is, in E.
  std::function<Vector<E>(std::size_t)> exact;

  std::size_t size() const { return labels_.size(); }
  Label label(std::size_t at) const { return labels_[at]; }
  /// A lower bound of the distance from the origin of the chart.
  double distance(std::size_t at) const { return distance_[at]; }
  template <class N>
  Vector<N> position(std::size_t at) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter_[at];
    } else {
      return exact(at);
    }
  }
  template <class N>
  std::vector<Vector<N>> positions(const std::vector<std::size_t>& places) const {
    std::vector<Vector<N>> result;
    for (const std::size_t at : places) result.push_back(position<N>(at));
    return result;
  }
  /// The places of the label and of m others; empty if one is missing, which is then in `missing`. Throws Undecided if
  /// a label may be there twice.
  std::vector<std::size_t> find(Label first, const Label* others, Label& missing) const {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k <= m_; ++k) {
      missing = k == 0 ? first : others[k - 1];
      const auto [begin, end] = std::equal_range(labels_.begin(), labels_.end(), missing);
      if (end - begin > 1)
        throw Undecided("label " + std::to_string(missing) + " may have two lifts in reach of one chart");
      if (begin == end) return {};
      places.push_back(static_cast<std::size_t>(begin - labels_.begin()));
    }
    return places;
  }

 private:
  std::size_t m_;
  std::vector<Label> labels_;
  std::vector<Vector<Interval>> filter_;
  std::vector<double> distance_;
};

/// What levels 1 and 2s ask of the charts of a family.
template <class E>
class StarCharts {
 public:
  explicit StarCharts(const Certificate& c) : c_(c) {}
  virtual ~StarCharts() = default;
  StarCharts(const StarCharts&) = delete;
  StarCharts& operator=(const StarCharts&) = delete;

  const Certificate& certificate() const { return c_; }
  virtual ShownPoints<E> shown(Label i, const Quantity& radius) const = 0;
  /// What a perturbed point is moved by in its own chart.
  virtual Vector<Interval> home(Label i, In<Interval>) const = 0;
  virtual Vector<E> home(Label i, In<E>) const = 0;
  /// Why charts do not show all that the level looks at, or nothing.
  virtual std::string fault_of_patches(Level level) const = 0;

 protected:
  const Certificate& c_;
};

/// The rules of level 1 but those of the core, and of level 2s, in charts. As the functions of run.hpp.
template <class E>
std::string check_stars(const StarCharts<E>& charts, Report& report);
template <class E>
std::string check_stable_stars(const StarCharts<E>& charts, Report& report);

/// The rule is that each component has a label k of which is_clear(k, c.components()) holds.
template <class Predicate>
void require_clear_labels(const Certificate& c, const char* rule, const Predicate& is_clear, Report& report) {
  const std::vector<Label> component = c.components();
  std::vector<bool> found(c.n);
  for (Label k = 0; k < c.n; ++k) {
    if (!found[component[k]] && is_clear(k, component)) found[component[k]] = true;
  }
  for (Label k = 0; k < c.n; ++k) {
    if (found[component[k]]) continue;
    report.reject(
        rule, [&] { return "no label of the component of label " + std::to_string(k) + " is clear of the others"; });
    return;
  }
}

/// "simplex {3, 17, 90} in the star of 5".
std::string simplex_of_star(const Certificate& c, Label i, const Label* others);

}  // namespace delcert::checker
