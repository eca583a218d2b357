#include "support/host.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <vector>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Host, has_the_name_that_the_system_says) {
  std::ifstream stream("/proc/sys/kernel/hostname");
  std::string name;
  ASSERT_TRUE(std::getline(stream, name));
  EXPECT_EQ(host_name(), name);
}

/// Pages of this process in memory.
std::size_t resident_pages() {
  std::ifstream stream("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  stream >> all >> resident;
  return resident;
}

TEST(Host, gets_back_what_was_released) {
  // Pieces that the allocator keeps in one area, and one after them, which alone stays.
  constexpr std::size_t pieces = 200'000, size = 128;
  std::vector<std::unique_ptr<char[]>> kept;
  for (std::size_t at = 0; at < pieces; ++at) {
    kept.push_back(std::make_unique<char[]>(size));
    kept.back()[0] = 1;
  }
  const std::size_t before = resident_pages();
  kept.erase(kept.begin(), kept.end() - 1);
  return_free_memory();
#ifdef __GLIBC__
  EXPECT_LT(resident_pages() + pieces * size / 4096 / 2, before);
#else
  EXPECT_LE(resident_pages(), before);
#endif
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
