#include "proofs/checker/core/reader.hpp"

#include <algorithm>

namespace delcert::checker::core {
namespace {

/// x -> x + e_axis.
FieldMatrix unit_translation(std::size_t m, std::size_t axis) {
  FieldMatrix g = FieldMatrix::identity(m + 1);
  g(axis + 1, 0) = FieldElement(1);
  return g;
}

bool is_rational(const FieldMatrix& a) {
  for (std::size_t i = 0; i < a.order(); ++i) {
    for (std::size_t k = 0; k < a.order(); ++k) {
      if (!a(i, k).is_rational()) return false;
    }
  }
  return true;
}

void read_torus(const Certificate& c, Data& data) {
  const std::size_t m = data.m;
  data.form = FieldMatrix(m);
  for (std::size_t i = 0; i < m; ++i) {
    data.generators.push_back(unit_translation(m, i));
    for (std::size_t k = 0; k < m; ++k) data.form(i, k) = FieldElement(c.gram[i * m + k]);
  }
  for (std::size_t e = 1; e < c.element_count(); ++e) {
    Lift& lift = data.translations.emplace_back();
    std::copy_n(c.element(e), m, lift.begin());
  }
  for (Label j = 0; j < c.n; ++j) data.filter.push_back(c.points.position<Interval>({j, {}}));
  data.enclosed = [&c](Label j) { return c.points.position<Ball>({j, {}}); };
  data.exact = [&c](Label j) { return c.points.position<Rational>({j, {}}); };
}

template <class N>
Vector<N> net_plus_point(const Certificate& c, Label j) {
  return add(c.net.position<N>({j, {}}), N(1), c.points.position<N>({j, {}}));
}

void read_flat(const Certificate& c, Data& data) {
  const SpaceForm& form = *c.space_form;
  data.form = form.gram;
  for (std::size_t axis = 0; axis < data.m; ++axis) data.generators.push_back(unit_translation(data.m, axis));
  for (Label j = 0; j < c.n; ++j) data.filter.push_back(net_plus_point<Interval>(c, j));
  data.enclosed = [&c](Label j) { return net_plus_point<Ball>(c, j); };
  if (is_rational(data.form) && std::all_of(data.generators.begin(), data.generators.end(), is_rational))
    data.exact = [&c](Label j) { return net_plus_point<Rational>(c, j); };
}

/// F_p exp_o v, p with the conformal coordinates a.
template <class N>
Vector<N> moved_point(const Certificate& c, Label j) {
  const int K = c.space_form->K;
  const std::size_t m = c.m_size();
  const Vector<N> opposite = Vector<N>{} - c.net.position<N>({j, {}});
  return seen_from(K, m, opposite, exponential(K, m, c.points.position<N>({j, {}})));
}

void read_curved(const Certificate& c, Data& data) {
  data.form = c.space_form->form();
  data.in_standard_basis = [&c](const FieldMatrix& a) { return c.space_form->in_standard_basis(a); };
  for (Label j = 0; j < c.n; ++j) data.filter.push_back(moved_point<Interval>(c, j));
  data.enclosed = [&c](Label j) { return moved_point<Ball>(c, j); };
}

/// The sum of (-K s)^k / (2k + first)! for k < 9: what is left out is below 2^-80 for s <= 1/16.
Interval series(int K, const Interval& s, int first) {
  Interval sum(1);
  for (int k = 8; k > 0; --k) {
    const Interval step = s / Interval((2 * k + first) * (2 * k + first - 1));
    sum = K > 0 ? Interval(1) - step * sum : Interval(1) + step * sum;
  }
  return sum + Interval::between(-0x1p-70, 0x1p-70);
}

}  // namespace

Vector<Interval> exponential(int K, std::size_t m, const Vector<Interval>& v) {
  const Interval s = squared(v, m);
  Vector<Interval> x{};
  if (!(s.upper() <= 0x1p-4)) {
    in_balls(80, [&] {
      Vector<Ball> enclosed{};
      for (std::size_t k = 0; k < m; ++k) {
        Ball upper;
        arb_set_d(enclosed[k].raw(), v[k].lower());
        arb_set_d(upper.raw(), v[k].upper());
        enclosed[k] = joined(enclosed[k], upper);
      }
      const Vector<Ball> result = checker::exponential(K, m, enclosed);
      for (std::size_t k = 0; k <= m; ++k) x[k] = result[k].enclosure();
    });
    return x;
  }
  x[0] = series(K, s, 0);  // cos, cosh of sqrt s
  const Interval factor = series(K, s, 1);
  for (std::size_t k = 0; k < m; ++k) x[k + 1] = v[k] * factor;
  return x;
}

Data data_of(const Certificate& c) {
  Data data;
  data.m = c.m_size();
  data.labels = c.simplex_labels;
  data.elements = c.simplex_elements;
  for (const auto& loop : c.loops) {
    std::vector<Step>& steps = data.loops.emplace_back();
    for (const LoopStep& step : loop) steps.push_back({step.simplex, step.from, step.to});
  }
  if (c.space_form) {
    data.K = c.space_form->K;
    data.generators = c.space_form->generators;
    for (std::size_t e = 1; e < c.element_count(); ++e)
      data.words.push_back({static_cast<std::uint32_t>(c.element(e)[0]), c.element(e)[1]});
    data.K == 0 ? read_flat(c, data) : read_curved(c, data);
  } else {
    read_torus(c, data);
  }
  return data;
}

}  // namespace delcert::checker::core
