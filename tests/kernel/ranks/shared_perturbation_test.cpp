#include "kernel/ranks/shared_perturbation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>

#include "kernel/perturb/colouring.hpp"
#include "kernel/perturb/perturbation.hpp"
#include "support/error.hpp"
#include "tests/kernel/ranks/sphere_in_parts.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
using Points = std::vector<Vector<Rational, m>>;

/// What the ranks have placed, in the order of names; and whether halos are what was placed.
template <int m>
Points<m> placed_by(std::size_t count, const WholeSphere<m>& whole, const PerturbationParameters& parameters,
                    const std::vector<std::uint32_t>& anew = {}) {
  Points<m> result(whole.centres.size());
  std::vector<std::pair<std::uint32_t, Vector<Rational, m>>> halos;
  std::mutex mutex;
  PerturbationStatistics statistics;
  run_ranks_in_threads(count, [&](Communicator& ranks) {
    const PartOfSphere<m> part(ranks, whole);
    SharedPerturbation<m> perturbation(ranks, part.labels, part.atlas, parameters);
    perturbation.place_all(no_progress());
    if (!anew.empty()) perturbation.place_anew(anew, no_progress());
    const std::lock_guard lock(mutex);
    statistics += perturbation.statistics();
    for (std::uint32_t label = 0; label < part.labels.size(); ++label) {
      const auto& point = perturbation.points().exact(Label(label));
      if (part.labels.own.contains(label)) {
        result[part.labels.names[label]] = point;
      } else {
        halos.emplace_back(part.labels.names[label], point);
      }
    }
  });
  EXPECT_EQ(statistics.placements, whole.centres.size() + anew.size());
  for (const auto& [name, point] : halos) EXPECT_EQ(point, result[name]);
  EXPECT_EQ(halos.empty(), count == 1);
  return result;
}

template <int m>
void compare(const WholeSphere<m>& whole, const std::vector<std::uint32_t>& anew) {
  const auto parameters = measured_parameters(Dimension(m), 1);
  Perturbation<m> alone(whole.atlas, parameters);
  alone.place_all(no_progress());
  std::vector<Label> labels;
  for (const std::uint32_t name : anew) labels.emplace_back(name);
  if (!anew.empty()) alone.place_anew(labels, no_progress());
  Points<m> expected;
  for (std::uint32_t label = 0; label < whole.centres.size(); ++label)
    expected.push_back(alone.points().exact(Label(label)));
  for (const std::size_t count : {1U, 2U, 3U, 4U})
    EXPECT_EQ(placed_by<m>(count, whole, parameters, anew), expected) << count;
}

TEST(SharedPerturbation, places_points_where_one_process_does) {
  compare<2>(WholeSphere<2>(ratio(1, 12)), {});
  compare<2>(WholeSphere<2>(ratio(1, 12), 3), {0, 17, 300, 301, 302, 700});
}

/// Without what one rank tells another in one exchange, or with another point than it has.
TEST(SharedPerturbation, notices_an_exchange_that_is_left_out_or_wrong) {
  const WholeSphere<2> whole(ratio(1, 12));
  const auto parameters = measured_parameters(Dimension(2), 1);
  enum class Fault { none, left_out, other_point };
  for (const Fault fault : {Fault::none, Fault::left_out, Fault::other_point}) {
    bool was_there = false;
    const auto run = [&] {
      run_ranks_in_threads(3, [&](Communicator& ranks) {
        const PartOfSphere<2> part(ranks, whole);
        AlteredMessages altered(ranks, [&](std::size_t exchange, std::vector<Message>& messages) {
          // Three turns of colours, how many there are, what is restored; then one for each colour.
          if (ranks.rank() != 1 || exchange != 8 || messages[0].empty()) return;
          was_there = true;
          if (fault == Fault::left_out) messages[0].clear();
          // The position, the form of the number, a low digit of the first coordinate.
          if (fault == Fault::other_point) messages[0].at(7) = static_cast<char>(messages[0].at(7) ^ 1);
        });
        SharedPerturbation<2> perturbation(altered, part.labels, part.atlas, parameters);
        perturbation.place_all(no_progress());
      });
    };
    if (fault == Fault::none) {
      EXPECT_NO_THROW(run());
    } else {
      try {
        run();
        ADD_FAILURE() << "not noticed";
      } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("the halo of rank"), std::string::npos) << error.what();
      }
    }
    EXPECT_TRUE(was_there);
  }
}

TEST(SharedPerturbation, refuses_points_that_are_not_in_the_halo) {
  const WholeSphere<2> whole(ratio(1, 12));
  const auto parameters = measured_parameters(Dimension(2), 1);
  EXPECT_THROW(run_ranks_in_threads(
                   2,
                   [&](Communicator& ranks) {
                     const PartOfSphere<2> part(ranks, whole);
                     AlteredMessages altered(ranks, [&](std::size_t exchange, auto& messages) {
                       if (ranks.rank() == 1 && exchange == 6) messages[0].at(3) = 1;
                     });
                     SharedPerturbation<2>(altered, part.labels, part.atlas, parameters).place_all(no_progress());
                   }),
               std::runtime_error);
}

/// As if ranks had been killed after different numbers of colours.
TEST(SharedPerturbation, goes_on_from_what_all_logs_have) {
  const WholeSphere<2> whole(ratio(1, 12));
  const auto parameters = measured_parameters(Dimension(2), 1);
  const TemporaryFolder folder;
  std::vector<Points<2>> results;
  std::vector<std::uint64_t> placements(3, 0);
  for (std::size_t attempt = 0; attempt < 3; ++attempt) {
    results.emplace_back(whole.centres.size());
    std::mutex mutex;
    run_ranks_in_threads(3, [&](Communicator& ranks) {
      const PartOfSphere<2> part(ranks, whole);
      BlockLog log(folder / std::to_string(ranks.rank()), "run");
      if (attempt == 1) log.keep(10 + 3 * ranks.rank());
      SharedPerturbation<2> perturbation(ranks, part.labels, part.atlas, parameters, &log);
      perturbation.place_all(no_progress());
      perturbation.place_anew({5, 6, 400}, no_progress());
      EXPECT_EQ(log.pieces().size(), perturbation.colour_count());
      const std::lock_guard lock(mutex);
      placements[attempt] += perturbation.statistics().placements;
      for (std::uint32_t label = part.labels.own.first; label < part.labels.own.last; ++label)
        results.back()[part.labels.names[label]] = perturbation.points().exact(Label(label));
    });
  }
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
  EXPECT_EQ(placements[0], whole.centres.size() + 3);
  EXPECT_EQ(placements[2], 3U);
  // Those of ten colours were there.
  const auto colours = colours_of<2>(whole.atlas, Placement<2>::reach(parameters), no_progress());
  EXPECT_EQ(placements[1], 3 + static_cast<std::uint64_t>(std::count_if(
                                   colours.begin(), colours.end(), [](std::uint32_t colour) { return colour >= 10; })));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
