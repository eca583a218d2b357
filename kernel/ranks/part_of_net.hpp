#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/chart/label_range.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/ranks/communicator.hpp"

namespace delcert {

/// The labels of a rank: so many of all, one after the other, about the same number for each. They begin at a multiple
/// of `usual_part_size`, by which loops over labels are divided among threads, too.
[[nodiscard]] LabelRange labels_of_rank(std::size_t all, std::size_t rank, std::size_t ranks);
/// The rank that has this label.
[[nodiscard]] std::size_t rank_of(std::uint32_t name, std::size_t all, std::size_t ranks);

/// The labels that a rank knows: its own, and those of other ranks near them, its halo. They are numbered anew, from 0
/// on, in the same order; what a label is called in the whole is its name.
struct LabelsHere {
  std::size_t all = 0;               ///< of the whole
  std::vector<std::uint32_t> names;  ///< increasing
  LabelRange own;
  std::vector<LabelRange> from;  ///< by ranks: the labels here that belong to it
  /// By ranks: the own labels in the halo of this rank, increasing. They are `from` there, in this order.
  std::vector<std::vector<std::uint32_t>> shown_to;

  [[nodiscard]] std::size_t size() const { return names.size(); }
  [[nodiscard]] std::uint32_t name(Label here) const { return names[here.value]; }
  /// None if it is not here.
  [[nodiscard]] std::optional<Label> named(std::uint32_t name) const;
  /// What is added to an own label for its name.
  [[nodiscard]] std::uint32_t names_begin() const { return own.size() == 0 ? 0 : names[own.first] - own.first; }
};

/// The labels here, with the points of a net that they are.
template <int m>
struct PartOfNet {
  LabelsHere labels;
  std::vector<std::array<Rational, static_cast<std::size_t>(m)>> centres;
};

/// Divides a net on the sphere, which the first rank has until it is divided, in conformal coordinates, in an order in
/// which neighbours are near each other. The halo are the labels less than `distance` away from an own one, and some
/// more, by cells of the space around. Throws Rejection if there are fewer labels than 16 for each rank. Precondition:
/// rounding to nearest.
template <int m>
[[nodiscard]] PartOfNet<m> part_of_net(Communicator& ranks,
                                       std::vector<std::array<Rational, static_cast<std::size_t>(m)>> whole,
                                       double distance);

}  // namespace delcert
