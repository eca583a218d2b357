#include "proofs/checker/space_forms/space_form_stars.hpp"

#include <algorithm>
#include <limits>

#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {
void OpenChart::open(Label i) {
  label_ = i;
  base_ = charts_.base(i);
  filter_.clear();
  ++opened_;
}

const Vector<Interval>& OpenChart::filter(const Seen& seen) {
  Slot& slot = slots_[seen.label];
  if (slot.chart != opened_ || slot.element != seen.element) {
    slot = {opened_, seen.element, static_cast<std::uint32_t>(filter_.size())};
    filter_.push_back(place(lifts_.point<Interval>(seen)));
  }
  return filter_[slot.at];
}

void SpaceFormStars::open_chart(Label i) {
  chart_.open(i);
  all_.reset();
}

SpaceFormStars::View SpaceFormStars::view(const Quantity& reach, const Quantity& margin) const {
  const int K = c_.space_form->K;
  View result{reach, margin, 1, 0, AllCharts(K, c_.m_size(), reach)};
  if (K < 0) {
    const Interval ratio = in_balls(128, [&] { return (sine(K, Ball(reach.exact)) / Ball(reach.exact)).enclosure(); });
    result.stretch = square(ratio).upper();
  }
  result.most = (Interval::between(0, result.stretch) * square(reach.filter)).upper();
  if (K > 0) result.most = std::min(result.most, 1.99);  // less than a quarter of a great circle
  return result;
}

/// A chart shows one lift of a label at most within 9 epsilon and the injectivity radius.
std::string SpaceFormStars::fault_of_reach(const char* name, const Rational& reach) const {
  if (less(reach, Rational(9) * c_.epsilon.exact) == Verdict::proved &&
      less(reach, c_.space_form->injectivity_radius.exact) == Verdict::proved)
    return "";
  return std::string(name) + " is not below 9 epsilon and the injectivity radius";
}

SpaceFormStars::Shown SpaceFormStars::shown(std::size_t s, core::Elements::Id g) {
  Shown result;
  result.number = s;
  result.element = g;
  for (std::size_t k = 0; k < complex_.vertices(); ++k)
    result.vertices.push_back({complex_.label(s, k), complex_.elements.product(g, complex_.element(s, k))});
  result.filter.emplace(c_.m_size(), chart_.places<Interval>(result.vertices));
  return result;
}

std::optional<Label> SpaceFormStars::missing(const Shown& simplex, const View& view) {
  for (const Seen& vertex : simplex.vertices) {
    if (squared(chart_.place<Interval>(vertex), c_.m_size()).lower() > square(view.reach.filter).upper())
      return vertex.label;
  }
  return {};
}

template <class Predicate>
bool SpaceFormStars::holds(const Shown& simplex, const Predicate& predicate) {
  return decide_enclosed([&]<class N>(In<N>) {
    if constexpr (std::is_same_v<N, Interval>) {
      return predicate(*simplex.filter);
    } else {
      return predicate(StraightSimplex<N>(c_.m_size(), chart_.places<N>(simplex.vertices)));
    }
  });
}

/// The reach is that of 1.vertices, so a radius within the bound says that the charts show what they have to.
bool SpaceFormStars::is_thick_and_protected(std::size_t s, const View& view) {
  return lifts_.are_delaunay() && view.all.fits(in_space(s), c_.circumradius, c_.thickness, view.margin);
}

double SpaceFormStars::protected_within(std::size_t s, const View& view) {
  if (!lifts_.are_delaunay()) return -1;
  const AllCharts::Bounds bounds = view.all.bounds(in_space(s));
  if (!bounds.known || !(bounds.radius < bounds.nearest)) return -1;
  const Interval room = view.reach.filter - Interval::between(bounds.radius, bounds.radius) -
                        Interval::between(bounds.centre, bounds.centre);
  return room.lower() > 0 ? view.all.squared_chord(room.lower()) : -1;
}

double SpaceFormStars::reach_of(const Shown& simplex, const View& view) {
  const Vector<Interval> centre =
      chart_.place(complex_.elements.moved(simplex.element, in_space(simplex.number).centre));
  if (!(squared(centre, c_.m_size()).upper() <= square(view.reach.filter).lower()))
    return std::numeric_limits<double>::infinity();
  const double length = upper_root(squared(centre - simplex.filter->centre(), c_.m_size())) +
                        upper_root(simplex.filter->radius_squared()) + view.margin.filter.upper();
  return length * length * view.stretch;
}

