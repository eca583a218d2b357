#include <map>

#include "proofs/checker/space_forms/group.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_elements = 2000;

Ball pi() {
  Ball result;
  arb_const_pi(result.raw(), Ball::precision);
  return result;
}

/// 2 rho < pi and cos(2 rho) J - (J a + a^T J) / 2 is positive definite: no x has <x, a x> >= cos(2 rho), so a moves
/// all points by more than 2 rho.
bool moves_all_far(const SpaceForm& form, const FieldMatrix& a) {
  if (!decide_with_balls([&] { return less(Ball(2) * form.injectivity_radius.as<Ball>(), pi()); })) return false;
  const FieldMatrix J = form.form(), Ja = J * a, twice = Ja + Ja.transposed();
  return decide_with_balls([&] {
    const Ball cosine = Ball::apply(arb_cos, Ball(2) * form.injectivity_radius.as<Ball>());
    SquareMatrix<Ball> difference(form.m + 1);
    for (std::size_t i = 0; i <= form.m; ++i) {
      for (std::size_t k = 0; k <= form.m; ++k)
        difference(i, k) = cosine * J(i, k).enclosure() - twice(i, k).enclosure() / Ball(2);
    }
    return is_positive_definite(difference);
  });
}

}  // namespace

Group spherical_group(const SpaceForm& form, Report& report) {
  const FieldMatrix identity = FieldMatrix::identity(form.m + 1);
  Group group;
  std::vector<FieldMatrix> elements{identity};
  group.letters = form.generators.size();
  // Words by which the elements were reached, as exponents. All loops of the Cayley graph are products of those that
  // an edge closes: they are the relations.
  std::map<FieldMatrix, std::vector<std::int64_t>> known{{identity, std::vector<std::int64_t>(group.letters)}};
  for (std::size_t at = 0; at < elements.size() && known.size() <= most_elements; ++at) {
    for (std::size_t letter = 0; letter < group.letters; ++letter) {
      Budget::spend(1000);
      const FieldMatrix product = elements[at] * form.generators[letter];
      std::vector<std::int64_t> word = known.at(elements[at]);
      ++word[letter];
      const auto [place, is_new] = known.emplace(product, word);
      if (is_new) {
        elements.push_back(product);
      } else {
        for (std::size_t k = 0; k < group.letters; ++k) word[k] -= place->second[k];
        group.relations.push_back(std::move(word));
      }
    }
  }
  if (!decide_with_balls([&] { return less(form.injectivity_radius.as<Ball>(), pi()); }))
    report.reject("group.injectivity", [] { return "the injectivity radius is not below that of a sphere"; });
  for (std::size_t at = 1; at < elements.size(); ++at) {
    if (moves_all_far(form, elements[at])) continue;
    report.reject("group.injectivity", [&] {
      return "element " + std::to_string(at) + " moves a point by at most twice the injectivity radius " +
             rounded_up(form.injectivity_radius.exact);
    });
  }
  // Of infinitely many some move points very little: that is found first.
  if (known.size() > most_elements && report.findings.empty())
    throw Undecided("the group has too many elements to look at");
  group.size = "order " + std::to_string(known.size());
  group.summary = "a finite group of " + group.size;
  return group;
}

}  // namespace delcert::checker
