#include "proofs/formula/point_rules.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"
#include "tests/support/ratio.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string head = "name = 'n'\ninstance = 'point-set'\n";
const std::string show = "[[show]]\nclaim = 'n >= 1'\n";

Claim parsed(const std::string& text) {
  return parse_claim(
      text, "a.toml", full_vocabulary(),
      {{"point-set", instance_class("point-set").signature()}, {"simplex", instance_class("simplex").signature()}});
}

std::string error_of(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PointRules, all_keys_are_read_and_become_hypotheses) {
  const Claim claim = parsed(head +
                             "[points]\nnumber = '3 .. 5'\ndimension = 2\nbox = ['[0, 1]', '(-1/2, 2)']\n"
                             "constraints = ['edge(p, 0, 1) >= 1/4']\nleast_acceptance = '1/3'\n" +
                             show);
  ASSERT_TRUE(claim.points.has_value());
  EXPECT_EQ(claim.points->number.least, 3);
  EXPECT_EQ(claim.points->number.most, 5);
  EXPECT_EQ(claim.points->dimension.most, 2);
  EXPECT_EQ(claim.points->box_of(1).lower, test::ratio(-1, 2));
  EXPECT_EQ(claim.points->least_acceptance, test::ratio(1, 3));
  ASSERT_EQ(claim.hypotheses.size(), 3U);
  EXPECT_EQ(claim.hypotheses[1].text, "forall p_i in vertices(p): -(1/2) < coordinate(vertex(p, p_i), 1) < 2");
  EXPECT_EQ(claim.hypotheses[2].text, "edge(p, 0, 1) >= 1/4");
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    EXPECT_TRUE(hypothesis.is_constraint);
    EXPECT_FALSE(hypothesis.no_twin.empty());
  }
}

TEST(PointRules, are_read_back_from_their_text) {
  const std::string rules =
      "number = 3\ndimension = '2 .. 3'\nbox = '[-1, 1)'\nconstraints = ['thickness(p) > 0', 'm >= 2']\n";
  const Claim claim = parsed(head + "[points]\n" + rules + show);
  const std::string text = point_rules_text(*claim.points);
  const Claim again = parsed(head + "[points]\n" + text + show);
  EXPECT_EQ(point_rules_text(*again.points), text);
  EXPECT_EQ(again.hypotheses.size(), claim.hypotheses.size());
  EXPECT_FALSE(again.points->box_of(1).has_upper);
}

TEST(PointRules, are_refused_where_they_are_wrong) {
  const std::string good = "number = 3\ndimension = 2\nbox = '[0, 1]'\n";
  EXPECT_EQ(error_of(head + "[points]\n" + good + show), "accepted");
  EXPECT_EQ(error_of("name = 'n'\ninstance = 'simplex'\n[points]\n" + good + show),
            "a.toml:3:1: the key points is for claims about the class point-set");
  EXPECT_EQ(error_of(head + "[points]\nnumber = 13\ndimension = 2\nbox = '[0, 1]'\n" + show),
            "a.toml:4:10: the key number expects an integer from 1 to 12, or a range of them such as \"2 .. 3\"");
  EXPECT_EQ(error_of(head + "[points]\nnumber = '3 .. 2'\ndimension = 2\nbox = '[0, 1]'\n" + show),
            "a.toml:4:10: the key number expects an integer from 1 to 12, or a range of them such as \"2 .. 3\"");
  EXPECT_EQ(error_of(head + "[points]\nnumber = 3\ndimension = 2\nbox = '[0, infinity)'\n" + show),
            "a.toml:6:7: a box is bounded: points are drawn from it");
  EXPECT_EQ(error_of(head + "[points]\nnumber = 3\ndimension = 2\nbox = ['[0, 1]']\n" + show),
            "a.toml:6:7: a box of 1 side is for dimension 1; one interval in quotes is for every coordinate in any "
            "dimension");
  EXPECT_EQ(error_of(head + "[points]\n" + good + "constraints = ['edge(p, 0, 1) >= l']\n" + show),
            "a.toml:7:34: nothing here is called l (there are m, n, p)");
  EXPECT_EQ(error_of(head + "[points]\n" + good + "least_acceptance = '3/2'\n" + show),
            "a.toml:7:20: least_acceptance is a share, from 0 to 1");
  EXPECT_NE(error_of(head + "[points]\n" + good + "colour = 1\n" + show).find("a.toml:7:1: "), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
