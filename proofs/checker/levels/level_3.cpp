#include "proofs/checker/geometry/grid.hpp"
#include "proofs/checker/levels/configuration.hpp"
#include "proofs/checker/levels/far_from_sphere.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {
namespace {

/// Enumerates the sets of at most m + 2 lifts of different labels that are pairwise not certainly too far apart (P3).
/// Each set mod the lattice is met once: its least label v_0 at lift 0, the others in increasing order.
class Search {
 public:
  Search(const Certificate& certificate, const Grid& grid, Report& report)
      : c_(certificate), report_(report), grid_(grid), bounds_(c_), m_(c_.m_size()), near_(c_.points) {
    const Interval alpha = Interval::between(0, upper_root(bounds_.alpha_squared.filter));
    power_factor_ = alpha * (Interval(2) + alpha);
  }

  void from(Label first) {
    // No label of a set counts for more than this one.
    const Interval squared_unit = square(c_.unit(first));
    const Interval t = Interval::between(0, upper_root(bounds_.mu_delta_squared.filter));
    const Interval longest_squared = bounds_.edge_unit.filter * squared_unit * square(Interval(1) + t / Interval(2));
    four_epsilon_squared_ = (bounds_.four_epsilon_squared.filter * squared_unit).upper();
    first_ = {first, {}};
    near_.open(first_, longest_squared.upper());
    grid_.visit(c_.points.position<Interval>(first_), upper_root(longest_squared), [&](const Vertex& q) {
      if (q.label > first) near_.add(q);
    });
    near_.close();
    find_pairs();
    extend(near_, 0);
  }

  std::uint64_t sets = 0;   // of three or more
  std::uint64_t close = 0;  // of them, those that P1 at the last vertex does not rule out at once

 private:
  void find_pairs() {
    const std::size_t n = near_.size();
    pairs_.assign(n * n, 0);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b)
        pairs_[a * n + b] = near_.vertex(a).label != near_.vertex(b).label && !near_.are_apart(a, b) ? 1 : 0;
    }
  }

  /// Looks at all sets that contain the vertices of the simplex from which the points are seen, and some of these. The
  /// larger sets have a facet that contains all of these vertices: it is not good if they are degenerate (P4), and its
  /// circumradius is at least theirs (P2).
  template <class Seen>
  void extend(const Seen& seen, std::size_t dimension) {
    SeenFromSimplex& next = seen_[dimension];
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const std::uint32_t* is_pair = &pairs_[seen.number(i) * near_.size()];
      next.choose(i, seen.size(), [&](std::size_t k) { return is_pair[seen.number(k)]; });
      if (next.size() == 0) continue;
      const AddedVertex<Seen> vertex(seen, i);
      if (vertex.least_radius_squared() >= four_epsilon_squared_) continue;
      sets += next.size();
      Budget::spend(10 * next.size());
      chosen_[dimension] = seen.number(i);
      next.see(seen, vertex);
      const double narrow = narrow_for(vertex.greatest_radius_squared());
      for (std::size_t k = 0; !next.are_far(narrow) && k < next.size(); ++k) {
        if (!vertex.is_far(next.place(k), narrow)) look_at(dimension + 1, next.number(k));
      }
      if (dimension + 1 == m_) continue;
      next.multiply(seen, vertex);
      extend(next, dimension + 1);
    }
  }
  /// P1 fails at the last vertex q if q is certainly farther than alpha R from the circumscribed sphere of the others,
  /// which contains their circumsphere, and so if |P| is more than this: for | |q - c| - R | <= alpha R implies |P| = |
  /// |q - c| - R | (|q - c| + R) <= alpha R (2R + alpha R), where P = |q - c|^2 - R^2 = |q|^2 - 2 <q, c>.
  double narrow_for(double radius_squared) const { return power_factor_.upper() * radius_squared; }

  /// What doubles leave open: the first vertex, so many that are chosen, and a last one.
  void look_at(std::size_t chosen, std::size_t last) {
    Budget::spend(100);
    Vertices vertices{first_};
    for (std::size_t k = 0; k < chosen; ++k) vertices.push_back(near_.vertex(chosen_[k]));
    Simplex<Interval> simplex(c_.metric, c_.points.positions<Interval>(vertices));
    if (simplex.complete != Verdict::proved) {
      const Simplex<Rational> exact(c_.metric, c_.points.positions<Rational>(vertices));
      if (exact.complete != Verdict::proved) return;
      simplex = Simplex<Interval>(exact);
    }
    if (simplex.radius_squared.lower() >= four_epsilon_squared_) return;
    vertices.push_back(near_.vertex(last));
    const Interval power =
        simplex.power(c_.points.position<Interval>(vertices.back()) - c_.points.position<Interval>(first_));
    const double narrow = narrow_for(simplex.radius_squared.upper());
    if (power.lower() <= narrow && -power.upper() <= narrow) decide_configuration(vertices);
  }
  void decide_configuration(const Vertices& vertices) {
    ++close;
    if (!decide([&]<class N>(In<N>) { return is_forbidden<N>(c_, bounds_, vertices); })) return;
    report_.reject("3.configuration", [&] {
      std::string text = "forbidden configuration";
      for (const Vertex& v : vertices) text += ", " + to_string(v, c_.m);
      return text;
    });
  }

  const Certificate& c_;
  Report& report_;
  const Grid& grid_;
  const ConfigurationBounds bounds_;
  const std::size_t m_;
  Interval power_factor_{0};
  double four_epsilon_squared_ = 0;  // of the first label
  Vertex first_;
  SeenFromVertex near_;
  std::array<SeenFromSimplex, 4> seen_;  // from simplices of dimension 1 to m, while they are looked at
  std::array<std::size_t, 4> chosen_{};  // their vertices other than the first, as numbers of what is near
  std::vector<std::uint32_t> pairs_;     // rows: 1 if two have different labels and are not too far apart
};

}  // namespace

std::string check_level_3(const Certificate& c, Report& report) {
  const Rational mu_squared = square(c.mu.exact);
  if (less(Rational(4) * square(mu_squared), Rational(5625) * c.flake_squared.exact) == Verdict::proved) {
    report.reject("3.flake-parameter", [] { return "Gamma_0 exceeds 2 separation^2 / 75"; });
  }
  const Grid grid(c.points);
  const auto look = [&](std::size_t begin, std::size_t end, Report& found) {
    Search search(c, grid, found);
    for (auto first = static_cast<Label>(begin); first < end; ++first) search.from(first);
    return Counts{static_cast<std::int64_t>(search.sets), static_cast<std::int64_t>(search.close)};
  };
  in_parts("3.configuration", c.n, report, look, {"sets", "close"});
  return "{sets} sets of 3 to " + std::to_string(c.m + 2) +
         " points, {close} of them looked at closely, no forbidden configuration";
}

}  // namespace delcert::checker
