#include <algorithm>
#include <bit>

#include "proofs/checker/configuration.hpp"
#include "proofs/checker/grid.hpp"
#include "proofs/checker/levels.hpp"

namespace delcert::checker {
namespace {

using Bits = std::vector<std::uint64_t>;

/// A lift near the first vertex v_0, relative to it.
struct Candidate {
  Vertex vertex;
  Vector<Interval> x, twice_covector;  // q - v_0 and 2 G (q - v_0)
  Interval squared_length{0};
};

/// The simplex of the vertices chosen so far, by the orthogonalised edges and the circumcentre relative to v_0.
template <class N>
struct Node {
  std::size_t edges = 0;
  std::array<Vector<N>, 4> direction{}, covector{};  // u_k and G u_k / |u_k|^2
  Vector<N> centre{};
  N radius_squared{0};
};

template <class N>
N dot(const Vector<N>& x, const Vector<N>& y, std::size_t m) {
  N sum = x[0] * y[0];
  for (std::size_t k = 1; k < m; ++k) sum = sum + x[k] * y[k];
  return sum;
}

/// Adds a vertex at x from v_0 with P = |x|^2 - 2 <x, c>: u = x - sum <x, u_k> u_k / |u_k|^2 and c' = c + s u with
/// 2 s |u|^2 = P, since c' is as far from x as from v_0. Refuted if the vertices are degenerate.
template <class N>
Verdict join(const Metric& metric, Node<N>& node, const Vector<N>& x, const N& power) {
  const auto m = static_cast<std::size_t>(metric.dimension());
  Vector<N> u = x;
  for (std::size_t k = 0; k < node.edges; ++k) {
    const N coefficient = dot(x, node.covector[k], m);
    for (std::size_t a = 0; a < m; ++a) u[a] = u[a] - coefficient * node.direction[k][a];
  }
  const N length = metric.squared_length(u);
  const Verdict positive = less(N(0), length);
  if (positive != Verdict::proved) return positive;
  const N inverse = N(1) / length;
  const N step = power * inverse / N(2);
  Vector<N> covector = metric.covector(u);
  for (std::size_t a = 0; a < m; ++a) {
    covector[a] = covector[a] * inverse;
    node.centre[a] = node.centre[a] + step * u[a];
  }
  node.radius_squared = node.radius_squared + step * power / N(2);
  node.direction[node.edges] = u;
  node.covector[node.edges++] = covector;
  return Verdict::proved;
}

Node<Interval> enclosure(const Node<Rational>& exact) {
  Node<Interval> node;
  node.edges = exact.edges;
  for (std::size_t a = 0; a < 4; ++a) {
    node.centre[a] = enclosure(exact.centre[a]);
    for (std::size_t k = 0; k < exact.edges; ++k) {
      node.direction[k][a] = enclosure(exact.direction[k][a]);
      node.covector[k][a] = enclosure(exact.covector[k][a]);
    }
  }
  node.radius_squared = enclosure(exact.radius_squared);
  return node;
}

/// Enumerates the sets of at most m + 2 lifts of different labels that are pairwise not certainly too far apart (P3).
/// Each set mod the lattice is met once: its least label v_0 at lift 0, the others in increasing order.
class Search {
 public:
  Search(const Certificate& certificate, Report& report)
      : c_(certificate), report_(report), grid_(c_.points), bounds_(c_), m_(static_cast<std::size_t>(c_.m)) {
    const Interval t = Interval::between(0, upper_root(bounds_.mu_delta_squared.filter));
    longest_squared_ = (bounds_.edge_unit.filter * square(Interval(1) + t / Interval(2))).upper();
    const Interval alpha = Interval::between(0, upper_root(bounds_.alpha_squared.filter));
    power_factor_ = alpha * (Interval(2) + alpha);
  }

  void from(Label first) {
    chosen_.assign(1, {first, {}});
    collect(first);
    Bits all((candidates_.size() + 63) / 64, ~std::uint64_t{0});
    if (candidates_.size() % 64 != 0) all.back() >>= 64 - candidates_.size() % 64;
    extend({}, all);
  }

  std::uint64_t sets = 0;   // of three or more
  std::uint64_t close = 0;  // of them, those that P1 at the last vertex does not rule out at once

