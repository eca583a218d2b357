#include "proofs/checker/space_forms/lifts.hpp"

#include <algorithm>

#include "proofs/checker/parts/chunk_items.hpp"

namespace delcert::checker {

Lifts::Lifts(const Certificate& c, core::Complex& complex, bool is_delaunay)
    : c_(c), complex_(complex), form_(complex.data), is_delaunay_(is_delaunay), met_(complex.size()) {
  const int K = c.space_form->K;
  Interval perturbation(0), chord(0);
  for (Label i = 0; i < c.n; ++i) {
    const Vector<Interval> v = c.points.position<Interval>({i, {}});
    perturbation = maximum(perturbation, K == 0 ? form_.squared(v) : squared(v, c.m_size()));
    for (std::size_t at = 0; !is_delaunay && at < complex.neighbours.size(i); ++at) {
      const auto& [j, phi] = complex.neighbours.of(i)[at];
      chord = maximum(chord, form_.squared(point<Interval>({j, phi}) - complex.point<Interval>(i)));
    }
  }
  if (K > 0 && !(chord.upper() < 2)) throw Undecided("an edge is as long as a quarter of a great circle");
  room_ = (Interval(2) * square_root(perturbation) + square_root(unrolled(K, chord))).upper();
}

bool Lifts::is_new(const Seen& seen) {
  Met& met = met_[seen.label];
  if (met.walk != walks_) {
    met = {walks_, seen.element};
    return true;
  }
  if (met.element == seen.element) return false;
  const auto same = [&](const Seen& s) { return s.label == seen.label && s.element == seen.element; };
  if (std::any_of(met_again_.begin(), met_again_.end(), same)) return false;
  met_again_.push_back(seen);
  return true;
}

template <class F>
void Lifts::walk(std::vector<Seen> front, const F& go_on) {
  ++walks_;
  met_again_.clear();
  for (const Seen& start : front) is_new(start);
  while (!front.empty()) {
    const Seen from = front.back();
    front.pop_back();
    require_star(from.label);
    for (std::size_t at = 0; at < complex_.neighbours.size(from.label); ++at) {
      Budget::spend(20);
      const auto& [label, phi] = complex_.neighbours.of(from.label)[at];
      const Seen next{label, complex_.elements.product(from.element, phi)};
      if (is_new(next) && go_on(next)) front.push_back(next);
    }
  }
}

Lifts::Reach Lifts::squared_chords(const Rational& radius) const {
  const int K = c_.space_form->K;
  const double far = (enclosure(radius) + Interval::between(0, room_)).upper();
  if (K > 0 && !(far < 1.57)) throw Undecided("a walk would leave a half-sphere");
  Reach result{radius, 0, 0};
  in_balls(64, [&] {
    Ball length;
    arb_set_d(length.raw(), far);
    result.near = (Ball(2) * versed_sine(K, Ball(radius))).enclosure().upper();
    result.far = (Ball(2) * versed_sine(K, length)).enclosure().upper();
  });
  return result;
}

/// The walk starts at p'_i, and goes on from all points within radius + room of p_i.
std::vector<Seen> Lifts::around(Label i, const Rational& radius) {
  if (!reach_ || !(reach_->radius == radius)) reach_ = squared_chords(radius);
  const Vector<Interval> centre = net_point<Interval>({i, 0});
  std::vector<Seen> result;
  const auto go_on = [&](const Seen& seen) {
    const double distance = form_.squared(point<Interval>(seen) - centre).lower();
    if (distance <= reach_->near) result.push_back(seen);
    return distance <= reach_->far;
  };
  go_on({i, 0});
  walk({{i, 0}}, go_on);
  std::sort(result.begin(), result.end(),
            [](const Seen& a, const Seen& b) { return std::tie(a.label, a.element) < std::tie(b.label, b.element); });
  return result;
}

std::vector<Lifts::Near> Lifts::around_circumcentre(const Vector<Interval>& centre, const std::vector<Seen>& vertices,
                                                    double squared) {
  std::vector<Near> result;
  walk(vertices, [&](const Seen& seen) {
    const double chord_squared = form_.squared(point<Interval>(seen) - centre).lower();
    if (!(chord_squared <= squared)) return false;
    result.push_back({seen, chord_squared});
    return true;
  });
  return result;
}

}  // namespace delcert::checker
