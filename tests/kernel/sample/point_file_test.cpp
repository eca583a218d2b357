#include "kernel/sample/point_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

PointList planar(std::string_view text) { return parse_points(text, Dimension{2}, "points.txt"); }

std::string message_for(std::string_view text) {
  try {
    (void)planar(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const PointList two_points{{Rational(1), fraction(-1, 2)}, {fraction(3, 8), Rational(0)}};

TEST(PointFile, reads_one_point_a_line) { EXPECT_EQ(planar("1 -1/2\n0x3p-3 0\n"), two_points); }

TEST(PointFile, tolerates_comments_blanks_carriage_returns_and_a_missing_last_line_end) {
  EXPECT_EQ(planar("# a comment\r\n\r\n \t1\t-1/2  # the first\r\n0x3p-3   0"), two_points);
}

TEST(PointFile, keeps_equal_points) { EXPECT_EQ(planar("0 0\n0 0\n").size(), 2U); }

TEST(PointFile, refuses_a_wrong_count_of_numbers) {
  EXPECT_EQ(message_for("1 2\n3\n"), "points.txt:2:2: found 1 number, expected a point of 2 numbers");
  EXPECT_EQ(message_for("1 2 3\n"), "points.txt:1:5: found more than 2 numbers, expected a point of 2 numbers");
  EXPECT_EQ(message_for("1 2 # 3\n"), "accepted");
}

TEST(PointFile, refuses_what_is_not_an_exact_number) {
  EXPECT_NE(message_for("1 2\n 3  0.5\n").find("points.txt:2:6: not an exact number: \"0.5\""), std::string::npos)
      << message_for("1 2\n 3  0.5\n");
  EXPECT_NE(message_for("1 x\n").find("points.txt:1:3: not an exact number: \"x\""), std::string::npos);
  EXPECT_NE(message_for("1,2\n").find("points.txt:1:2: not an exact number: \"1,2\""), std::string::npos);
  EXPECT_NE(message_for(std::string_view("1 \0\n", 4)).find("\\x00"), std::string::npos);
  EXPECT_NE(message_for("1 2\r3 4\n").find("points.txt:1:4: not an exact number"), std::string::npos);
}

TEST(PointFile, refuses_a_file_without_points) {
  EXPECT_EQ(message_for(""), "points.txt: no point found, expected one a line");
  EXPECT_EQ(message_for("# nothing\n\n"), "points.txt: no point found, expected one a line");
}

TEST(PointFile, refuses_files_that_cannot_be_read) {
  try {
    (void)read_points("no-such-file.txt", Dimension{2});
    FAIL() << "a missing file was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "cannot read no-such-file.txt: No such file or directory");
  }
  EXPECT_THROW((void)read_points(std::filesystem::temp_directory_path(), Dimension{2}), InputError);
}

TEST(PointFile, reads_from_a_file) {
  const test::TemporaryFolder folder;
  const auto path = folder / "points.txt";
  std::ofstream(path) << points_text(two_points);
  EXPECT_EQ(read_points(path, Dimension{2}), two_points);
}

RC_GTEST_PROP(PointFile, reads_back_what_it_writes, ()) {
  const int m = *rc::gen::inRange(1, 5);
  PointList points(*rc::gen::inRange<std::size_t>(1, 8));
  for (auto& point : points)
    for (int k = 0; k < m; ++k)
      point.push_back(Rational(*rc::gen::arbitrary<long>()) / Rational(*rc::gen::inRange<long>(1, 1000)) *
                      Rational::power_of_two(*rc::gen::inRange<long>(-200, 200)));
  RC_ASSERT(parse_points(points_text(points), Dimension{m}, "points.txt") == points);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
