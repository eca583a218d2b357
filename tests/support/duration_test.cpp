#include "support/duration.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Duration, is_read_with_its_unit) {
  EXPECT_EQ(parse_duration("90s"), seconds(90));
  EXPECT_EQ(parse_duration("45min"), seconds(2700));
  EXPECT_EQ(parse_duration("8h"), seconds(28800));
  EXPECT_EQ(parse_duration("366d"), seconds(31622400));
}

TEST(Duration, that_is_none_is_refused) {
  for (const char* text : {"", "8", "h", "8 h", "8hours", "8m", "0s", "-1s", "+1s", "1.5h", "367d",
                           "9223372036854775807d", "99999999999999999999s", "1h30min"}) {
    EXPECT_THROW((void)parse_duration(text), InputError) << text;
  }
}

TEST(Duration, is_written_as_people_say_it) {
  EXPECT_EQ(duration_text(milliseconds(0)), "0 s");
  EXPECT_EQ(duration_text(milliseconds(1)), "1 s");
  EXPECT_EQ(duration_text(milliseconds(119000)), "119 s");
  EXPECT_EQ(duration_text(milliseconds(119001)), "2 min");
  EXPECT_EQ(duration_text(seconds(7199)), "119 min");
  EXPECT_EQ(duration_text(seconds(17820)), "4 h 57 min");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
