#include <cmath>
#include <map>

#include "proofs/checker/geometry/metric.hpp"
#include "proofs/checker/space_forms/group.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_cosets = 200;

/// The translation modulo 1.
FieldMatrix reduced(const NumberField& field, FieldMatrix a) {
  for (std::size_t i = 1; i < a.order(); ++i) {
    Rational t = a(i, 0).constant_term();
    fmpz_fdiv_r(fmpq_numref(t.raw()), fmpq_numref(t.raw()), fmpq_denref(t.raw()));
    a(i, 0) = FieldElement(field, {t});
  }
  return a;
}

/// The squared length of the part of the translation that the linear part fixes, in the metric: the square of the least
/// displacement. Precondition: the linear part has a finite order.
FieldElement least_displacement_squared(const SpaceForm& form, const FieldMatrix& a) {
  FieldMatrix linear(form.m), power = FieldMatrix::identity(form.m);
  for (std::size_t i = 0; i < form.m; ++i) {
    for (std::size_t k = 0; k < form.m; ++k) linear(i, k) = a(i + 1, k + 1);
  }
  std::vector<FieldElement> translation(form.m), sum(form.m);
  for (std::size_t i = 0; i < form.m; ++i) translation[i] = a(i + 1, 0);
  int order = 0;
  do {
    for (std::size_t i = 0; i < form.m; ++i) {
      for (std::size_t k = 0; k < form.m; ++k) sum[i] = sum[i] + power(i, k) * translation[k];
    }
    power = power * linear;
    ++order;
  } while (!(power == FieldMatrix::identity(form.m)));
  FieldElement result;
  for (std::size_t i = 0; i < form.m; ++i) {
    for (std::size_t k = 0; k < form.m; ++k) result = result + sum[i] * form.gram(i, k) * sum[k];
  }
  return result / FieldElement(order * order);
}

/// The value of an integer. Throws Undecided for one that is large.
std::int64_t small_integer(const FieldElement& x) {
  const Rational value = x.constant_term();
  if (fmpz_bits(fmpq_numref(value.raw())) > 40) throw Undecided("an integer of the group is too large");
  return fmpz_get_si(fmpq_numref(value.raw()));
}

/// Calls f(shift) for all integer vectors between the bounds.
template <class F>
void for_each_shift(std::size_t m, const std::vector<long>& first, const std::vector<long>& last, const F& f) {
  std::vector<long> z = first;
  for (;;) {
    f(z);
    std::size_t k = 0;
    while (k < m && z[k] == last[k]) {
      z[k] = first[k];
      ++k;
    }
    if (k == m) return;
    ++z[k];
  }
}

}  // namespace

/// Elements are z + the cosets found. Every displacement less than twice the injectivity radius occurs at a point of
/// the unit cell, which is at most `cell` from o; then the translation is at most 2 (injectivity radius + cell) long,
/// and its coordinates at most that times sqrt((G^-1)_kk).
Group flat_group(const SpaceForm& form, Report& report) {
  const FieldMatrix identity = FieldMatrix::identity(form.m + 1);
  std::vector<FieldMatrix> cosets{identity};
  // The letters are the generators and then the translations. A coset is known by a word, as exponents.
  Group group;
  group.letters = form.generators.size() + form.m;
  using Word = std::vector<std::int64_t>;
  std::map<FieldMatrix, Word> known{{identity, Word(group.letters)}};
  for (std::size_t at = 0; at < cosets.size() && known.size() <= most_cosets; ++at) {
    for (std::size_t letter = 0; letter < form.generators.size(); ++letter) {
      const FieldMatrix product = cosets[at] * form.generators[letter], coset = reduced(*form.field, product);
      // coset = (the translation back) product
      Word word = known.at(cosets[at]);
      ++word[letter];
      for (std::size_t k = 0; k < form.m; ++k)
        word[form.generators.size() + k] += small_integer(coset(k + 1, 0) - product(k + 1, 0));
      const auto [place, is_new] = known.emplace(coset, word);
      if (is_new) {
        cosets.push_back(coset);
      } else {
        for (std::size_t k = 0; k < group.letters; ++k) word[k] -= place->second[k];
        group.relations.push_back(std::move(word));
      }
    }
  }
  // g e g^-1 is the translation by (linear part) e.
  for (const FieldMatrix& generator : form.generators) {
    for (std::size_t column = 1; column <= form.m; ++column) {
      Word word(group.letters);
      for (std::size_t row = 1; row <= form.m; ++row)
        word[form.generators.size() + row - 1] = small_integer(generator(row, column)) - (row == column ? 1 : 0);
      group.relations.push_back(std::move(word));
    }
  }
  if (known.size() > most_cosets) throw Undecided("the group has too many elements modulo its lattice to look at");
  std::vector<double> stretch(form.m);
  double most_translation = 0;
  in_balls(128, [&] {
    const SquareMatrix<Ball> T = form.basis(), inverse = form.inverse_basis();
    Ball sum(0);
    for (std::size_t k = 0; k < form.m; ++k) {
      Vector<Ball> row{}, column{};
      for (std::size_t j = 0; j < form.m; ++j) {
        row[j] = inverse(k + 1, j + 1);
        column[j] = T(j + 1, k + 1);
      }
      const auto length = [&](const Vector<Ball>& x) {
        Ball squares(0);
        for (std::size_t j = 0; j < form.m; ++j) squares = squares + square(x[j]);
        return square_root(squares);
      };
      stretch[k] = length(row).enclosure().upper();
      sum = sum + length(column);
    }
    most_translation = (Ball(2) * (form.injectivity_radius.as<Ball>() + sum)).enclosure().upper();
  });
  const FieldElement least(*form.field, {square(Rational(2) * form.injectivity_radius.exact)});
  group.size = std::to_string(cosets.size()) + (cosets.size() == 1 ? " coset" : " cosets") + " of its lattice";
  group.summary = "a crystallographic group, " + group.size;
  std::vector<long> first(form.m), last(form.m);
  double number = static_cast<double>(cosets.size());
  for (std::size_t k = 0; k < form.m; ++k) {
    last[k] = static_cast<long>(std::ceil(std::min(most_translation * stretch[k], 1e6))) + 1;
    first[k] = -last[k];
    number *= 2.0 * static_cast<double>(last[k]) + 1;
  }
  if (!(number < 2e5)) throw Undecided("too many elements of the group to look at");
  for (const FieldMatrix& coset : cosets) {
    for_each_shift(form.m, first, last, [&](const std::vector<long>& z) {
      FieldMatrix element = coset;
      for (std::size_t k = 0; k < form.m; ++k)
        element(k + 1, 0) = element(k + 1, 0) + FieldElement(static_cast<int>(z[k]));
      if (element == identity) return;
      if (less(least_displacement_squared(form, element), least) != Verdict::proved) return;
      report.reject("group.injectivity", [&] {
        return "an element moves a point by less than twice the injectivity radius " +
               rounded_up(form.injectivity_radius.exact);
      });
    });
  }
  return group;
}

}  // namespace delcert::checker