 private:
  void collect(Label first) {
    const Vector<Interval> origin = c_.points.position<Interval>({first, {}});
    const double reach = upper_root(Interval::between(0, longest_squared_));
    candidates_.clear();
    grid_.visit(origin, reach, [&](const Vertex& q) {
      if (q.label <= first) return;
      Candidate candidate{q, c_.points.position<Interval>(q) - origin, {}, Interval(0)};
      candidate.squared_length = c_.metric.squared_length(candidate.x);
      if (candidate.squared_length.lower() >= longest_squared_) return;
      candidate.twice_covector = c_.metric.covector(candidate.x);
      for (Interval& entry : candidate.twice_covector) entry = entry + entry;
      candidates_.push_back(candidate);
    });
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return std::pair(a.vertex.label, a.vertex.lift) < std::pair(b.vertex.label, b.vertex.lift);
    });
    later_.assign(candidates_.size(), Bits((candidates_.size() + 63) / 64, 0));
    for (std::size_t a = 0; a < candidates_.size(); ++a) {
      for (std::size_t b = a + 1; b < candidates_.size(); ++b) {
        if (candidates_[a].vertex.label == candidates_[b].vertex.label) continue;
        const Interval length = c_.metric.squared_length(candidates_[a].x - candidates_[b].x);
        if (length.lower() < longest_squared_) later_[a][b / 64] |= std::uint64_t{1} << b % 64;
      }
    }
  }

  /// Looks at all sets that contain the chosen ones (the node) and candidates out of `allowed`.
  void extend(const Node<Interval>& node, const Bits& allowed) {
    // P1 fails at the last vertex q if q is certainly farther than alpha R from the circumscribed sphere of the others,
    // which contains their circumsphere: for | |q - c| - R | <= alpha R implies |P| = | |q - c| - R | (|q - c| + R)
    // <= alpha R (2R + alpha R), where P = |q - c|^2 - R^2 = |q|^2 - 2 <q, c>.
    const double narrow = (power_factor_ * node.radius_squared).upper();
    for (std::size_t word = 0; word < allowed.size(); ++word) {
      for (std::uint64_t bits = allowed[word]; bits != 0; bits &= bits - 1) {
        const std::size_t index = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        const Candidate& q = candidates_[index];
        const Interval power = q.squared_length - dot(q.twice_covector, node.centre, m_);
        chosen_.push_back(q.vertex);
        if (node.edges > 0) {
          ++sets;
          if (power.lower() <= narrow && -power.upper() <= narrow) decide_configuration();
        }
        if (node.edges < m_) {
          Bits rest(allowed.size());
          for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = allowed[k] & later_[index][k];
          Node<Interval> next = node;
          // A larger set has a facet with all chosen vertices; its circumradius is at least theirs (P2), and it is
          // not good if they are degenerate (P4).
          if (std::any_of(rest.begin(), rest.end(), [](std::uint64_t w) { return w != 0; }) && joined(next, q, power) &&
              next.radius_squared.lower() < bounds_.four_epsilon_squared.filter.upper()) {
            extend(next, rest);
          }
        }
        chosen_.pop_back();
      }
    }
  }

  /// Adds the last chosen vertex to the node; false if the vertices are degenerate.
  bool joined(Node<Interval>& node, const Candidate& q, const Interval& power) const {
    const Verdict filtered = join(c_.metric, node, q.x, power);
    if (filtered != Verdict::undecided) return filtered == Verdict::proved;
    Node<Rational> exact;
    const Vector<Rational> origin = c_.points.position<Rational>(chosen_[0]);
    for (std::size_t k = 1; k < chosen_.size(); ++k) {
      const Vector<Rational> x = c_.points.position<Rational>(chosen_[k]) - origin;
      const Rational exact_power = c_.metric.squared_length(x) - Rational(2) * c_.metric.product(x, exact.centre);
      if (join(c_.metric, exact, x, exact_power) != Verdict::proved) return false;
    }
    node = enclosure(exact);
    return true;
  }

  void decide_configuration() {
    ++close;
    if (!decide([&]<class N>(In<N>) { return is_forbidden<N>(c_, bounds_, chosen_); })) return;
    report_.reject("3.configuration", [&] {
      std::string text = "forbidden configuration of";
      for (const Vertex& v : chosen_) text += " " + std::to_string(v.label) + " + " + to_string(v.lift, c_.m);
      return text;
    });
  }

  const Certificate& c_;
  Report& report_;
  const Grid grid_;
  const ConfigurationBounds bounds_;
  const std::size_t m_;
  double longest_squared_ = 0;
  Interval power_factor_{0};
  std::vector<Candidate> candidates_;
  std::vector<Bits> later_;  // later_[a]: the candidates after a with another label that are not too far from it
  Vertices chosen_;
};

}  // namespace

std::string check_level_3(const Certificate& c, Report& report) {
  const Rational mu_squared = square(c.mu.exact);
  if (less(Rational(4) * square(mu_squared), Rational(5625) * c.flake_squared.exact) == Verdict::proved) {
    report.reject("3.flake-parameter", [] { return "Gamma_0 exceeds 2 separation^2 / 75"; });
  }
  Search search(c, report);
  for (Label first = 0; first < c.n; ++first) search.from(first);
  return std::to_string(search.sets) + " sets of 3 to " + std::to_string(c.m + 2) + " points, " +
         std::to_string(search.close) + " of them looked at closely, no forbidden configuration";
}

}  // namespace delcert::checker
