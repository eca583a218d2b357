#include "proofs/replay/statement.hpp"

#include <gtest/gtest.h>

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

std::vector<std::string> goals(const std::vector<std::string>& hypotheses, const std::string& claim) {
  std::vector<NodePointer> read;
  for (const std::string& hypothesis : hypotheses) read.push_back(read_statement(hypothesis));
  std::vector<std::string> result;
  for (const NodePointer& goal : goals_of(read, read_statement(claim))) result.push_back(text_of(*goal));
  return result;
}

using Texts = std::vector<std::string>;

TEST(ReplayStatements, are_read_and_written) {
  for (const char* text : {"(<= (* x (- 1 x)) (/ 1 4))", "(and (not (< x 1)) (implies (> (max x 1 2) 0) (= x x)))"}) {
    EXPECT_EQ(text_of(*read_statement(text)), text);
  }
  for (const char* wrong : {"", "(", "(<= x)", "(<= x 1", "(<= x 1) 2", "(foo x 1)", "(<= x 1 2)", "()", "(- )"}) {
    EXPECT_THROW((void)read_statement(wrong), Malformed) << wrong;
  }
}

TEST(ReplayStatements, fall_apart_into_goals) {
  EXPECT_EQ(goals({"(< x y)"}, "(and (< x 1) (implies (> y 1) (and (< x 2) (< y 2))))"),
            (Texts{"(implies (< x y) (< x 1))", "(implies (< x y) (implies (> y 1) (< x 2)))",
                   "(implies (< x y) (implies (> y 1) (< y 2)))"}));
  EXPECT_EQ(goals({}, "(<= (max x y) 1)"), (Texts{"(<= x 1)", "(<= y 1)"}));
  EXPECT_EQ(goals({}, "(>= (max x (/ 1 y)) 1)"), (Texts{"(= (/ 1 y) (/ 1 y))", "(or (>= x 1) (>= (/ 1 y) 1))"}));
  EXPECT_EQ(goals({}, "(> 2 (abs x))"), (Texts{"(> 2 x)", "(> 2 (- x))"}));
  EXPECT_EQ(goals({}, "(< 2 (min x y))"), (Texts{"(< 2 x)", "(< 2 y)"}));
  EXPECT_EQ(goals({}, "(< (min x y) 2)"), (Texts{"(or (< x 2) (< y 2))"}));
}

TEST(ReplayStatements, have_kleene_s_truth) {
  const NodePointer statement = read_statement("(or (not (< x 1)) (and (< x 2) (> x 0)))");
  EXPECT_EQ(comparisons_of(*statement).size(), 3U);
  EXPECT_EQ(truth_of(*statement, {0, 1, 1}), 1);
  EXPECT_EQ(truth_of(*statement, {-1, 0, -1}), 1);
  EXPECT_EQ(truth_of(*statement, {1, 0, -1}), -1);
  EXPECT_EQ(truth_of(*statement, {1, 0, 1}), 0);
  EXPECT_EQ(truth_of(*read_statement("(implies (< x 1) (< x 2))"), {-1, 0}), 1);
  EXPECT_THROW((void)comparisons_of(*read_statement("(+ x 1)")), Malformed);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
