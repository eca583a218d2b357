#include "proofs/checker/certificate/submanifold.hpp"

#include <algorithm>

#include "proofs/checker/certificate/certificate.hpp"

namespace delcert::checker {
namespace {

/// The numbers of a chart, one after the other.
class ChartNumbers {
 public:
  ChartNumbers(const Certificate& c, Label i) : text_(&c.chart_text[i * c.chart_size()]) {}
  Rational next() { return exact_value(*text_++); }
  void skip(std::size_t number) { text_ += number; }

 private:
  const std::string_view* text_;
};

}  // namespace

Submanifold::Submanifold(int dimension, Cursor& cursor) : m(static_cast<std::size_t>(dimension)) {
  if (cursor.accept(",\"mesh\":")) {
    parse_mesh(cursor);
  } else {
    parse_zero_set(cursor);
  }
  cursor.expect(",\"slope\":");
  slope = Quantity(exact_value(cursor.number()));
  Report::require("form.ranges", slope.exact.sign() > 0, "slope is not positive");
  cursor.expect(",\"vertices\":");
  given = !is_mesh() && cursor.accept("\"given\"");
  if (!given) cursor.expect("\"manifold\"");
}

void Submanifold::parse_mesh(Cursor& cursor) {
  if (m != 2) cursor.fail("form.family", "the dimension 2 before a mesh");
  N = 3;
  q = 1;
  cursor.array([&] {
    vertices.emplace_back(N, 1);
    std::size_t axis = 0;
    cursor.row(3, [&] { vertices.back()[axis++] = exact_value(cursor.number()); });
  });
  cursor.expect(",\"facets\":");
  cursor.array([&] {
    facets.emplace_back();
    std::size_t corner = 0;
    cursor.row(3, [&] { facets.back()[corner++] = static_cast<std::uint32_t>(cursor.count(UINT32_MAX)); });
  });
  if (facets.empty()) throw Malformed("form.ranges", "the mesh has no facets");
  for (const auto& facet : facets) {
    for (const std::uint32_t vertex : facet) {
      if (vertex >= vertices.size())
        throw Malformed("form.ranges",
                        "a facet has the vertex " + std::to_string(vertex) + " of " + std::to_string(vertices.size()));
    }
  }
}

void Submanifold::parse_zero_set(Cursor& cursor) {
  const auto quantity = [&] { return Quantity(exact_value(cursor.number())); };
  std::vector<std::string_view> variables, equations;
  cursor.expect(",\"variables\":");
  cursor.array([&] { variables.push_back(cursor.string()); });
  cursor.expect(",\"equations\":");
  cursor.array([&] { equations.push_back(cursor.string()); });
  N = variables.size();
  q = equations.size();
  if (N > FormulaMap::most_variables || q == 0 || N != m + q)
    throw Malformed("form.formula", "there are not as many equations as variables less the dimension");
  require_names(variables);
  map = FormulaMap(variables, equations);
  cursor.expect(",\"box\":");
  cursor.row(static_cast<int>(N), [&] {
    cursor.expect("[");
    const Quantity lower = quantity();
    cursor.expect(",");
    box.push_back({lower, quantity()});
    cursor.expect("]");
    if (less(lower.exact, box.back()[1].exact) != Verdict::proved)
      throw Malformed("form.ranges", "a side of the box is empty");
  });
}

TangentChart<Rational> tangent_chart(const Certificate& c, Label i) {
  const Submanifold& M = *c.submanifold;
  const std::size_t N = M.N;
  ChartNumbers numbers(c, i);
  std::vector<int> axes(N);  // plus or minus its number, from 1 on
  for (int& axis : axes) {
    const Rational s = numbers.next();
    for (int k = 1; k <= static_cast<int>(N); ++k) axis = s == Rational(k) ? k : s == Rational(-k) ? -k : axis;
  }
  Matrix<Rational> plus(N, N), minus(N, N);  // 1 + A, 1 - A
  for (std::size_t row = 0; row < N; ++row) {
    plus(row, row) = minus(row, row) = Rational(1);
    for (std::size_t k = row + 1; k < N; ++k) {
      const Rational a = numbers.next();
      plus(row, k) = minus(k, row) = a;
      plus(k, row) = minus(row, k) = -a;
    }
  }
  const Matrix<Rational> cayley = solution(plus, minus);  // the two commute
  Matrix<Rational> frame(N, N);
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t row = 0; row < N; ++row) {
      const Rational& entry = cayley(row, static_cast<std::size_t>(std::abs(axes[k]) - 1));
      frame(row, k) = axes[k] < 0 ? -entry : entry;
    }
  }
  TangentChart<Rational> chart;
  chart.tangent = frame.columns_from(0, M.m);
  chart.normal = frame.columns_from(M.m, M.q);
  chart.Y = Matrix<Rational>(M.q, M.q);
  for (std::size_t k = 0; k < M.q * M.q; ++k) chart.Y[k] = numbers.next();
  chart.W = chart.normal * chart.Y;
  chart.centre = Matrix<Rational>(N, 1);
  for (std::size_t k = 0; k < N; ++k) chart.centre[k] = exact_value(c.net_text[i * N + k]);
  chart.home = Matrix<Rational>(M.m, 1);
  const Vector<Rational> home = c.points.position<Rational>({i, {}});
  for (std::size_t k = 0; k < M.m; ++k) chart.home[k] = home[k];
  return chart;
}

