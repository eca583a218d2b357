#include "kernel/manifold/group_reader.hpp"

#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// What is read of a whole file by `read(reader, table)`.
template <class Read>
auto read_from(const std::string& text, const Read& read) {
  const GroupReader reader(text, "x.toml");
  const toml::table table = reader.parse();
  return read(reader, table);
}

const auto form_of = [](const GroupReader& reader, const toml::table& table) {
  return reader.form(table, reader.field(table));
};

TEST(GroupReader, reads_forms_over_a_field) {
  const InvariantForm form = read_from(
      "dimension = 2\ncurvature = -1\nfield = \"t^2 - 2\"\nroot = [1, 2]\ntime = \"-2*t + 2\"\ngram = [[\"t\", 0], [0, "
      "1]]",
      form_of);
  EXPECT_EQ(form.curvature(), Curvature::negative);
  EXPECT_EQ(form.time().text(), "-2*t + 2");
  EXPECT_EQ(form.gram()(0, 0).text(), "t");
  EXPECT_EQ(form.gram()(1, 1), FieldElement(1));
}

TEST(GroupReader, takes_the_standard_form_where_nothing_else_is_said) {
  const InvariantForm form = read_from("dimension = 3\ncurvature = 1", form_of);
  EXPECT_EQ(form.dimension(), 3);
  EXPECT_EQ(form.time(), FieldElement(1));
  EXPECT_TRUE(is_identity(form.gram()));
}

TEST(GroupReader, says_what_is_wrong_and_where) {
  const auto refusal = [](const std::string& text) {
    return message_of<InputError>([&] { (void)read_from(text, form_of); });
  };
  EXPECT_TRUE(mentions(refusal("dimension = 4\ncurvature = 0"), "x.toml:1:13: key \"dimension\": found the integer 4"));
  EXPECT_TRUE(mentions(refusal("dimension = 2\ncurvature = -1\ntime = 1"), "x.toml:3:8: key \"time\""));
  EXPECT_TRUE(mentions(refusal("dimension = 2\ncurvature = 0\ngram = [[1, 1], [1, 1]]"), "not positive definite"));
  EXPECT_TRUE(mentions(refusal("dimension = 2\ncurvature = 0\nfield = \"t^2 - 4\"\nroot = [1, 3]"), "is reducible"));
  EXPECT_TRUE(mentions(refusal("dimension = 2\ncurvature = 0\ngram = [[\"t\", 0], [0, 1]]"),
                       "key \"gram\", row 1, entry 1: found \"t\", expected a rational number"));
  EXPECT_TRUE(mentions(refusal("dimension = 2\ncurvature = 0\ngram = [[1.5, 0], [0, 1]]"), "expected an exact number"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
