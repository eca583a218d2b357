#include "proofs/certificate/element_words.hpp"

#include <deque>
#include <stdexcept>

namespace delcert {

namespace {

/// Finite groups are no larger than this (kernel/manifold/quotient/space_form.cpp), lattices have fewer linear parts.
constexpr std::size_t greatest_tree = 2000;

FieldMatrix without_translation(FieldMatrix element) {
  for (std::size_t row = 1; row < element.order(); ++row) element(row, 0) = FieldElement(0);
  return element;
}

}  // namespace

ElementWords::ElementWords(const InvariantForm& form, const std::vector<FieldMatrix>& generators)
    : form_(form), generators_(generators.size()), letters_(generators) {
  const auto order = static_cast<std::size_t>(form.dimension()) + 1;
  if (form.curvature() == Curvature::zero) {
    for (std::size_t axis = 1; axis < order; ++axis) {
      letters_.push_back(FieldMatrix::identity(order));
      letters_.back()(axis, 0) = FieldElement(1);
    }
  }
  for (const FieldMatrix& letter : letters_) inverses_.push_back(form.inverse_of(letter));
  matrices_.push_back(FieldMatrix::identity(order));
  numbers_.emplace(matrices_.front(), 0);
  if (form.curvature() != Curvature::negative) grow_tree();
}

const FieldMatrix& ElementWords::letter(std::int32_t letter) const {
  return letter > 0 ? letters_.at(static_cast<std::size_t>(letter) - 1)
                    : inverses_.at(static_cast<std::size_t>(-letter) - 1);
}

std::uint32_t ElementWords::number_of(const FieldMatrix& element) {
  std::vector<Last> pending;
  FieldMatrix rest = element;
  auto known = numbers_.find(rest);
  for (; known == numbers_.end(); known = numbers_.find(rest)) {
    Last last = last_letter(rest);
    pending.push_back({rest, last.letter});
    rest = std::move(last.parent);
  }
  std::uint32_t number = known->second;
  for (auto step = pending.rbegin(); step != pending.rend(); ++step) {
    words_.push_back({static_cast<std::int32_t>(number), step->letter});
    number = static_cast<std::uint32_t>(matrices_.size());
    matrices_.push_back(step->parent);
    numbers_.emplace(step->parent, number);
  }
  return number;
}

FieldMatrix ElementWords::key_of(const FieldMatrix& element) const {
  return form_.curvature() == Curvature::zero ? without_translation(element) : element;
}

/// Breadth first in the Cayley graph of a finite group, of the group of linear parts for curvature 0; there the parent
/// is the whole element of the word.
void ElementWords::grow_tree() {
  const FieldMatrix identity = FieldMatrix::identity(static_cast<std::size_t>(form_.dimension()) + 1);
  tree_.emplace(identity, Last{identity, 0});
  std::deque<FieldMatrix> open{identity};
  for (; !open.empty(); open.pop_front()) {
    for (std::int32_t at = 1; at <= static_cast<std::int32_t>(generators_); ++at) {
      for (const std::int32_t step : {at, -at}) {
        const FieldMatrix next = open.front() * letter(step);
        if (!tree_.emplace(key_of(next), Last{open.front(), step}).second) continue;
        if (tree_.size() > greatest_tree) throw std::logic_error("a group has more elements than it was found to have");
        open.push_back(next);
      }
    }
  }
}

ElementWords::Last ElementWords::last_letter(const FieldMatrix& element) const {
  return form_.curvature() == Curvature::negative ? last_step_of_tiles(element) : last_in_tree(element);
}

/// A finite group: as in the tree. Curvature 0: translations come last in a word.
ElementWords::Last ElementWords::last_in_tree(const FieldMatrix& element) const {
  const auto found = tree_.find(key_of(element));
  if (found == tree_.end()) throw std::logic_error("a group element is no word in the generators");
  const Last& last = found->second;
  if (form_.curvature() != Curvature::zero) return last;
  const FieldMatrix word = last.letter == 0 ? last.parent : last.parent * letter(last.letter);
  const FieldMatrix translation = form_.inverse_of(word) * element;
  for (std::size_t axis = 1; axis < element.order(); ++axis) {
    const int sign = translation(axis, 0).sign();
    if (sign == 0) continue;
    const auto step = static_cast<std::int32_t>(generators_ + axis) * sign;
    return {element * letter(-step), step};
  }
  return last;
}

/// −γ⁻¹o is beyond a side: across it γo comes nearer to o.
ElementWords::Last ElementWords::last_step_of_tiles(const FieldMatrix& element) const {
  const auto displacement = [this](const FieldMatrix& a) {
    return approximate_double(form_.displacement_of_origin(a.column(0)).enclosure().lower());
  };
  double least = displacement(element);
  Last result{element, 0};
  for (std::int32_t at = 1; at <= static_cast<std::int32_t>(letters_.size()); ++at) {
    for (const std::int32_t step : {at, -at}) {
      FieldMatrix parent = element * letter(-step);
      const double remaining = displacement(parent);
      if (remaining >= least) continue;
      least = remaining;
      result = {std::move(parent), step};
    }
  }
  if (result.letter == 0) throw std::logic_error("a group element is no word in the side pairings");
  return result;
}

}  // namespace delcert
