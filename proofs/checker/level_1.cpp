#include <algorithm>
#include <optional>

#include "proofs/checker/grid.hpp"
#include "proofs/checker/levels.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {
namespace {

/// |q - C| > R + delta for the point at x from the first vertex: with P = |q - C|^2 - R^2 this is
/// P - delta^2 > sqrt(4 R^2 delta^2).
template <class N>
Verdict is_clear(const Certificate& c, const Simplex<N>& simplex, const Vector<N>& x) {
  const N power = c.metric.squared_length(x) - N(2) * c.metric.product(x, simplex.centre);
  const N squared = square(c.protection.as<N>());
  return negation(at_most_root(power - squared, N(4) * simplex.radius_squared * squared));
}

/// Checks the simplices of one star after the other; what is common to them is kept here.
class StarChecker {
 public:
  StarChecker(const Certificate& certificate, Report& report)
      : c_(certificate), report_(report), grid_(certificate.points), reach_(Rational(2) * c_.circumradius.exact) {}

  void check(Label i) {
    check_facets(i);
    lifts_.clear();
    for (std::size_t s = 0; s < c_.star_size(i); ++s) {
      const Label* labels = c_.star_simplex(i, s);
      // A simplex is looked at from its smallest interior label; 2.agreement says that it is listed there.
      const auto before = [&](Label j) { return j < i && c_.interior[j]; };
      if (std::none_of(labels, labels + c_.m, before)) check_simplex(i, labels);
    }
  }
  std::size_t simplices = 0;

 private:
  std::string name(Label i, const Label* labels) const {
    std::vector<Label> all(labels, labels + c_.m);
    all.insert(std::lower_bound(all.begin(), all.end(), i), i);
    return "simplex " + label_set(all) + " in the star of " + std::to_string(i);
  }

  /// The only lift of the label within 2r of p'_i.
  std::optional<Lift> lift(Label i, Label label) {
    for (const auto& [known, lift] : lifts_) {
      if (known == label) return lift;
    }
    const std::vector<Lift> found = c_.points.lifts_within({i, {}}, label, reach_, true);
    const std::optional<Lift> only = found.size() == 1 ? std::optional<Lift>(found[0]) : std::nullopt;
    lifts_.emplace_back(label, only);
    return only;
  }

  template <class N>
  Simplex<N> simplex() const {
    return Simplex<N>(c_.metric, c_.points.positions<N>(vertices_));
  }

  void check_simplex(Label i, const Label* labels) {
    ++simplices;
    vertices_ = {{i, {}}};
    for (int k = 0; k < c_.m; ++k) {
      const std::optional<Lift> only = lift(i, labels[k]);
      if (!only) {
        return report_.reject("1.vertices", [&] {
          return name(i, labels) + ": label " + std::to_string(labels[k]) +
                 " has no lift or several within 2 circumradius";
        });
      }
      vertices_.push_back({labels[k], *only});
    }
    Simplex<Interval> filter = simplex<Interval>();
    if (filter.non_degenerate != Verdict::proved) {
      const Simplex<Rational> exact = simplex<Rational>();
      if (exact.non_degenerate != Verdict::proved)
        return report_.reject("1.vertices", [&] { return name(i, labels) + " is degenerate"; });
      filter = Simplex<Interval>(exact);
    }
    const auto in = [&]<class N>(In<N>) -> decltype(auto) {
      if constexpr (std::is_same_v<N, Interval>) {
        return static_cast<const Simplex<Interval>&>(filter);
      } else {
        return simplex<N>();
      }
    };
    const auto small = [&]<class N>(In<N> n) {
      return less_equal(in(n).radius_squared, square(c_.circumradius.as<N>()));
    };
    if (!decide(small)) {
      report_.reject("1.radius", [&] {
        return name(i, labels) + " has squared circumradius " + about(filter.radius_squared) +
               ", more than the square of " + about(c_.circumradius.filter);
      });
    }
    const auto thick = [&]<class N>(In<N> n) { return in(n).thicker_than(square(c_.thickness.as<N>())); };
    if (!decide(thick))
      report_.reject("1.thickness", [&] { return name(i, labels) + " is thinner than " + about(c_.thickness.filter); });
    check_protection(i, labels, filter, in);
  }

