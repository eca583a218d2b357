#include "support/utc_time.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using std::chrono::seconds;
using std::chrono::sys_seconds;

TEST(UtcTime, is_that_of_the_calendar) {
  EXPECT_EQ(utc_text(sys_seconds(seconds(0))), "1970-01-01T00:00:00Z");
  // date -u -d @1709210096 +%FT%TZ
  EXPECT_EQ(utc_text(sys_seconds(seconds(1709210096))), "2024-02-29T12:34:56Z");
}

TEST(UtcTime, comes_back_as_it_was) {
  for (const std::int64_t time : {0LL, 1709210096LL, 4102444799LL}) {
    const sys_seconds point{seconds(time)};
    EXPECT_EQ(parse_utc(utc_text(point)), point);
  }
}

TEST(UtcTime, that_is_none_is_refused) {
  for (const char* text :
       {"", "now", "2024-02-29 12:34:56", "2024-02-29T12:34:56", "2023-02-29T12:34:56Z", "2024-02-29T24:00:00Z",
        "2024-02-29T12:60:00Z", "2024-2-29T12:34:56Z", "2024-02-29T12:34:56Zulu"}) {
    EXPECT_THROW((void)parse_utc(text), InputError) << text;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
