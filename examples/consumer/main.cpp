// The square with corners (0, 0), (1, 0), (1, 1), (0, 1) has two Delaunay triangulations. Move its last corner by
// 2⁻¹⁰⁰ and it has one: no double sees the difference, the ladder of number types decides it.

#include <delcert_version.hpp>
#include <iostream>
#include <string_view>

#include "kernel/number/exact_text.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/simplex_decisions.hpp"
#include "kernel/simplex/thickness.hpp"

namespace {

using delcert::ExactSimplex;
using delcert::Rational;

// The corner right of the origin, against the triangle of the three others.
delcert::Verdict lies_on_circumsphere(const Rational& shift) {
  const auto corners = ExactSimplex::from_points({{1, 0}, {0, 0}, {1, 1}, {-shift, 1}});
  return delcert::decide_circumsphere_within(corners, 0, Rational(0));
}

}  // namespace

int main() {
  const delcert::EdgeGram<Rational> triangle = ExactSimplex::from_points({{0, 0}, {1, 0}, {1, 1}}).on<Rational>();
  std::cout << "delcert " << delcert::version << '\n'
            << "squared circumradius " << delcert::exact_text(*delcert::squared_circumradius(triangle)) << '\n'
            << "squared thickness " << delcert::exact_text(*delcert::squared_thickness(triangle)) << '\n';

  const std::string_view square = name_of(lies_on_circumsphere(0));
  std::cout << "cocircular corners of the square: " << square << '\n';
  delcert::ladder_statistics() = {};
  const std::string_view moved = name_of(lies_on_circumsphere(Rational::power_of_two(-100)));
  const auto by_intervals = delcert::ladder_statistics().settled[static_cast<std::size_t>(delcert::Rung::interval)];
  std::cout << "after a move by 2^-100: " << moved
            << (by_intervals == 0 ? ", which took more than doubles\n" : ", by doubles\n");
}
