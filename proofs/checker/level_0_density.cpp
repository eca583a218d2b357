#include <algorithm>
#include <optional>

#include "proofs/checker/faces.hpp"
#include "proofs/checker/levels.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {
namespace {

std::string simplex_name(const Certificate& c, const Label* labels) {
  return "net simplex " + label_set({labels, labels + c.m + 1});
}

template <class F>
void for_each_net_simplex(const Certificate& c, const F& f) {
  const std::vector<Label>& labels = c.document.net_simplices;
  for (std::size_t s = 0; s < labels.size(); s += static_cast<std::size_t>(c.m) + 1) f(&labels[s]);
}

/// The vertices of net simplex s: the first as it stands, the others at their only lifts at distance < 2 epsilon.
std::optional<Vertices> lifted(const Certificate& c, const Quantity& reach, const Label* labels) {
  Vertices vertices{{labels[0], {}}};
  for (int k = 1; k <= c.m; ++k) {
    const std::vector<Lift> lifts = c.net.lifts_within(vertices[0], labels[k], reach, false);
    if (lifts.size() != 1) return std::nullopt;
    vertices.push_back({labels[k], lifts[0]});
  }
  return vertices;
}

/// All vertices are at distance < epsilon from the circumcentre of the face.
template <class N>
Verdict in_ball_about(const Certificate& c, const Vertices& vertices, const Vertices& face) {
  Vector<N> centre = c.net.position<N>(face[0]);
  if (face.size() > 1) {
    const Simplex<N> simplex(c.metric, c.net.positions<N>(face));
    if (simplex.non_degenerate != Verdict::proved) return simplex.non_degenerate;
    for (std::size_t k = 0; k < centre.size(); ++k) centre[k] = centre[k] + simplex.centre[k];
  }
  Verdict result = Verdict::proved;
  for (const Vertex& v : vertices) {
    const N distance = c.metric.squared_length(c.net.position<N>(v) - centre);
    result = conjunction(result, less(distance, square(c.epsilon.as<N>())));
  }
  return result;
}

bool in_open_ball(const Certificate& c, const Vertices& vertices) {
  const auto about = [&](const Vertices& face) {
    return decide([&]<class N>(In<N>) { return in_ball_about<N>(c, vertices, face); });
  };
  if (about(vertices)) return true;
  const std::vector<Vertices> faces = faces_of(vertices);
  return std::any_of(faces.begin() + 1, faces.end(), about);
}

/// det of the edge vectors from the first vertex: Laplace expansion along the rows from `row` on.
template <class N>
N determinant(const std::vector<Vector<N>>& edges, std::size_t row, unsigned columns) {
  if (row == edges.size()) return N(1);
  N sum(0);
  bool even = true;
  for (std::size_t k = 0; k < 4; ++k) {
    if ((columns >> k & 1) == 0) continue;
    const N term = edges[row][k] * determinant(edges, row + 1, columns & ~(1u << k));
    sum = even ? sum + term : sum - term;
    even = !even;
  }
  return sum;
}

template <class N>
N determinant(const Certificate& c, const Vertices& vertices) {
  std::vector<Vector<N>> edges = c.net.positions<N>(vertices);
  for (std::size_t k = edges.size(); k-- > 0;) edges[k] = edges[k] - edges[0];
  edges.erase(edges.begin());
  return determinant(edges, 0, (1u << c.m) - 1);
}

/// Adds up the determinants of all net simplices, m! times the degree of the map to the torus.
template <class N>
N sum_of_determinants(const Certificate& c, const Quantity& reach) {
  N sum(0);
  for_each_net_simplex(c, [&](const Label* labels) {
    const std::optional<Vertices> vertices = lifted(c, reach, labels);
    if (vertices) sum = sum + determinant<N>(c, *vertices);
  });
  return sum;
}

/// Whether the sum is m!. By 0.cycle it is a multiple of m!, so that the filter decides when it knows it to +- m!/2.
Verdict is_factorial(const Interval& sum, int factorial) {
  const bool possible = sum.lower() <= factorial && factorial <= sum.upper();
  const bool alone = 2 * sum.lower() > factorial && 2 * sum.upper() < 3 * factorial;
  return !possible ? Verdict::refuted : alone ? Verdict::proved : Verdict::undecided;
}
Verdict is_factorial(const Rational& sum, int factorial) {
  return verdict(fmpq_equal(sum.raw(), Rational(factorial).raw()) != 0);
}

void check_degree_on_torus(const Certificate& c, const Quantity& reach, Report& report) {
  constexpr std::array<int, 5> factorials{1, 1, 2, 6, 24};
  const int factorial = factorials[static_cast<std::size_t>(c.m)];
  const auto once = [&]<class N>(In<N>) { return is_factorial(sum_of_determinants<N>(c, reach), factorial); };
  if (decide(once)) return;
  report.reject("0.degree", [&] {
    return "the determinants of the net simplices add up to about " + about(sum_of_determinants<Interval>(c, reach)) +
           " instead of " + std::to_string(factorial);
  });
}

void check_degree_on_ball(const Certificate& c, const Quantity& reach, Report& report) {
  bool inside = false;
  for_each_net_simplex(c, [&](const Label* labels) {
    const std::optional<Vertices> vertices = lifted(c, reach, labels);
    if (!vertices) return;
    const auto negative = [&]<class N>(In<N>) { return less(determinant<N>(c, *vertices), N(0)); };
    const auto positive = [&]<class N>(In<N>) { return less(N(0), determinant<N>(c, *vertices)); };
    if (decide(negative))
      report.reject("0.degree", [&] { return simplex_name(c, labels) + " has negative determinant"; });
    for (std::size_t k = 0; k < vertices->size() && !inside; ++k) {
      inside = decide([&]<class N>(In<N>) {
                 const N squared_norm = c.metric.squared_length(c.net.position<N>((*vertices)[k]));
                 return less(squared_norm, square(c.radius.as<N>()));
               }) &&
               decide(positive);
    }
  });
  if (!inside) report.reject("0.degree", [] { return "no net simplex of positive determinant reaches into the ball"; });
}

}  // namespace

void check_density(const Certificate& c, Report& report) {
  const Quantity reach(Rational(2) * c.epsilon.exact);
  for_each_net_simplex(c, [&](const Label* labels) {
    const std::optional<Vertices> vertices = lifted(c, reach, labels);
    if (vertices && in_open_ball(c, *vertices)) return;
    report.reject("0.ball", [&] {
      return simplex_name(c, labels) + (vertices
                                            ? " lies in no open ball of radius epsilon"
                                            : " has a vertex without exactly one lift within 2 epsilon of the first");
    });
  });
  if (c.torus) {
    check_degree_on_torus(c, reach, report);
  } else {
    check_degree_on_ball(c, reach, report);
  }
}

}  // namespace delcert::checker
