#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {(std::istreambuf_iterator<char>(stream)), {}};
}

/// The parts of the checker, lowest first: the rows of the table of docs/decisions/size-of-the-checker.md.
std::vector<std::string> layers() {
  const std::string page = text_of(DELCERT_SOURCE_DIR "/docs/decisions/size-of-the-checker.md");
  const std::regex row(R"re((?:^|\n)\| `([a-z_]+)` \|)re");
  std::vector<std::string> result;
  for (std::sregex_iterator one(page.begin(), page.end(), row), end; one != end; ++one) result.push_back((*one)[1]);
  return result;
}

/// The folder of a file, or its stem if it is in none.
std::string layer_of(const fs::path& relative) { return relative.begin()->stem().string(); }

/// "metric.hpp -> run.hpp" for each file that includes one of a layer above its own, or of none.
std::vector<std::string> upward_includes(const fs::path& root, const std::vector<std::string>& layers) {
  const auto height = [&](const fs::path& relative) {
    return std::find(layers.begin(), layers.end(), layer_of(relative)) - layers.begin();
  };
  const std::regex include(R"re(#include "(proofs|kernel|support|properties)/([^"]*)")re");
  std::vector<std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(root / "proofs/checker")) {
    const auto extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    const fs::path file = fs::relative(entry.path(), root / "proofs/checker");
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator one(text.begin(), text.end(), include), end; one != end; ++one) {
      const std::string included = (*one)[1].str() + "/" + (*one)[2].str();
      const bool own = included.starts_with("proofs/checker/");
      if (!own || height(included.substr(15)) > height(file)) result.push_back(file.string() + " -> " + included);
    }
  }
  return result;
}

TEST(Layers, of_the_checker_include_only_those_below_them) {
  const std::vector<std::string> order = layers();
  EXPECT_GT(order.size(), 10u);
  for (const std::string& wrong : upward_includes(DELCERT_SOURCE_DIR, order)) ADD_FAILURE() << wrong;
}

TEST(Layers, notice_an_include_of_one_above_and_of_the_kernel) {
  const test::TemporaryFolder folder;
  const fs::path root = folder.path(), checker = root / "proofs/checker";
  fs::create_directories(checker / "low");
  fs::create_directories(checker / "high");
  std::ofstream(checker / "high/a.hpp") << "#include \"proofs/checker/low/b.hpp\"\n";
  std::ofstream(checker / "low/b.hpp") << "#include <vector>\n";
  EXPECT_EQ(upward_includes(root, {"low", "high"}), std::vector<std::string>{});
  EXPECT_EQ(upward_includes(root, {"high", "low"}), std::vector<std::string>{"high/a.hpp -> proofs/checker/low/b.hpp"});
  std::ofstream(checker / "low/b.hpp") << "#include \"kernel/number/interval.hpp\"\n";
  EXPECT_EQ(upward_includes(root, {"low", "high"}),
            std::vector<std::string>{"low/b.hpp -> kernel/number/interval.hpp"});
}

}  // namespace
}  // namespace delcert::checker_tests
