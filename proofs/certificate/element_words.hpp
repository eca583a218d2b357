#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "kernel/manifold/quotient/invariant_form.hpp"

namespace delcert {

/// Elements of a group of isometries as words in its letters, each by a shorter one and a letter after it
/// (docs/certificate-format.md, `elements`). Letters are the generators; of a flat form, then the m translations by the
/// basis of the lattice. Letter s > 0 is the s-th of them, −s its inverse.
class ElementWords {
 public:
  /// Hyperbolic: the generators and their inverses must be the side pairings of the Dirichlet polyhedron about o.
  ElementWords(const InvariantForm& form, const std::vector<FieldMatrix>& generators);

  /// The number of the element, 0 for the identity; with it, its prefixes come into the table. Precondition: it is in
  /// the group. Throws std::logic_error if no word is found.
  std::uint32_t number_of(const FieldMatrix& element);

  /// Of elements 1, 2, …: the number of a parent, which comes before, and the letter after it.
  [[nodiscard]] const std::vector<std::array<std::int32_t, 2>>& words() const { return words_; }
  [[nodiscard]] const FieldMatrix& matrix(std::uint32_t number) const { return matrices_[number]; }
  [[nodiscard]] std::size_t letter_count() const { return letters_.size(); }
  /// 1 ≤ |letter| ≤ letter_count().
  [[nodiscard]] const FieldMatrix& letter(std::int32_t letter) const;

 private:
  struct Last {
    FieldMatrix parent;
    std::int32_t letter;
  };
  /// An element as a parent and a letter, of which the parent is nearer to the identity.
  [[nodiscard]] Last last_letter(const FieldMatrix& element) const;
  [[nodiscard]] Last last_step_of_tiles(const FieldMatrix& element) const;
  [[nodiscard]] Last last_in_tree(const FieldMatrix& element) const;
  [[nodiscard]] FieldMatrix key_of(const FieldMatrix& element) const;
  void grow_tree();

  InvariantForm form_;
  std::size_t generators_;
  std::vector<FieldMatrix> letters_, inverses_;
  /// A finite group, or linear parts of a flat one: words by breadth first search.
  std::map<FieldMatrix, Last, Precedes> tree_;
  std::map<FieldMatrix, std::uint32_t, Precedes> numbers_;
  std::vector<FieldMatrix> matrices_;
  std::vector<std::array<std::int32_t, 2>> words_;
};

}  // namespace delcert
