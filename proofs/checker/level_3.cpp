#include <algorithm>
#include <bit>

#include "proofs/checker/configuration.hpp"
#include "proofs/checker/core/frame.hpp"
#include "proofs/checker/far_from_sphere.hpp"
#include "proofs/checker/grid.hpp"
#include "proofs/checker/parts.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

using Bits = std::vector<std::uint64_t>;

/// Whether there is any.
bool intersect(const Bits& a, const Bits& b, Bits& result) {
  std::uint64_t any = 0;
  result.resize(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) any |= result[k] = a[k] & b[k];
  return any != 0;
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
  Search(const Certificate& certificate, const Grid& grid, Report& report)
      : c_(certificate), report_(report), grid_(grid), bounds_(c_), m_(static_cast<std::size_t>(c_.m)), powers_(m_) {
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
    Bits& all = allowed_[0];
    all.assign((candidates_.size() + 63) / 64, ~std::uint64_t{0});
    if (candidates_.size() % 64 != 0) all.back() >>= 64 - candidates_.size() % 64;
    extend(Simplex<Interval>(c_.metric));
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
    powers_.clear();
    for (const Candidate& candidate : candidates_) powers_.add(candidate.twice_covector, candidate.squared_length);
    later_.assign(candidates_.size(), Bits((candidates_.size() + 63) / 64, 0));
    for (std::size_t b = 0; b < candidates_.size(); ++b) {
      // The squared distance from a is the power of a for this sphere, and |q_b - v_0|^2.
      const FarFromSphere::Sphere point = powers_.sphere(candidates_[b].x, 0);
      const double farthest = longest_squared_ - candidates_[b].squared_length.lower();
      for (std::size_t a = 0; a < b; ++a) {
        if (candidates_[a].vertex.label == candidates_[b].vertex.label || powers_.is_above(point, a, farthest))
          continue;
        later_[a][b / 64] |= std::uint64_t{1} << b % 64;
      }
    }
  }

  /// Looks at all sets that contain the chosen vertices, which span the simplex, and candidates that are allowed with
  /// them.
  void extend(const Simplex<Interval>& simplex) {
    const double narrow = narrow_for(simplex.radius_squared);
    const FarFromSphere::Sphere sphere = powers_.sphere(simplex.centre, narrow);
    const std::size_t dimension = simplex.dimension();
    const Bits &allowed = allowed_[dimension], &both = allowed_[dimension + 1];
    if (dimension + 1 == m_) open_pencil(simplex, allowed);
    if (dimension > 0) count(allowed);
    for_each(allowed, [&](std::size_t index) {
      if (dimension > 0 && !powers_.is_far(sphere, index)) {
        const Interval power = power_of(index, simplex);
        chosen_.push_back(candidates_[index].vertex);
        if (power.lower() <= narrow && -power.upper() <= narrow) decide_configuration();
        chosen_.pop_back();
      }
      if (dimension == m_ || !intersect(allowed, later_[index], allowed_[dimension + 1])) return;
      if (dimension + 1 < m_ || !are_far_from_all(index, both)) extend_by(simplex, index);
    });
  }
  /// P1 fails at the last vertex q if q is certainly farther than alpha R from the circumscribed sphere of the others,
  /// which contains their circumsphere, and so if |P| is more than this: for | |q - c| - R | <= alpha R implies |P| = |
  /// |q - c| - R | (|q - c| + R) <= alpha R (2R + alpha R), where P = |q - c|^2 - R^2 = |q|^2 - 2 <q, c>.
  double narrow_for(const Interval& radius_squared) const { return (power_factor_ * radius_squared).upper(); }
  void count(const Bits& bits) {
    std::uint64_t number = 0;
    for (const std::uint64_t word : bits) number += static_cast<std::uint64_t>(std::popcount(word));
    sets += number;
    Budget::spend(10 * number);
  }

  /// The spheres through the vertices of an (m-1)-simplex.
  void open_pencil(const Simplex<Interval>& simplex, const Bits& allowed) {
    core::Columns<Interval> edges{};
    for (std::size_t k = 0; k + 1 < m_; ++k) edges[k] = candidates_[picked_[k]].twice_covector;
    const Vector<Interval> normal = core::cofactors(edges, m_, m_ - 1);
    pencil_.open(powers_, simplex.centre, simplex.radius_squared, normal, c_.metric.squared_length(normal));
    for_each(allowed, [this](std::size_t index) { pencil_.add(index); });
  }
  /// Whether, without more being known of the m-simplex of that simplex and a candidate, P1 fails at all of the last
  /// vertices, or the m-simplex is too large.
  bool are_far_from_all(std::size_t index, const Bits& last) {
    const SpherePencil::Sphere sphere = pencil_.through(index, power_factor_.upper());
    if (sphere.least_radius_squared >= four_epsilon_squared_) return true;
    bool far = true;
    for_each(last, [&](std::size_t other) { far = far && pencil_.is_far(sphere, other); });
    if (far) count(last);
    return far;
  }

  template <class F>
  static void for_each(const Bits& set, const F& f) {
    for (std::size_t word = 0; word < set.size(); ++word) {
      for (std::uint64_t bits = set[word]; bits != 0; bits &= bits - 1)
        f(64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  }
  Interval power_of(std::size_t index, const Simplex<Interval>& simplex) const {
    return candidates_[index].squared_length - dot(candidates_[index].twice_covector, simplex.centre, m_);
  }

  /// Looks at the larger sets. Each has a facet that contains all chosen vertices: it is not good if they are
  /// degenerate (P4), and its circumradius is at least theirs (P2).
  void extend_by(Simplex<Interval> simplex, std::size_t index) {
    const Interval power = power_of(index, simplex);
    picked_[simplex.dimension()] = index;
    chosen_.push_back(candidates_[index].vertex);
    Verdict added = simplex.add_vertex(candidates_[index].x, power);
    if (added == Verdict::undecided) {
      const Simplex<Rational> exact(c_.metric, c_.points.positions<Rational>(chosen_));
      added = exact.complete;
      if (added == Verdict::proved) simplex = Simplex<Interval>(exact);
    }
    if (added == Verdict::proved && simplex.radius_squared.lower() < four_epsilon_squared_) extend(simplex);
    chosen_.pop_back();
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
  const Grid& grid_;
  const ConfigurationBounds bounds_;
  const std::size_t m_;
  FarFromSphere powers_;  // of the candidates
  SpherePencil pencil_;
  double longest_squared_ = 0, four_epsilon_squared_ = 0;  // of the first label
  Interval power_factor_{0};
  std::vector<Candidate> candidates_;
  std::vector<Bits> later_;      // later_[a]: the candidates after a with another label that are not too far from it
  std::array<Bits, 6> allowed_;  // with simplices of each dimension, while they are looked at
  Vertices chosen_;
  std::array<std::size_t, 4> picked_{};  // the numbers of the chosen candidates
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
