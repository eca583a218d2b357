#include "proofs/checker/lifts.hpp"

#include <algorithm>

namespace delcert::checker {
namespace {

template <std::size_t size>
std::array<Interval, size> enclosures(const std::array<Ball, size>& x) {
  std::array<Interval, size> result;
  for (std::size_t k = 0; k < size; ++k) result[k] = x[k].enclosure();
  return result;
}

SquareMatrix<Interval> enclosures(const SquareMatrix<Ball>& a) {
  SquareMatrix<Interval> result(a.order());
  for (std::size_t i = 0; i < a.order(); ++i) {
    for (std::size_t k = 0; k < a.order(); ++k) result(i, k) = a(i, k).enclosure();
  }
  return result;
}

double middle(const Interval& x) { return x.lower() / 2 + x.upper() / 2; }

}  // namespace

Lifts::Lifts(const Certificate& c, const Group& group, const Rational& reach, const Rational& spread)
    : c_(c), group_(group), width_(0), frame_(c.m_size()) {
  const std::size_t m = c.m_size();
  double farthest = 0;  // x_0 or the squared length of lifts within spread + reach of o
  in_balls(160, [&] {
    const SquareMatrix<Ball> T = c.space_form->basis();
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < m; ++k) frame_(i, k) = T(i + 1, k + 1).enclosure();
    }
    for (const FieldMatrix& element : group.elements)
      elements_.push_back(enclosures(c.space_form->in_standard_basis(element)));
    const Ball far = Ball(spread) + Ball(reach);
    farthest = (K() < 0 ? Ball::apply(arb_cosh, far) : square(far)).enclosure().upper();
  });
  // Pictures are known to 2^-24, so that lifts within reach are in neighbouring cells.
  width_ = enclosure(reach).upper() + 0x1p-20;
  for (Label j = 0; j < c.n; ++j) {
    const Vector<Interval> x = in_balls(128, [&] { return enclosures(position(j)); });
    for (std::uint32_t element = 0; element < elements_.size(); ++element) {
      const Vector<Interval> y = elements_[element] * x;
      const bool far = K() < 0    ? y[0].lower() > farthest
                       : K() == 0 ? squared(Vector<Interval>{y[1], y[2], y[3]}, m).lower() > farthest
                                  : false;
      if (!far) stored_.push_back({cell_of(y), j, element, y});
    }
  }
  for (Label i = 0; i < c.n; ++i) centres_.push_back(centre<Interval>(i));
  std::sort(stored_.begin(), stored_.end(), [](const Stored& a, const Stored& b) {
    return std::tie(a.cell, a.label, a.element) < std::tie(b.cell, b.label, b.element);
  });
}

Vector<Ball> Lifts::position(Label j) const {
  Vector<Ball> opposite = centre<Ball>(j);
  for (Ball& x : opposite) x = -x;
  return seen_from(K(), c_.m_size(), opposite, exponential(K(), c_.m_size(), vector_of<Ball>(j)));
}

Vector<Ball> Lifts::moved(const Seen& seen, const Vector<Ball>& x) const {
  return c_.space_form->in_standard_basis(group_.elements[seen.element]) * x;
}

/// The chord on a sphere; the conformal coordinates of a hyperbolic space, |da| <= ds.
std::array<double, 4> Lifts::picture(const Vector<Interval>& x) const {
  const Vector<Interval> at = K() > 0 ? x : conformal(c_.m_size(), x);
  std::array<double, 4> result{};
  for (std::size_t k = 0; k < c_.m_size() + (K() > 0 ? 1 : 0); ++k) {
    if (!(at[k].upper() - at[k].lower() < 0x1p-24)) throw Undecided("a point is not known well enough");
    result[k] = middle(at[k]);
  }
  return result;
}

Lifts::Cell Lifts::cell_of(const Vector<Interval>& x) const {
  Cell cell{};
  const std::array<double, 4> at = picture(x);
  for (std::size_t k = 0; k < 4; ++k) {
    const double place = std::floor(at[k] / width_);
    if (!(std::fabs(place) < 0x1p30)) throw Undecided("a point is too far away");
    cell[k] = static_cast<std::int32_t>(place);
  }
  return cell;
}

std::vector<Seen> Lifts::around(Label i, const Rational& radius) const {
  const std::size_t m = c_.m_size();
  const double bound =
      in_balls(64, [&] { return square(Ball(2) * tangent(K(), Ball(radius) / Ball(2))).enclosure().upper(); });
  const Cell at = cell_of(linear(K(), m, centres_[i]));
  std::vector<Seen> result;
  const std::size_t axes = m + (K() > 0 ? 1 : 0);
  std::size_t number = 1;
  for (std::size_t k = 0; k + 1 < axes; ++k) number *= 3;
  for (std::size_t row = 0; row < number; ++row) {
    // Cells that differ along the last axis only follow one another.
    Cell first = at;
    std::size_t rest = row;
    for (std::size_t k = 0; k + 1 < axes; ++k, rest /= 3) first[k] += static_cast<std::int32_t>(rest % 3) - 1;
    Cell last = first;
    --first[axes - 1];
    ++last[axes - 1];
    auto place = std::lower_bound(stored_.begin(), stored_.end(), first,
                                  [](const Stored& a, const Cell& cell) { return a.cell < cell; });
    for (; place != stored_.end() && place->cell <= last; ++place) {
      const Vector<Interval> x = seen_from(K(), m, centres_[i], place->x);
      if (K() > 0 && x[0].upper() < 0) continue;  // farther than pi/2
      const Vector<Interval> a = conformal(m, x);
      if (squared(a, m).lower() <= bound) result.push_back({place->label, place->element, a});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Seen& a, const Seen& b) { return std::tie(a.label, a.element) < std::tie(b.label, b.element); });
  return result;
}

}  // namespace delcert::checker