TangentPatch tangent_patch(const Certificate& c, Label i) {
  ChartNumbers numbers(c, i);
  numbers.skip(c.chart_size() - 2);
  Quantity radius(numbers.next());
  return {std::move(radius), Quantity(numbers.next())};
}

/// Without the charts nothing can be looked at: no switch leaves them out.
void Certificate::require_submanifold() const {
  const auto require = [](bool holds, const char* what) { Report::require("form.ranges", holds, what); };
  require(!claimed[level_2s] || reach_2s.exact.sign() > 0, "reach is not positive");
  require(
      !claimed[level_5] || (contraction.exact.sign() > 0 && less(contraction.exact, Rational(1)) == Verdict::proved),
      "contraction is not in (0, 1)");
  require(!claimed[level_5] || displacement.exact.sign() > 0, "displacement is not positive");
  require(!claimed[level_5i] || isotopic_by_normals || embedding_margin.exact.sign() > 0,
          "the margin of level 5i is not positive");
  require(!isotopic_by_normals || cosine.exact.sign() > 0, "the cosine of level 5i is not positive");
  require(!claimed[level_4] || density.exact.sign() > 0, "density is not positive");
  require(weight.exact.sign() >= 0, "weight is negative");
  require(!claimed[level_6] || (least_stretch.exact.sign() > 0 && greatest_stretch.exact.sign() > 0),
          "a bound of bilipschitz is not positive");
  require(!claimed[level_6] || (normal.exact.sign() > 0 && less(normal.exact, Rational(1)) == Verdict::proved),
          "normal is not in (0, 1)");
  Report::require("form.family", !claimed[level_6] || !self_delaunay || m == 2, "self_delaunay is for surfaces");
  Report::require("form.family", !theory, "the mode theory is not for submanifolds");
  Report::require("form.family", !isotopic_by_normals || (submanifold->q == 1 && !submanifold->is_mesh()),
                  "level 5i by normals is for zero sets of one equation");
  Report::require("form.family", !claimed[level_1f] || submanifold->given, "level 1f is for vertices that are given");
  if (claimed[level_0] || claimed[level_3]) throw Malformed("form.family", "levels 0 and 3 are not for submanifolds");
  if (claimed[level_4] && submanifold->given) throw Malformed("form.family", "level 4 is for vertices on the manifold");
  for (Label i = 0; i < n; ++i) {
    const auto require_chart = [&](bool holds, const char* what) {
      if (!holds) throw Malformed("form.charts", "the chart of " + std::to_string(i) + what);
    };
    ChartNumbers numbers(*this, i);
    std::vector<bool> met(submanifold->N + 1);
    for (std::size_t k = 0; k < submanifold->N; ++k) {
      const Rational s = numbers.next();
      std::size_t axis = 0;
      for (std::size_t a = 1; a <= submanifold->N; ++a) {
        if (square(s) == square(Rational(static_cast<int>(a)))) axis = a;
      }
      require_chart(axis != 0 && !met[axis], " has no permutation of the axes with signs");
      met[axis] = true;
    }
    const TangentPatch patch = tangent_patch(*this, i);
    require_chart(patch.radius.exact.sign() > 0 && patch.height.exact.sign() > 0, " has an empty patch");
    const Vector<Rational> home = points.position<Rational>({i, {}});
    const Rational moved = dot(home, home, m_size());
    require_chart(less(moved, square(patch.radius.exact)) == Verdict::proved, " does not show its own point");
    require_chart(!submanifold->given || moved.sign() == 0, " moves a vertex that is given");
  }
}

}  // namespace delcert::checker
