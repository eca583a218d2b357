#include "proofs/checker/lifts.hpp"

#include <algorithm>
#include <unordered_set>

#include "proofs/checker/core/circumball.hpp"

namespace delcert::checker {
namespace {

/// 1 - cos d, d^2 / 2, cosh d - 1 for the distance d from o of a point of the linear model.
Interval fall(int K, std::size_t m, const Vector<Interval>& x) {
  if (K != 0) return Interval(K) * (Interval(1) - x[0]);
  return squared(Vector<Interval>{x[1], x[2], x[3]}, m) / Interval(2);
}

}  // namespace

Lifts::Lifts(const Certificate& c, core::Complex& complex, bool is_delaunay)
    : c_(c), complex_(complex), frame_(c.m_size()) {
  in_balls(160, [&] {
    const SquareMatrix<Ball> T = c.space_form->basis();
    for (std::size_t i = 0; i < m(); ++i) {
      for (std::size_t k = 0; k < m(); ++k) frame_(i, k) = T(i + 1, k + 1).enclosure();
    }
  });
  const core::Form<Interval> form(complex.data);
  Interval perturbation(0), chord(0);
  for (Label i = 0; i < c.n; ++i) {
    perturbation = maximum(perturbation, squared(vector_of<Interval>(i), m()));
    for (std::size_t at = 0; !is_delaunay && at < complex.neighbours.size(i); ++at) {
      const auto& [j, phi] = complex.neighbours.of(i)[at];
      const Vector<Interval> end = complex.elements.moved(phi, complex.point<Interval>(j));
      chord = maximum(chord, form.squared(end - complex.point<Interval>(i)));
    }
  }
  if (K() > 0 && !(chord.upper() < 2)) throw Undecided("an edge is as long as a quarter of a great circle");
  room_ = (Interval(2) * square_root(perturbation) + square_root(unrolled(K(), chord))).upper();
}

/// The walk starts at p'_i, and goes on from all points within radius + room of p_i.
std::vector<Seen> Lifts::around(Label i, const Rational& radius) const {
  const double reach = (enclosure(radius) + Interval::between(0, room_)).upper();
  if (K() > 0 && !(reach < 1.57)) throw Undecided("a walk would leave a half-sphere");
  double near = 0, far = 0;
  in_balls(64, [&] {
    Ball length;
    arb_set_d(length.raw(), reach);
    near = versed_sine(K(), Ball(radius)).enclosure().upper();
    far = versed_sine(K(), length).enclosure().upper();
  });
  struct Place {
    Label label;
    core::Elements::Id element;
  };
  std::vector<Seen> result;
  std::vector<Place> front;
  std::unordered_set<std::uint64_t> met;
  const auto meet = [&](const Place& place) {
    if (!met.insert(std::uint64_t{place.label} << 32 | place.element).second) return;
    const Vector<Interval> x = about(i, place.element, complex_.point<Interval>(place.label));
    const double distance = fall(K(), m(), x).lower();
    if (distance <= near) result.push_back({place.label, place.element, conformal(m(), x)});
    if (distance <= far) front.push_back(place);
  };
  meet({i, 0});
  while (!front.empty()) {
    const Place from = front.back();
    front.pop_back();
    for (std::size_t at = 0; at < complex_.neighbours.size(from.label); ++at) {
      Budget::spend(20);
      const auto& [label, phi] = complex_.neighbours.of(from.label)[at];
      meet({label, complex_.elements.product(from.element, phi)});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Seen& a, const Seen& b) { return std::tie(a.label, a.element) < std::tie(b.label, b.element); });
  return result;
}

}  // namespace delcert::checker
