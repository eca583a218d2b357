#include <algorithm>
#include <bit>

#include "proofs/checker/configuration.hpp"
#include "proofs/checker/grid.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

using Bits = std::vector<std::uint64_t>;

Bits intersection(const Bits& a, const Bits& b) {
  Bits result(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] & b[k];
  return result;
}

/// A lift near the first vertex v_0, relative to it.
struct Candidate {
  Vertex vertex;
  Vector<Interval> x, twice_covector;  // q - v_0 and 2 G (q - v_0)
  Interval squared_length{0};
};

/// Enumerates the sets of at most m + 2 lifts of different labels that are pairwise not certainly too far apart (P3).
/// Each set mod the lattice is met once: its least label v_0 at lift 0, the others in increasing order.
class Search {
 public:
  Search(const Certificate& certificate, Report& report)
      : c_(certificate), report_(report), grid_(c_.points), bounds_(c_), m_(static_cast<std::size_t>(c_.m)) {
    const Interval alpha = Interval::between(0, upper_root(bounds_.alpha_squared.filter));
    power_factor_ = alpha * (Interval(2) + alpha);
  }

  void from(Label first) {
    // No label of a set counts for more than this one.
    const Interval squared_unit = square(c_.unit(first));
    const Interval t = Interval::between(0, upper_root(bounds_.mu_delta_squared.filter));
    longest_squared_ = (bounds_.edge_unit.filter * squared_unit * square(Interval(1) + t / Interval(2))).upper();
    four_epsilon_squared_ = (bounds_.four_epsilon_squared.filter * squared_unit).upper();
    chosen_.assign(1, {first, {}});
    collect(first);
    Bits all((candidates_.size() + 63) / 64, ~std::uint64_t{0});
    if (candidates_.size() % 64 != 0) all.back() >>= 64 - candidates_.size() % 64;
    extend(Simplex<Interval>(c_.metric), all);
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
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) { return a.vertex < b.vertex; });
    later_.assign(candidates_.size(), Bits((candidates_.size() + 63) / 64, 0));
    for (std::size_t a = 0; a < candidates_.size(); ++a) {
      for (std::size_t b = a + 1; b < candidates_.size(); ++b) {
        if (candidates_[a].vertex.label == candidates_[b].vertex.label) continue;
        const Interval length = c_.metric.squared_length(candidates_[a].x - candidates_[b].x);
        if (length.lower() < longest_squared_) later_[a][b / 64] |= std::uint64_t{1} << b % 64;
      }
    }
  }

  /// Looks at all sets that contain the chosen vertices, which span the simplex, and candidates out of `allowed`.
  void extend(const Simplex<Interval>& simplex, const Bits& allowed) {
    // P1 fails at the last vertex q if q is certainly farther than alpha R from the circumscribed sphere of the others,
    // which contains their circumsphere: for | |q - c| - R | <= alpha R implies |P| = | |q - c| - R | (|q - c| + R)
    // <= alpha R (2R + alpha R), where P = |q - c|^2 - R^2 = |q|^2 - 2 <q, c>.
    const double narrow = (power_factor_ * simplex.radius_squared).upper();
    for (std::size_t word = 0; word < allowed.size(); ++word) {
      for (std::uint64_t bits = allowed[word]; bits != 0; bits &= bits - 1) {
        const std::size_t index = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        const Candidate& q = candidates_[index];
        const Interval power = q.squared_length - dot(q.twice_covector, simplex.centre, m_);
        chosen_.push_back(q.vertex);
        if (simplex.dimension() > 0) {
          ++sets;
          Budget::spend(10);
          if (power.lower() <= narrow && -power.upper() <= narrow) decide_configuration();
        }
        if (simplex.dimension() < m_) extend_by(simplex, q, power, intersection(allowed, later_[index]));
        chosen_.pop_back();
      }
    }
  }

  /// Looks at the larger sets. Each has a facet that contains all chosen vertices: it is not good if they are
  /// degenerate (P4), and its circumradius is at least theirs (P2).
  void extend_by(Simplex<Interval> simplex, const Candidate& q, const Interval& power, const Bits& allowed) {
    if (std::all_of(allowed.begin(), allowed.end(), [](std::uint64_t word) { return word == 0; })) return;
    Verdict added = simplex.add_vertex(q.x, power);
    if (added == Verdict::undecided) {
      const Simplex<Rational> exact(c_.metric, c_.points.positions<Rational>(chosen_));
      added = exact.complete;
      if (added == Verdict::proved) simplex = Simplex<Interval>(exact);
    }
    if (added == Verdict::proved && simplex.radius_squared.lower() < four_epsilon_squared_) extend(simplex, allowed);
  }

  void decide_configuration() {
    ++close;
    if (!decide([&]<class N>(In<N>) { return is_forbidden<N>(c_, bounds_, chosen_); })) return;
    report_.reject("3.configuration", [&] {
      std::string text = "forbidden configuration";
      for (const Vertex& v : chosen_) text += ", " + to_string(v, c_.m);
      return text;
    });
  }

  const Certificate& c_;
  Report& report_;
  const Grid grid_;
  const ConfigurationBounds bounds_;
  const std::size_t m_;
  double longest_squared_ = 0, four_epsilon_squared_ = 0;  // of the first label
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
