#include "proofs/checker/core/circumball.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker::core {
namespace {

/// cot alpha + cot beta > weight for the angles opposite to an edge, from the squared lengths: with s = a^2 + b^2 - e^2
/// and r = 4 a^2 b^2 - s^2, cot alpha = s / sqrt r.
template <class N>
Verdict has_cotangents_above(Complex& complex, const Form<N>& form, const Hinge& hinge, const N& weight) {
  const auto squared_length = [&](const Vector<N>& x, const Vector<N>& y) {
    return unrolled(complex.data.K, form.squared(x - y));
  };
  const Lifts<N> lifts = complex.lifts<N>(hinge.simplex[0]);
  const std::size_t i = hinge.apex[0] == 0 ? 1 : 0, j = hinge.apex[0] == 2 ? 1 : 2;
  const N edge = squared_length(lifts[i], lifts[j]);
  N sum(0);
  for (const Vector<N>& apex : {lifts[hinge.apex[0]], complex.beyond<N>(hinge)}) {
    const N a = squared_length(lifts[i], apex), b = squared_length(lifts[j], apex), s = a + b - edge;
    sum = sum + s / square_root(N(4) * a * b - square(s));
  }
  return less(weight, sum);
}

/// The squared lengths of the edges of a simplex.
template <class N>
using Lengths = std::array<std::array<N, 5>, 5>;

/// The Gram matrix at the first vertex.
template <class N>
SquareMatrix<N> gram_of(std::size_t m, const Lengths<N>& squared) {
  SquareMatrix<N> result(m);
  for (std::size_t x = 1; x <= m; ++x) {
    for (std::size_t y = 1; y <= m; ++y) result(x - 1, y - 1) = (squared[0][x] + squared[0][y] - squared[x][y]) / N(2);
  }
  return result;
}

/// With k = cos^2 rho (1/cosh^2 rho): B^2 k G_D - G_C and G_C - (A^2 / k) G_D are positive definite.
template <class N>
Verdict is_stretched_within(Complex& complex, const Form<N>& form, std::size_t s, const N& least, const N& greatest) {
  const Data& data = complex.data;
  const std::size_t m = data.m;
  const Lifts<N> lifts = complex.lifts<N>(s);
  const N bent = Circumball<N>(data, form, lifts).tangent_squared();
  const N k = data.K > 0 ? N(1) / (N(1) + bent) : N(1) - bent;
  Lengths<N> chords{}, arcs{};
  for (std::size_t x = 0; x <= m; ++x) {
    for (std::size_t y = 0; y < x; ++y) {
      chords[x][y] = chords[y][x] = form.squared(lifts[x] - lifts[y]);
      arcs[x][y] = arcs[y][x] = unrolled(data.K, chords[x][y]);
    }
  }
  const SquareMatrix<N> straight = gram_of(m, chords), flat = gram_of(m, arcs);
  SquareMatrix<N> above(m), below(m);
  for (std::size_t x = 0; x < m; ++x) {
    for (std::size_t y = 0; y < m; ++y) {
      above(x, y) = square(greatest) * k * flat(x, y) - straight(x, y);
      below(x, y) = straight(x, y) - square(least) / k * flat(x, y);
    }
  }
  return conjunction(is_positive_definite(above), is_positive_definite(below));
}

}  // namespace

void check_cotangents(Complex& complex, const Quantity& weight, Report& report) {
  const Circumballs balls(complex);
  const auto check = [&](const Hinge& hinge, Report& found) {
    const bool fine = decide_enclosed(
        [&]<class N>(In<N>) { return has_cotangents_above<N>(complex, balls.form<N>(), hinge, weight.as<N>()); });
    if (fine) return;
    found.reject("6.self-delaunay", [&] {
      return "the cotangents of the angles opposite to the edge of " + complex.name(hinge.simplex[0]) + " and " +
             complex.name(hinge.simplex[1]) + " have a sum of at most weight";
    });
  };
  in_parts("6.self-delaunay", Items::facets, complex.hinges.size(), report,
           [&](std::size_t begin, std::size_t end, Report& found) {
             for (std::size_t at = begin; at < end; ++at) check(complex.hinges[at], found);
             return Counts{};
           });
}

void check_stretching(Complex& complex, const Quantity& least, const Quantity& greatest, Report& report) {
  const Circumballs balls(complex);
  const auto fits = [&](std::size_t s) {
    return decide_enclosed([&]<class N>(In<N>) {
      if (complex.data.K == 0)  // an isometry
        return conjunction(less_equal(least.as<N>(), N(1)), less_equal(N(1), greatest.as<N>()));
      return is_stretched_within<N>(complex, balls.form<N>(), s, least.as<N>(), greatest.as<N>());
    });
  };
  const bool isometric = complex.data.K == 0;
  const std::size_t number = isometric ? 1 : complex.data.simplices();
  in_parts("6.bilipschitz", isometric ? Items::others : Items::simplices, number, report,
           [&](std::size_t begin, std::size_t end, Report& found) {
             for (std::size_t s = begin; s < end; ++s) {
               if (complex.sign[s] == 0 || fits(s)) continue;
               found.reject("6.bilipschitz",
                            [&] { return complex.name(s) + " is stretched beyond the bounds of bilipschitz"; });
             }
             return Counts{};
           });
}

}  // namespace delcert::checker::core
