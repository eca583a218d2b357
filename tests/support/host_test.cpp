#include "support/host.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Host, has_the_name_that_the_system_says) {
  std::ifstream stream("/proc/sys/kernel/hostname");
  std::string name;
  ASSERT_TRUE(std::getline(stream, name));
  EXPECT_EQ(host_name(), name);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