  template <class Chosen>
  void check_protection(Label i, const Label* labels, const Simplex<Interval>& filter, const Chosen& in) {
    const Vertex base{i, {}};
    const Vector<Interval> origin = c_.points.position<Interval>(base);
    Vector<Interval> centre = origin;
    for (std::size_t k = 0; k < centre.size(); ++k) centre[k] = centre[k] + filter.centre[k];
    const double reach = (Interval::between(0, upper_root(filter.radius_squared)) + c_.protection.filter).upper();
    grid_.visit(centre, reach, [&](const Vertex& q) {
      for (const Vertex& v : vertices_) {
        if (v.label == q.label && v.lift == q.lift) return;
      }
      const auto clear = [&]<class N>(In<N> n) {
        return is_clear<N>(c_, in(n), c_.points.position<N>(q) - c_.points.position<N>(base));
      };
      if (decide(clear)) return;
      report_.reject("1.protection", [&] {
        return name(i, labels) + ": label " + std::to_string(q.label) + " + " + to_string(q.lift, c_.m) +
               " is within circumradius + " + about(c_.protection.filter) + " of its circumcentre";
      });
    });
  }

  /// Every (m-1)-face of star(i) that contains i lies in exactly two simplices of star(i).
  void check_facets(Label i) {
    const auto rest = static_cast<std::size_t>(c_.m) - 1;
    facets_.clear();
    for (std::size_t s = 0; s < c_.star_size(i); ++s) {
      for (std::size_t omitted = 0; omitted <= rest; ++omitted) {
        auto& facet = facets_.emplace_back();
        const Label* labels = c_.star_simplex(i, s);
        std::copy_n(labels + omitted + 1, rest - omitted, std::copy_n(labels, omitted, facet.begin()));
      }
    }
    std::sort(facets_.begin(), facets_.end());
    for (auto begin = facets_.begin(), end = begin; begin != facets_.end(); begin = end) {
      end = std::upper_bound(begin, facets_.end(), *begin);
      if (end - begin == 2) continue;
      report_.reject("1.facets", [&] {
        std::vector<Label> face(begin->begin(), begin->begin() + c_.m - 1);
        face.insert(std::lower_bound(face.begin(), face.end(), i), i);
        return "face " + label_set(face) + " lies in " + std::to_string(end - begin) + " simplices of the star of " +
               std::to_string(i);
      });
    }
  }

  const Certificate& c_;
  Report& report_;
  const Grid grid_;
  const Quantity reach_;
  std::vector<std::pair<Label, std::optional<Lift>>> lifts_;  // of the star at hand
  std::vector<Vertex> vertices_;                              // of the simplex at hand
  std::vector<std::array<Label, 3>> facets_;
};

void check_patch(const Certificate& c, Report& report) {
  const Rational diameter = Rational(2) * c.circumradius.exact + c.protection.exact;
  if (less(Rational(8) * c.epsilon.exact, diameter) == Verdict::proved)
    report.reject("1.patch", [] { return "2 circumradius + protection exceeds 8 epsilon"; });
  if (!c.torus) return;
  const auto short_vector = c.metric.lattice_vector_within(Quantity(Rational(2) * diameter), true);
  if (short_vector) {
    report.reject("1.patch", [&] {
      return "the lattice vector " + to_string(*short_vector, c.m) +
             " is not longer than 4 circumradius + 2 protection";
    });
  }
}

}  // namespace

std::string check_level_1(const Certificate& c, Report& report) {
  check_patch(c, report);
  StarChecker checker(c, report);
  std::size_t stars = 0;
  for (Label i = 0; i < c.n; ++i) {
    if (!c.interior[i]) continue;
    ++stars;
    checker.check(i);
  }
  return std::to_string(stars) + " stars, " + std::to_string(checker.simplices) +
         " simplices, protection >= " + about(c.protection.filter) + ", thickness >= " + about(c.thickness.filter) +
         ", circumradius <= " + about(c.circumradius.filter);
}

}  // namespace delcert::checker
