#include "proofs/checker/atlases/blend_volume.hpp"

#include <algorithm>
#include <map>

#include "proofs/checker/arithmetic/cofactors.hpp"
#include "proofs/checker/geometry/near_points.hpp"
#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_halvings_of_blend = 18;

/// A homogeneous polynomial in barycentric coordinates, by the exponents of its monomials.
using Form = std::map<std::array<int, 4>, Interval>;

Form product(const Form& a, const Form& b) {
  Form result;
  for (const auto& [exponents, x] : a) {
    for (const auto& [others, y] : b) {
      std::array<int, 4> all = exponents;
      for (std::size_t k = 0; k < all.size(); ++k) all[k] += others[k];
      const auto [at, is_new] = result.try_emplace(all, x * y);
      if (!is_new) at->second = at->second + x * y;
    }
  }
  return result;
}

/// Of the rows from this one on, and of these columns, as bits; rows first.
Form determinant(const std::vector<Form>& a, std::size_t m, std::size_t row, unsigned columns) {
  if (row == m) return {{{}, Interval(1)}};
  Form sum;
  bool even = true;
  for (std::size_t k = 0; k < m; ++k) {
    if ((columns >> k & 1U) == 0) continue;
    for (const auto& [exponents, x] : product(a[row * m + k], determinant(a, m, row + 1, columns & ~(1U << k)))) {
      Interval& all = sum[exponents];
      all = even ? all + x : all - x;
    }
    even = !even;
  }
  return sum;
}

/// Of all monomials with these exponents that a power of the sum of the coordinates has.
int multiplicity(const std::array<int, 4>& exponents) {
  int result = 1, degree = 0;
  for (const int exponent : exponents) {
    for (int k = 1; k <= exponent; ++k) result = result * ++degree / k;
  }
  return result;
}

class VolumeOfBlend {
 public:
  VolumeOfBlend(const SimplexOfTwoHomes& simplex, PassageValues& passage, const Interval& least)
      : simplex_(simplex), passage_(passage), least_(least), m_(simplex.here.size() - 1), gradient_(1, m_) {
    Matrix<Interval> here(m_, m_), there(m_, m_);
    for (std::size_t v = 1; v <= m_; ++v) {
      for (std::size_t k = 0; k < m_; ++k) {
        here(k, v - 1) = simplex.here[v][k] - simplex.here[0][k];
        there(k, v - 1) = simplex.there[v][k] - simplex.there[0][k];
      }
    }
    const Matrix<Interval> weights = inverse_by_cofactors(there);
    back_ = here * weights;
    for (std::size_t v = 1; v <= m_; ++v) {
      if (simplex.first[v] == simplex.first[0]) continue;
      for (std::size_t k = 0; k < m_; ++k)
        gradient_[k] = simplex.first[v] ? gradient_[k] + weights(v - 1, k) : gradient_[k] - weights(v - 1, k);
    }
  }

  bool holds() {
    Corners all(m_ + 1, std::vector<double>(m_ + 1));
    for (std::size_t v = 0; v <= m_; ++v) all[v][v] = 1;
    return holds_on(all, 0);
  }

 private:
  static Interval exactly(double x) { return Interval::between(x, x); }
  using Corners = std::vector<std::vector<double>>;  // of a part, their barycentric coordinates: exact

  Cell combined(const std::vector<double>& t, const std::vector<Cell>& x) const {
    Cell sum(m_, 1);
    for (std::size_t v = 0; v <= m_; ++v) sum = sum + exactly(t[v]) * x[v];
    return sum;
  }

