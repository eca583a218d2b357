#include "kernel/ranks/shared_run.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

#include "support/error.hpp"
#include "tests/kernel/ranks/sphere_in_parts.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

void expect_same(const LocalMargins& found, const LocalMargins& expected) {
  EXPECT_EQ(found.protection, expected.protection);
  EXPECT_EQ(found.thickness, expected.thickness);
  EXPECT_EQ(found.circumradius, expected.circumradius);
  EXPECT_EQ(found.reach, expected.reach);
}

/// Points, stars, margins and what was repaired, bit by bit.
template <int m>
void compare(const WholeSphere<m>& whole, const PerturbationParameters& parameters, const RunRequest& request,
             std::size_t count) {
  const ChartRun<m> alone = run_in_charts<m>(whole.atlas, parameters, request, no_progress());
  ASSERT_TRUE(alone.is_certified());
  run_ranks_in_threads(count, [&](Communicator& ranks) {
    const PartOfSphere<m> part(ranks, whole);
    const LabelsHere& labels = part.labels;
    const SharedRun<m> run = run_shared<m>(ranks, labels, part.atlas, geometry_of<m>(part.atlas), parameters, request,
                                           nullptr, no_progress());
    for (std::uint32_t label = labels.own.first; label < labels.own.last; ++label) {
      const Label name(labels.names[label]);
      EXPECT_EQ(run.points.exact(Label(label)), alone.points.exact(name));
      auto star = run.complex.star(Label(label));
      for (auto& others : star) {
        for (std::uint32_t& other : others) other = labels.names[other];
      }
      EXPECT_EQ(star, alone.complex.star(name));
    }
    expect_same(run.margins, alone.margins);
    EXPECT_EQ(run.model.protection, alone.model.protection);
    EXPECT_EQ(run.model.circumradius, alone.model.circumradius);
    EXPECT_EQ(run.repair_rounds, alone.repair_rounds);
    EXPECT_EQ(run.repaired_points, alone.repaired_points);
  });
}

TEST(SharedRun, is_what_one_process_does) {
  const WholeSphere<2> whole(ratio(1, 14));
  for (const std::size_t count : {1U, 2U, 4U}) compare<2>(whole, measured_parameters(Dimension(2), 1), {}, count);
}

TEST(SharedRun, repairs_what_one_process_repairs) {
  const WholeSphere<2> whole(ratio(1, 14));
  auto parameters = measured_parameters(Dimension(2), 1);
  parameters.tolerance = Rational(0);
  parameters.clearance = Rational(0);
  parameters.choices = 1;
  const auto alone = run_in_charts<2>(whole.atlas, parameters, {}, no_progress());
  EXPECT_GT(alone.repair_rounds, 0);
  compare<2>(whole, parameters, {}, 3);
}

TEST(SharedRun, names_what_it_cannot_certify) {
  const WholeSphere<2> whole(ratio(1, 14));
  RunRequest request;
  request.required_protection = whole.radius / Rational(4);
  request.most_repair_rounds = 1;
  try {
    run_ranks_in_threads(3, [&](Communicator& ranks) {
      const PartOfSphere<2> part(ranks, whole);
      (void)run_shared<2>(ranks, part.labels, part.atlas, geometry_of<2>(part.atlas),
                          measured_parameters(Dimension(2), 1), request, nullptr, no_progress());
    });
    ADD_FAILURE() << "certified";
  } catch (const Rejection& rejection) {
    EXPECT_NE(std::string(rejection.what()).find("after 1 repair rounds"), std::string::npos) << rejection.what();
  }
}

/// A star that another rank tells wrongly is in no agreement with the stars here.
TEST(SharedRun, notices_a_star_that_is_not_what_its_rank_has) {
  const WholeSphere<2> whole(ratio(1, 14));
  RunRequest request;
  request.most_repair_rounds = 0;
  EXPECT_THROW(run_ranks_in_threads(2,
                                    [&](Communicator& ranks) {
                                      const PartOfSphere<2> part(ranks, whole);
                                      AlteredMessages altered(ranks, [&](std::size_t, auto& messages) {
                                        // An answer: the number of simplices of a star, then labels with their
                                        // elements, 0.
                                        if (ranks.rank() != 1 || messages[0].size() < 1000) return;
                                        const Message before = messages[0];
                                        MessageReader in(before);
                                        const auto simplices = in.get<std::uint32_t>();
                                        if (simplices < 3 || simplices > 12) return;
                                        const auto first = in.get<std::uint32_t>();
                                        const auto element = in.get<std::uint32_t>();
                                        const auto second = in.get<std::uint32_t>();
                                        if (element != 0 || first >= second || second >= whole.centres.size()) return;
                                        const std::uint32_t other = first == 0 ? 1 : first - 1;
                                        MessageWriter out;
                                        out.put(simplices);
                                        out.put(other);
                                        messages[0].replace(0, 8, out.take());
                                      });
                                      (void)run_shared<2>(altered, part.labels, part.atlas, geometry_of<2>(part.atlas),
                                                          measured_parameters(Dimension(2), 1), request, nullptr,
                                                          no_progress());
                                    }),
               std::exception);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