const std::vector<Seen>& SpaceFormStars::near(const Shown& simplex, const View& view) {
  const double reach = lifts_.are_delaunay() ? reach_of(simplex, view) : std::numeric_limits<double>::infinity();
  if (!(reach <= view.most)) {
    if (!all_) all_ = lifts_.around(chart_.label(), view.reach.exact);
    return *all_;
  }
  Known& known = known_[simplex.number];
  if (!(reach <= known.covered)) {
    constexpr double more = 1 + 0x1p-6;  // other charts ask for about as much
    std::vector<Seen> vertices;
    for (std::size_t k = 0; k < complex_.vertices(); ++k)
      vertices.push_back({complex_.label(simplex.number, k), complex_.element(simplex.number, k)});
    known.covered = std::min(more * reach, view.most);
    known.near = lifts_.around_circumcentre(in_space(simplex.number).centre, vertices, known.covered);
  }
  near_.clear();
  for (const auto& [seen, chord_squared] : known.near) {
    if (chord_squared <= reach) near_.push_back({seen.label, complex_.elements.product(simplex.element, seen.element)});
  }
  return near_;
}

template <class Which>
void SpaceFormStars::check_protection(const Shown& simplex, const View& view, const char* rule, const Which& which,
                                      Report& report) {
  for (const Seen& q : near(simplex, view)) {
    const auto same = [&](const Seen& v) { return v.label == q.label && v.element == q.element; };
    if (std::any_of(simplex.vertices.begin(), simplex.vertices.end(), same)) continue;
    const bool clear = holds(simplex, [&]<class N>(const StraightSimplex<N>& t) {
      return t.is_clear(chart_.place<N>(q), view.margin.as<N>());
    });
    if (clear) continue;
    report.reject(rule, [&] {
      return which() + " has label " + name_of(q.label) + " within circumradius + " + rounded_up(view.margin.exact) +
             " of its circumcentre";
    });
  }
}

std::string SpaceFormStars::name(std::size_t s, Label i) const {
  std::vector<Label> others;
  for (std::size_t k = 0; k < complex_.vertices(); ++k) {
    if (complex_.label(s, k) != i) others.push_back(complex_.label(s, k));
  }
  return "simplex " + label_set(others.data(), others.data() + others.size()) + " in the star of " + name_of(i);
}

/// In the chart of its k-th vertex.
void SpaceFormStars::check_simplex(std::size_t s, std::size_t k, const View& view, Report& report) {
  if (is_decided(is_thick_and_protected(s, view))) return;
  const Shown simplex = shown(s, complex_.elements.inverse(complex_.element(s, k)));
  const auto which = [&] { return name(s, complex_.label(s, k)); };
  if (const auto label = missing(simplex, view)) {
    return report.reject("1.vertices", [&] { return which() + ": its chart does not show " + name_of(*label); });
  }
  const auto small = [&]<class N>(const StraightSimplex<N>& t) {
    return less_equal(t.radius_squared(), square(c_.circumradius.as<N>()));
  };
  if (!holds(simplex, small)) {
    report.reject("1.radius", [&] {
      return which() + " has a squared circumradius of about " + about(simplex.filter->radius_squared());
    });
  }
  const auto thick = [&]<class N>(const StraightSimplex<N>& t) { return t.is_thick(c_.thickness.as<N>()); };
  if (!holds(simplex, thick))
    report.reject("1.thickness", [&] { return which() + " is thinner than " + rounded_up(c_.thickness.exact); });
  check_protection(simplex, view, "1.protection", which, report);
}

/// `centre`: one of its labels, to whose star it belongs.
void SpaceFormStars::check_stable_simplex(std::size_t s, core::Elements::Id g, Label centre, const View& view,
                                          Report& report) {
  const Shown simplex = shown(s, g);
  const auto which = [&] { return name(s, centre) + ", in the chart of " + name_of(chart_.label()) + ","; };
  if (const auto label = missing(simplex, view))
    return report.reject("2s.reach", [&] { return which() + " has no label " + name_of(*label); });
  const auto within = [&]<class N>(const StraightSimplex<N>& t) {
    return is_ball_within(squared(t.centre(), c_.m_size()), t.radius_squared(), view.reach.as<N>());
  };
  if (!holds(simplex, within)) report.reject("2s.reach", [&] { return which() + " has a ball beyond reach"; });
  check_protection(simplex, view, "2s.protection", which, report);
}