  bool holds_on(const Corners& t, std::size_t halvings) {
    Budget::spend(20'000);
    std::vector<Cell> here;
    for (const std::vector<double>& corner : t) here.push_back(combined(corner, simplex_.here));
    if (is_enough_on(t, here)) return true;
    if (halvings == most_halvings_of_blend) return false;
    std::size_t from = 0, to = 1;
    double longest = 0;
    for (std::size_t k = 0; k <= m_; ++k) {
      for (std::size_t l = 0; l < k; ++l) {
        const double length = norm_above(here[k] - here[l]);
        if (!(length > longest)) continue;
        longest = length;
        from = l;
        to = k;
      }
    }
    for (const std::size_t replaced : {from, to}) {
      Corners half = t;
      for (std::size_t v = 0; v <= m_; ++v) half[replaced][v] = (t[from][v] + t[to][v]) / 2;
      if (!holds_on(half, halvings + 1)) return false;
    }
    return true;
  }

  /// By the coefficients in Bernstein's basis.
  bool is_enough_on(const Corners& t, const std::vector<Cell>& here) {
    Cell box = here[0];
    for (const Cell& x : here) {
      for (std::size_t k = 0; k < m_; ++k)
        box[k] = Interval::between(std::min(box[k].lower(), x[k].lower()), std::max(box[k].upper(), x[k].upper()));
    }
    if (!passage_.on(box).regular) return false;
    std::vector<Cell> missed;
    std::vector<Interval> share;
    for (std::size_t k = 0; k <= m_; ++k) {
      missed.push_back(missed_at(t[k], here[k]));
      double first = 0;  // of few digits
      for (std::size_t v = 0; v <= m_; ++v) first += simplex_.first[v] ? t[k][v] : 0;
      share.push_back(exactly(first));
    }
    const Cell centre = middle_of(box);
    const Matrix<Interval> mean = passage_.jacobian(centre);
    passage_.jacobian(box);
    // The second derivatives, and what they differ by from their middles: h has this rest.
    const auto second = [&](std::size_t row, std::size_t a, std::size_t b) { return passage_.second(row, a, b); };
    const auto middle = [](const Interval& x) {
      return exactly(std::clamp(NearPoints::middle(x), x.lower(), x.upper()));
    };
    Cell rest(m_, 1);
    for (std::size_t at = 0; at < m_ * m_ * m_; ++at) {
      const std::size_t row = at / m_ / m_, a = at / m_ % m_, b = at % m_;
      const Interval wide = exactly(box[a].upper()) - exactly(box[a].lower()),
                     high = exactly(box[b].upper()) - exactly(box[b].lower());
      const Interval off = (second(row, a, b) - middle(second(row, a, b))) * wide * high / Interval(8);
      const double most = std::max(off.upper(), -off.lower());
      rest[row] = rest[row] + Interval::between(-most, most);
    }
    std::vector<Matrix<Interval>> beyond;  // J M - 1 at the corners
    for (const Cell& x : here) {
      Matrix<Interval> derivative = mean;
      for (std::size_t at = 0; at < m_ * m_ * m_; ++at) {
        const std::size_t row = at / m_ / m_, a = at / m_ % m_, b = at % m_;
        derivative(row, a) = derivative(row, a) + second(row, a, b) * (x[b] - centre[b]);
      }
      beyond.push_back(Interval(-1) * one_less(derivative * back_));
    }
    const Interval half = Interval(1) / Interval(2);
    std::vector<Form> blend(m_ * m_);
    for (std::size_t k = 0; k <= m_; ++k) {
      for (std::size_t l = 0; l <= k; ++l) {
        Cell h = half * (missed[k] + missed[l]) + rest;
        const Cell edge = here[k] - here[l];
        for (std::size_t at = 0; k != l && at < m_ * m_ * m_; ++at) {
          const std::size_t row = at / m_ / m_, a = at / m_ % m_, b = at % m_;
          h[row] = h[row] - half * half * middle(second(row, a, b)) * edge[a] * edge[b];
        }
        const Matrix<Interval> control = half * (share[k] * beyond[l] + share[l] * beyond[k]) + h * gradient_;
        std::array<int, 4> exponents{};
        ++exponents[k];
        ++exponents[l];
        for (std::size_t at = 0; at < m_ * m_; ++at) {
          const Interval value = at % (m_ + 1) == 0 ? Interval(1) + control[at] : control[at];
          blend[at][exponents] = k == l ? value : Interval(2) * value;
        }
      }
    }
    const Form volume = determinant(blend, m_, 0, (1U << m_) - 1);
    return std::all_of(volume.begin(), volume.end(), [&](const auto& term) {
      return less(term.second / Interval(multiplicity(term.first)), least_) == Verdict::refuted;
    });
  }

  /// What the passage carries a corner to, less what the straight map does: nothing for vertices.
  Cell missed_at(const std::vector<double>& t, const Cell& here) {
    if (std::find(t.begin(), t.end(), 1) != t.end()) return Cell(m_, 1);
    return passage_.on(here).image - combined(t, simplex_.there);
  }

  const SimplexOfTwoHomes& simplex_;
  PassageValues& passage_;
  const Interval least_;
  std::size_t m_;
  Matrix<Interval> back_;      // M
  Matrix<Interval> gradient_;  // of T
};

}  // namespace

bool is_blend_volume_at_least(const SimplexOfTwoHomes& simplex, PassageValues& passage, const Interval& least) {
  return VolumeOfBlend(simplex, passage, least).holds();
}

}  // namespace delcert::checker
