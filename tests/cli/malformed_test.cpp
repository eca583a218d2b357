#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/sample/point_file.hpp"
#include "support/error.hpp"

namespace delcert {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What the first line, "# expect: …", says.
std::string expectation_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  const std::string prefix = "# expect: ";
  return line.starts_with(prefix) ? line.substr(prefix.size()) : "a first line \"# expect: …\"";
}

void read(const fs::path& file) {
  if (file.extension() == ".toml") {
    (void)read_any_manifold(file);
  } else {
    (void)read_points(file, Dimension{2});
  }
}

class Malformed : public ::testing::TestWithParam<fs::path> {};

TEST_P(Malformed, is_refused_with_the_expected_message) {
  const std::string expectation = expectation_of(GetParam());
  try {
    read(GetParam());
    FAIL() << GetParam() << " was accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(expectation), std::string::npos) << "expected: " << expectation << "\nfound: " << message;
    EXPECT_NE(message.find(GetParam().string()), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

std::string name_of_case(const ::testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(manifold, Malformed, ::testing::ValuesIn(files_in(DELCERT_MALFORMED "/manifolds")),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(points, Malformed, ::testing::ValuesIn(files_in(DELCERT_MALFORMED "/points")), name_of_case);

/// The same reader accepts what is well formed.
TEST(WellFormed, examples_are_accepted) {
  const auto files = files_in(DELCERT_EXAMPLES "/manifolds");
  EXPECT_EQ(files.size(), 10U);
  for (const fs::path& file : files) EXPECT_NO_THROW(read(file)) << file;
  const auto forms = files_in(DELCERT_EXAMPLES "/manifolds/space-forms");
  EXPECT_EQ(forms.size(), 23U);
  for (const fs::path& file : forms) EXPECT_NO_THROW(read(file)) << file;
}

}  // namespace
}  // namespace delcert
