#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/checker/core/all_charts.hpp"
#include "proofs/checker/parts/shared_array.hpp"
#include "proofs/checker/report/report.hpp"
#include "proofs/checker/space_forms/lifts.hpp"
#include "proofs/checker/space_forms/straight_simplex.hpp"

namespace delcert::checker {

/// The chart of one label after the other, and which lifts are where in it.
class OpenChart {
 public:
  OpenChart(const Certificate& c, core::Complex& complex, Lifts& lifts)
      : c_(c), complex_(complex), lifts_(lifts), charts_(c), slots_(complex.size()) {}

  void open(Label i);
  Label label() const { return label_; }
  const SpaceFormCharts<Interval>& charts() const { return charts_; }
  /// Where a point in the coordinates of the core is.
  Vector<Interval> place(const Vector<Interval>& x) const { return charts_.place(base_, x); }
  template <class N>
  Vector<N> place(const Seen& seen) {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter(seen);
    } else {
      const SpaceFormCharts<N> charts(c_);
      return charts.place(charts.base(label_), lifts_.point<N>(seen));
    }
  }
  template <class N>
  core::Lifts<N> places(const std::vector<Seen>& of) {
    core::Lifts<N> result{};
    for (std::size_t k = 0; k < of.size(); ++k) result[k] = place<N>(of[k]);
    return result;
  }

 private:
  const Vector<Interval>& filter(const Seen& seen);

  const Certificate& c_;
  core::Complex& complex_;
  Lifts& lifts_;
  const SpaceFormCharts<Interval> charts_;
  Label label_ = 0;
  SpaceFormCharts<Interval>::Base base_;
  struct Slot {
    std::uint32_t chart = 0;
    core::Elements::Id element = 0;
    std::uint32_t at = 0;
  };
  std::uint32_t opened_ = 0;
  std::vector<Slot> slots_;  // of each label, where it was seen last
  std::vector<Vector<Interval>> filter_;
};

/// Levels 1 and 2s of space forms in the charts of the labels; of level 1 the rules that are not the core's. A simplex
/// is looked at in a chart only if what is known of it in all charts does not suffice, and is compared with the lifts
/// near it only (docs/levels/space-forms.md, In all charts, Near a simplex).
class SpaceFormStars {
 public:
  /// Keeps references. Precondition: as Lifts.
  SpaceFormStars(const Certificate& c, core::Complex& complex, Lifts& lifts)
      : c_(c),
        complex_(complex),
        lifts_(lifts),
        chart_(c, complex, lifts),
        in_space_(complex),
        found_(complex.data.simplices()),
        known_(complex.data.simplices()) {}

  /// As the functions of run.hpp.
  std::string check_stars(Report& report);
  std::string check_stable_stars(Report& report);

 private:
  /// How far a level looks, and by how much its balls are enlarged.
  struct View {
    Quantity reach, margin;
    double stretch = 1;  // the square of the greatest chord in the space, divided by that of its length in a chart
    double most = 0;     // greatest square of a chord that is looked for
    AllCharts all;
  };
  /// A simplex, straight in the open chart, where the element takes it.
  struct Shown {
    std::size_t number = 0;
    core::Elements::Id element = 0;
    std::vector<Seen> vertices;
    std::optional<StraightSimplex<Interval>> filter;
  };
  /// What is known of the lifts near a simplex, with its first vertex at the lift of the identity.
  struct Known {
    double covered = 0;             // all lifts whose chords from the centre have squares up to this are known,
    std::vector<Lifts::Near> near;  // besides the vertices
  };

  /// A simplex in charts one after the other: that of which label was the last, and within what charts need not be
  /// looked at.
  struct Met {
    Label label;
    double within = -1;
  };

  View view(const Quantity& reach, const Quantity& margin) const;
  /// Precondition: the complex is Delaunay.
  const SimplexInSpace& in_space(std::size_t s) {
    return found_.of(s, [&] { return in_space_.of(static_cast<std::uint32_t>(s)); });
  }
  /// Whether all rules of level 1 hold for the simplex in the charts of its vertices, by what is known of it in all
  /// charts.
  bool is_thick_and_protected(std::size_t s, const View& view);
  /// How far from the circumcentre of the simplex, as the square of a chord, charts can be centred in which the rules
  /// of level 2s hold by what is known of it in all charts.
  double protected_within(std::size_t s, const View& view);
  std::string fault_of_reach(const char* name, const Rational& reach) const;
  Shown shown(std::size_t s, core::Elements::Id g);
  /// The label of a vertex that the chart does not show, if there is one.
  std::optional<Label> missing(const Shown& simplex, const View& view);
  /// The predicate takes a StraightSimplex<N> and returns a Verdict.
  template <class Predicate>
  bool holds(const Shown& simplex, const Predicate& predicate);
  /// All lifts that the open chart shows in the ball of the simplex, enlarged by the margin, and perhaps others.
  const std::vector<Seen>& near(const Shown& simplex, const View& view);
  /// The square of the greatest chord from the circumcentre to a point in the enlarged ball; infinite if that is not
  /// known.
  double reach_of(const Shown& simplex, const View& view);

  void open_chart(Label i);
  std::uint64_t check_star(Label i, const View& view, const Quantity& shift, Report& report);
  void check_stable_star(Label j, const View& view, std::vector<Met>& met, Report& report);
  void check_simplex(std::size_t s, std::size_t k, const View& view, Report& report);
  void check_stable_simplex(std::size_t s, core::Elements::Id g, Label centre, const View& view, Report& report);
  template <class Which>
  void check_protection(const Shown& simplex, const View& view, const char* rule, const Which& which, Report& report);
  bool is_within(const Vector<Interval>& x, const Vector<Interval>& y, double squared_chord) const;
  std::string name(std::size_t s, Label i) const;

  const Certificate& c_;
  core::Complex& complex_;
  Lifts& lifts_;
  OpenChart chart_;
  SimplicesInSpace in_space_;
  SharedFindings<SimplexInSpace> found_;  // level 2s asks for what was found for level 1
  std::vector<Known> known_;
  std::vector<Seen> near_;
  std::optional<std::vector<Seen>> all_;  // that the open chart shows
};

}  // namespace delcert::checker
