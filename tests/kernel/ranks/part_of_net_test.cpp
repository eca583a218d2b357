#include "kernel/ranks/part_of_net.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>

#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"
#include "tests/kernel/ranks/sphere_in_parts.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(LabelsOfRanks, are_all_labels_in_whole_parts) {
  for (const std::size_t all : {64U, 100U, 1000U, 1009U}) {
    for (std::size_t ranks = 1; 16 * ranks <= all; ++ranks) {
      std::uint32_t next = 0;
      for (std::size_t rank = 0; rank < ranks; ++rank) {
        const LabelRange range = labels_of_rank(all, rank, ranks);
        EXPECT_EQ(range.first, next);
        EXPECT_EQ(range.first % usual_part_size, 0U);
        EXPECT_LT(range.size(), all / ranks + 2 * usual_part_size);
        for (std::uint32_t name = range.first; name < range.last; ++name) EXPECT_EQ(rank_of(name, all, ranks), rank);
        next = range.last;
      }
      EXPECT_EQ(next, all);
    }
  }
}

TEST(PartsOfNets, have_all_that_own_labels_see) {
  const WholeSphere<2> whole(ratio(1, 16));
  for (const std::size_t count : {1U, 2U, 3U, 7U}) {
    std::mutex mutex;
    std::set<std::uint32_t> owned;
    std::size_t known = 0;
    run_ranks_in_threads(count, [&](Communicator& ranks) {
      const PartOfSphere<2> part(ranks, whole);
      const LabelsHere& labels = part.labels;
      const std::lock_guard lock(mutex);
      EXPECT_EQ(labels.all, whole.centres.size());
      for (std::uint32_t here = 0; here < labels.size(); ++here) {
        EXPECT_EQ(part.part.centres[here], whole.centres[labels.names[here]]);
        EXPECT_EQ(labels.named(labels.names[here]), Label(here));
        EXPECT_TRUE(labels.from[rank_of(labels.names[here], labels.all, count)].contains(here));
      }
      known += labels.size();
      std::vector<Sighting<2>> seen, seen_in_whole;
      for (std::uint32_t own = labels.own.first; own < labels.own.last; ++own) {
        EXPECT_TRUE(owned.insert(labels.names[own]).second);
        EXPECT_EQ(own + labels.names_begin(), labels.names[own]);
        const double patch = approximate_double(whole.atlas.patch_radius());
        part.atlas.sightings(Label(own), patch, seen);
        whole.atlas.sightings(Label(labels.names[own]), patch, seen_in_whole);
        ASSERT_EQ(seen.size(), seen_in_whole.size());
        for (std::size_t at = 0; at < seen.size(); ++at)
          EXPECT_EQ(labels.names[seen[at].index], seen_in_whole[at].index);
      }
    });
    EXPECT_EQ(owned.size(), whole.centres.size());
    // And not all, though a patch is as wide as half a radius of the sphere.
    if (count == 7) {
      EXPECT_LT(known, 7 * whole.centres.size());
    }
  }
}

TEST(PartsOfNets, say_the_same_of_halos_on_both_sides) {
  const WholeSphere<2> whole(ratio(1, 16));
  std::mutex mutex;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::uint32_t>> shown, seen;
  run_ranks_in_threads(3, [&](Communicator& ranks) {
    const PartOfSphere<2> part(ranks, whole);
    const std::lock_guard lock(mutex);
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == ranks.rank()) continue;
      for (const std::uint32_t label : part.labels.shown_to[other])
        shown[{ranks.rank(), other}].push_back(part.labels.names[label]);
      for (std::uint32_t label = part.labels.from[other].first; label < part.labels.from[other].last; ++label)
        seen[{other, ranks.rank()}].push_back(part.labels.names[label]);
    }
  });
  EXPECT_EQ(shown.size(), 6U);
  EXPECT_EQ(shown, seen);
}

TEST(PartsOfNets, with_too_few_labels_are_refused) {
  const std::vector<Vector<Rational, 2>> few(31);
  EXPECT_THROW(run_ranks_in_threads(2, [&](Communicator& ranks) { (void)part_of_net<2>(ranks, few, 1); }), Rejection);
}

/// A halo that is too narrow would be noticed by the first of these tests.
TEST(PartsOfNets, with_a_narrow_halo_do_not_have_all_that_own_labels_see) {
  const WholeSphere<2> whole(ratio(1, 16));
  std::mutex mutex;
  std::size_t missed = 0;
  run_ranks_in_threads(4, [&](Communicator& ranks) {
    const auto part =
        part_of_net<2>(ranks, ranks.rank() == 0 ? whole.centres : std::vector<Vector<Rational, 2>>(), 0.01);
    std::vector<Sighting<2>> seen;
    const std::lock_guard lock(mutex);
    for (std::uint32_t own = part.labels.own.first; own < part.labels.own.last; ++own) {
      whole.atlas.sightings(Label(part.labels.names[own]), 0.2, seen);
      for (const auto& sighting : seen) missed += part.labels.named(sighting.index) ? 0U : 1U;
    }
  });
  EXPECT_GT(missed, 100U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
