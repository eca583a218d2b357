#include "proofs/checker/core/powers_around.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker::core {
namespace {

/// A function of a stated length.
class OfStatedLength {
 public:
  /// `flat`: its value for K = 0.
  OfStatedLength(Ball (*function)(int, const Ball&), int K, const Quantity& length, Rational flat)
      : function_(function), K_(K), length_(length.exact), flat_(std::move(flat)) {
    filter_ = in_balls(128, [&] { return as<Ball>().enclosure(); });
  }
  template <class N>
  N as() const {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter_;
    } else if constexpr (std::is_same_v<N, Rational>) {
      return flat_;
    } else {
      return function_(K_, Ball(length_));
    }
  }

 private:
  Ball (*function_)(int, const Ball&);
  int K_;
  Rational length_, flat_;
  Interval filter_;
};

class Margins {
 public:
  Margins(Complex& complex, const Quantity& circumradius, const Quantity& protection, Report& report)
      : complex_(complex),
        report_(report),
        balls_(complex),
        tangent_(tangent, complex.data.K, circumradius, circumradius.exact),
        sine_(sine, complex.data.K, protection, protection.exact),
        versed_sine_(versed_sine, complex.data.K, protection, square(protection.exact) / Rational(2)),
        around_(complex) {}

  void check(std::uint32_t s) {
    const Circumball<Interval> filter = balls_.filter(s);
    const bool small = balls_.decide(s, filter, [&]<class N>(const Circumball<N>& ball) {
      return less_equal(ball.tangent_squared(), square(tangent_.as<N>()));
    });
    if (!small) report_.reject("4.ball", [&] { return complex_.name(s) + " has no circumball so small"; });
    around_.look(s, filter);
    const Interval room = square_root(filter.tangent_squared() * square(sine_.as<Interval>()));
    const double bound = (versed_sine_.as<Interval>() + room).upper();
    for (const PowersAround::Point& point : around_.points()) {
      if (!is_decided(around_.is_above(point, bound))) check(s, filter, point.label, point.element);
    }
  }

 private:
  void check(std::uint32_t s, const Circumball<Interval>& filter, Label j, Elements::Id moved) {
    const bool outside = balls_.decide(s, filter, [&]<class N>(const Circumball<N>& ball) {
      const N power = ball.power(complex_.elements.moved(moved, complex_.point<N>(j))) - versed_sine_.as<N>();
      return negation(at_most_root(power, ball.tangent_squared() * square(sine_.as<N>())));
    });
    if (outside) return;
    report_.reject("4.empty", [&] {
      return complex_.name(s) + " has label " + name_of(j) + " within protection of its circumball";
    });
  }

  Complex& complex_;
  Report& report_;
  Circumballs balls_;
  OfStatedLength tangent_, sine_, versed_sine_;
  PowersAround around_;
};

/// r + delta < pi / 2 on a sphere.
bool is_below_quarter(int K, const Quantity& circumradius, const Quantity& protection) {
  return K <= 0 || decide_with_balls([&] {
           Ball pi;
           arb_const_pi(pi.raw(), Ball::precision);
           return less(Ball(2) * (Ball(circumradius.exact) + Ball(protection.exact)), pi);
         });
}

}  // namespace

void check_hinges(Complex& complex, FlatSimplices* flat, Report& report) {
  Circumballs balls(complex);
  const auto check_ball = [&](std::size_t s, Report& found) {
    if (complex.sign[s] == 0) return;  // core.sign
    if (!balls.decide(s, balls.filter(s),
                      []<class N>(const Circumball<N>& ball) { return less(ball.tangent_squared(), N(1)); }))
      found.reject("core.hinges", [&] { return complex.name(s) + " has no circumball"; });
  };
  const auto check = [&](const Hinge& hinge, Report& found) {
    const auto [s, t] = hinge.simplex;
    if (complex.sign[s] == 0 || complex.sign[t] == 0) return;
    // The vertex beyond the hinge is a neighbour of vertices.
    if (flat != nullptr && is_decided(flat->of(s).power > 0)) return;
    const bool convex = balls.decide(s, balls.kept(s), [&]<class N>(const Circumball<N>& ball) {
      return less(N(0), ball.power(complex.beyond<N>(hinge)));
    });
    if (convex) return;
    found.reject("core.hinges", [&, first = s, second = t] {
      return complex.name(first) + " and " + complex.name(second) + " are not locally Delaunay";
    });
  };
  if (complex.data.K < 0) {
    in_parts("core.hinges, balls", Items::simplices, complex.data.simplices(), report,
             [&](std::size_t begin, std::size_t end, Report& found) {
               for (std::size_t s = begin; s < end; ++s) check_ball(s, found);
               return Counts{};
             });
  }
  const auto check_all = [&](std::size_t begin, std::size_t end, Report& found) {
    for (std::size_t at = begin; at < end; ++at) check(complex.hinges[at], found);
    return Counts{static_cast<std::int64_t>(end - begin)};
  };
  in_parts("core.hinges", Items::facets, complex.hinges.size(), report, check_all, {"facets"});
}

void check_margins(Complex& complex, const Quantity& circumradius, const Quantity& protection, Report& report) {
  if (!is_below_quarter(complex.data.K, circumradius, protection)) {
    report.reject("4.ball", [] { return "circumradius + protection is not below a quarter of a great circle"; });
    return;
  }
  in_parts("4.ball, 4.empty", Items::simplices, complex.data.simplices(), report,
           [&](std::size_t begin, std::size_t end, Report& found) {
             Margins margins(complex, circumradius, protection, found);
             for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s) {
               if (complex.sign[s] != 0) margins.check(s);
             }
             return Counts{};
           });
}

}  // namespace delcert::checker::core