bool SpaceFormStars::is_within(const Vector<Interval>& x, const Vector<Interval>& y, double squared_chord) const {
  return lifts_.form<Interval>().squared(x - y).upper() <= squared_chord;
}

/// How many simplices it looks at.
std::uint64_t SpaceFormStars::check_star(Label i, const View& view, const Quantity& shift, Report& report) {
  const bool near = decide_enclosed([&]<class N>(In<N>) {
    const Vector<N> home = [&] {
      if constexpr (std::is_same_v<N, Interval>) {
        return chart_.charts().home(i);
      } else {
        return SpaceFormCharts<N>(c_).home(i);
      }
    }();
    return less_equal(squared(home, c_.m_size()), square(shift.as<N>()));
  });
  if (!near) {
    report.reject("1.perturbation",
                  [&] { return "label " + name_of(i) + " is moved by more than perturbation epsilon"; });
  }
  open_chart(i);
  std::uint64_t simplices = 0;
  for (std::size_t at = 0; at < complex_.star.size(i); ++at) {
    const auto [s, k] = complex_.star.of(i)[at];
    if (c_.space_form->K == 0 && k != 0) continue;  // one chart speaks for all
    ++simplices;
    check_simplex(s, k, view, report);
  }
  return simplices;
}

/// In the chart of j, the stars of all its neighbours, and so its own.
void SpaceFormStars::check_stable_star(Label j, const View& view, std::vector<Met>& met, Report& report) {
  open_chart(j);
  const Vector<Interval> home = lifts_.net_point<Interval>({j, 0});
  for (std::size_t at = 0; at < complex_.neighbours.size(j); ++at) {
    const auto [i, phi] = complex_.neighbours.of(j)[at];
    require_star(i);
    for (std::size_t in = 0; in < complex_.star.size(i); ++in) {
      const auto [s, k] = complex_.star.of(i)[in];
      if (met[s].label == j) continue;
      if (met[s].label == c_.n) met[s].within = protected_within(s, view);
      met[s].label = j;
      const core::Elements::Id g = complex_.elements.product(phi, complex_.elements.inverse(complex_.element(s, k)));
      const bool is_near =
          met[s].within > 0 && is_within(home, complex_.elements.moved(g, in_space(s).centre), met[s].within);
      if (!is_decided(is_near)) check_stable_simplex(s, g, i, view, report);
    }
  }
}

std::string SpaceFormStars::check_stars(Report& report) {
  const Quantity reach(c_.reach_1()), shift(c_.rho.exact * c_.epsilon.exact);
  const std::string fault = fault_of_reach("perturbation + 2 circumradius + protection", reach.exact);
  if (!fault.empty()) {
    report.reject("1.patch", [&] { return fault; });
    return "";
  }
  const View view = this->view(reach, c_.protection);
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    std::uint64_t simplices = 0;
    for (auto i = static_cast<Label>(begin); i < end; ++i) simplices += check_star(i, view, shift, found);
    return Counts{static_cast<std::int64_t>(simplices)};
  };
  in_parts("1.perturbation, 1.vertices, 1.radius, 1.thickness, 1.protection", Items::labels, c_.n, report, check,
           {"shown"});
  return "{shown} simplices in the charts of their vertices, protection >= " + rounded_down(c_.protection.exact) +
         ", thickness >= " + rounded_down(c_.thickness.exact) +
         ", circumradius <= " + rounded_up(c_.circumradius.exact);
}

std::string SpaceFormStars::check_stable_stars(Report& report) {
  const std::string fault = fault_of_reach("reach", c_.reach_2s.exact);
  if (!fault.empty()) {
    report.reject("2s.patch", [&] { return fault; });
    return "";
  }
  // By level 1, where the charts are isometric and see all of it (docs/levels/space-forms.md).
  const Rational enough = Rational(4) * c_.circumradius.exact + c_.rho.exact * c_.epsilon.exact;
  if (c_.space_form->K == 0 && less_equal(enough, c_.reach_2s.exact) == Verdict::proved)
    return "every chart of a star sees the same star, as it is isometric and shows 4 circumradii";
  const View view = this->view(c_.reach_2s, Quantity(Rational(0)));
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    std::vector<Met> met(complex_.data.simplices(), Met{c_.n});
    for (auto j = static_cast<Label>(begin); j < end; ++j) check_stable_star(j, view, met, found);
    return Counts{};
  };
  in_parts("2s.reach, 2s.protection", Items::labels, c_.n, report, check);
  return "every chart of a star sees the same star";
}

}  // namespace delcert::checker
