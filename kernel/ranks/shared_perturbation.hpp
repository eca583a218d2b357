#pragma once

#include <utility>

#include "kernel/perturb/placement.hpp"
#include "kernel/ranks/block_log.hpp"
#include "kernel/ranks/part_of_net.hpp"

namespace delcert {

/// What `Perturbation` does, by several ranks, each of which places its own labels: after each colour they exchange
/// where the points of that colour are now that another rank has in its halo. The points are those of one process
/// (docs/ranks.md).
template <int m>
class SharedPerturbation {
 public:
  /// References are kept. The atlas is of the labels here. With a log, placing all goes on from what is in the logs of
  /// all ranks, and what is placed is added to it. Precondition: rounding to nearest.
  SharedPerturbation(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                     const PerturbationParameters& parameters, BlockLog* log = nullptr);

  /// Places every label. Throws Rejection as `Perturbation`, in the rank that has the label.
  void place_all(const Progress& progress);
  /// Takes these labels away, by their names, the same everywhere, and places them anew.
  void place_anew(const std::vector<std::uint32_t>& names, const Progress& progress);

  /// Own points where they are, those of the halo where their ranks have said that they are.
  [[nodiscard]] const PointSet<m>& points() const { return state_.points; }
  /// The same, for good: nothing is placed anew afterwards.
  [[nodiscard]] PointSet<m> take_points() { return std::move(state_.points); }
  /// Of what this rank did.
  [[nodiscard]] const PerturbationStatistics& statistics() const { return statistics_; }
  /// Of all ranks.
  [[nodiscard]] std::uint32_t colour_count() const { return colour_count_; }
  /// How many bytes were sent to other ranks.
  [[nodiscard]] std::uint64_t bytes_sent() const { return bytes_sent_; }

 private:
  void choose_colours(const Progress& progress);
  /// Places the own ones of these labels, of one colour, and exchanges them.
  void place_of_one_colour(const std::vector<Label>& own, std::string_view stage, const Progress& progress);
  void exchange(const std::vector<Label>& placed);
  /// Throws std::runtime_error, with both ranks, if a point of the halo is not where its rank has it.
  void compare_halos();
  /// What the logs of all ranks have; how many colours.
  [[nodiscard]] std::uint32_t restore();
  void add_to_log(const std::vector<Label>& placed);
  [[nodiscard]] std::vector<Message> exchanged(std::vector<Message> messages);

  Communicator& ranks_;
  const LabelsHere& labels_;
  const Atlas<m>& atlas_;
  PerturbationParameters parameters_;
  BlockLog* log_;
  PlacedPoints<m> state_;
  std::vector<std::uint32_t> colours_;             // of the labels here up to the last own one
  std::vector<std::vector<Label>> of_colour_;      // own labels
  std::vector<std::vector<std::uint32_t>> place_;  // of an own label, by ranks with it in their halo: (rank, position)
  std::uint32_t colour_count_ = 0;
  std::uint64_t bytes_sent_ = 0;
  PerturbationStatistics statistics_;
};

}  // namespace delcert
