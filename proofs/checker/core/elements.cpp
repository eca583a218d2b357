#include "proofs/checker/core/elements.hpp"

namespace delcert::checker::core {

Elements::Elements(const Data& data) : data_(data) {
  table_.push_back(find(FieldMatrix::identity(data.m + 1)));
  std::vector<FieldMatrix> inverses;
  for (const FieldMatrix& generator : data.generators) inverses.push_back(inverse_of(generator));
  for (const Word& word : data.words) {
    const auto& letters = word.letter > 0 ? data.generators : inverses;
    const auto at = static_cast<std::size_t>(std::abs(word.letter)) - 1;
    table_.push_back(find(*exact_[table_[word.parent]] * letters[at]));
  }
  for (const Lift& lift : data.translations) {
    FieldMatrix g = FieldMatrix::identity(data.m + 1);
    for (std::size_t k = 0; k < data.m; ++k) g(k + 1, 0) = FieldElement(lift[k]);
    table_.push_back(find(g));
  }
}

Elements::Id Elements::find(const FieldMatrix& g) {
  const auto [place, inserted] = ids_.try_emplace(g, static_cast<Id>(exact_.size()));
  if (inserted) {
    exact_.push_back(&place->first);
    inverse_.push_back(unknown);
    orientation_.push_back(0);
    filter_.emplace_back();
  }
  return place->second;
}

Elements::Id Elements::inverse(Id a) {
  if (inverse_[a] == unknown) {
    const Id b = find(inverse_of(*exact_[a]));
    inverse_[a] = b;
    inverse_[b] = a;
  }
  return inverse_[a];
}

Elements::Id Elements::computed_relative(Id a, Id b) {
  const auto [place, inserted] = relative_.try_emplace(std::uint64_t{a} << 32 | b, unknown);
  if (inserted) place->second = find(*exact_[inverse(a)] * *exact_[b]);
  return place->second;
}

int Elements::orientation(Id a) {
  if (orientation_[a] == 0) orientation_[a] = exact_[a]->leading_minor(data_.m + 1).sign();
  return orientation_[a];
}

template <class N>
Motion<N> Elements::motion(Id g) const {
  const FieldMatrix& exact = *exact_[g];
  Motion<N> result;
  if (data_.K != 0) {
    if constexpr (std::is_same_v<N, Ball>) result.linear = data_.in_standard_basis(exact);
    result.shifts = false;
    return result;
  }
  const auto as = [](const FieldElement& x) {
    if constexpr (std::is_same_v<N, Ball>) {
      return x.enclosure();
    } else {
      return x.constant_term();
    }
  };
  result.linear = SquareMatrix<N>(data_.m);
  result.turns = false;
  for (std::size_t i = 0; i < data_.m; ++i) {
    result.shift[i] = as(exact(i + 1, 0));
    for (std::size_t k = 0; k < data_.m; ++k) {
      result.linear(i, k) = as(exact(i + 1, k + 1));
      result.turns = result.turns || !(exact(i + 1, k + 1) == FieldElement(i == k ? 1 : 0));
    }
  }
  return result;
}
template Motion<Ball> Elements::motion<Ball>(Id) const;
template Motion<Rational> Elements::motion<Rational>(Id) const;

const Motion<Interval>& Elements::filter(Id g) {
  if (!filter_[g]) {
    auto result = std::make_unique<Motion<Interval>>();
    in_balls(128, [&] {
      const Motion<Ball> enclosed = motion<Ball>(g);
      const std::size_t order = enclosed.linear.order();
      result->linear = SquareMatrix<Interval>(order);
      for (std::size_t i = 0; i < order; ++i) {
        result->shift[i] = enclosed.shift[i].enclosure();
        for (std::size_t k = 0; k < order; ++k) result->linear(i, k) = enclosed.linear(i, k).enclosure();
      }
      result->turns = enclosed.turns;
      result->shifts = enclosed.shifts;
    });
    filter_[g] = std::move(result);
  }
  return *filter_[g];
}

}  // namespace delcert::checker::core
