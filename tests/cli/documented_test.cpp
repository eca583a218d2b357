// The console sessions of README.md, ARTIFACT.md and docs/, run again: blocks that begin with ```console. Times in
// square brackets are not compared, and a line … stands for any lines. With DELCERT_RENEW in the environment pages are
// written anew, but for sessions with such a line.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

const std::string any_lines = "…";

/// What mpirun needs to start delcert-ranks here: as root, and with fewer processors than ranks. Empty without MPI.
const std::string ranks = std::string(DELCERT_RANKS_FOLDER).empty()
                              ? ""
                              : "export PATH=\"" DELCERT_RANKS_FOLDER
                                ":$PATH\" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                                "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1; ";

Lines lines_of(std::istream& stream) {
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The lines without what differs from run to run.
Lines comparable(Lines lines) {
  static const std::regex time(R"(\[[0-9]+\.[0-9]+ s\])");
  for (std::string& line : lines) line = std::regex_replace(line, time, "[… s]");
  return lines;
}

/// Whether what was printed is what is expected, where a line of any_lines stands for any lines.
bool matches(const Lines& expected, std::size_t e, const Lines& printed, std::size_t p) {
  if (e == expected.size()) return p == printed.size();
  if (expected[e] != any_lines)
    return p < printed.size() && expected[e] == printed[p] && matches(expected, e + 1, printed, p + 1);
  for (std::size_t next = p; next <= printed.size(); ++next) {
    if (matches(expected, e + 1, printed, next)) return true;
  }
  return false;
}
bool matches(const Lines& expected, const Lines& printed) {
  return matches(comparable(expected), 0, comparable(printed), 0);
}

/// A folder in which the sessions of a page run, with the examples of the project.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::temp_directory_path() / (name + std::to_string(::getpid()))) {
    fs::create_directories(path_);
    for (const char* linked : {"examples", "proofs", "tests"})
      fs::create_directory_symlink(fs::path(DELCERT_SOURCE) / linked, path_ / linked);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }

  /// What the command prints on either stream, when the programs are those that were just built.
  [[nodiscard]] Lines output_of(const std::string& command) const {
    const std::string shell_command = "cd '" + path_.string() +
                                      "' && delcert() { '" DELCERT_PROGRAM
                                      "' \"$@\"; }; delcert-check() { '" DELCERT_CHECK "' \"$@\"; }; " +
                                      ranks + "{ " + command + "\n} 2>&1";
    std::FILE* pipe = popen(("bash <<'END OF THE SESSION'\n" + shell_command + "\nEND OF THE SESSION\n").c_str(), "r");
    if (pipe == nullptr) return {"cannot run a shell"};
    std::string output;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) != 0;)
      output.append(buffer.data(), count);
    pclose(pipe);
    std::istringstream stream(output);
    return lines_of(stream);
  }

 private:
  fs::path path_;
};

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// The pages with a session, from the project's folder.
std::vector<std::string> pages() {
  std::vector<std::string> found;
  const fs::path source = DELCERT_SOURCE;
  const auto look_at = [&](const fs::path& path) {
    std::ifstream file(path);
    const Lines lines = lines_of(file);
    const bool needs_ranks =
        std::any_of(lines.begin(), lines.end(), [](const std::string& line) { return line.starts_with("$ mpirun "); });
    if (needs_ranks && ranks.empty()) return;
    if (std::find(lines.begin(), lines.end(), "```console") != lines.end())
      found.push_back(fs::relative(path, source).string());
  };
  for (const char* page : {"README.md", "ARTIFACT.md"}) look_at(source / page);
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") look_at(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Documented : public testing::TestWithParam<std::string> {};

TEST_P(Documented, commands_print_what_is_documented) {
  const fs::path path = fs::path(DELCERT_SOURCE) / GetParam();
  std::ifstream file(path);
  const Lines page = lines_of(file);
  const Folder folder(fs::path(GetParam()).stem().string());
  Lines renewed;
  bool in_console = false;
  std::size_t sessions = 0;
  for (std::size_t k = 0; k < page.size(); ++k) {
    renewed.push_back(page[k]);
    if (page[k].starts_with("```")) in_console = page[k] == "```console";
    if (!in_console || !page[k].starts_with("$ ")) continue;
    ++sessions;
    Lines expected;
    while (k + 1 < page.size() && !page[k + 1].starts_with("$ ") && !page[k + 1].starts_with("```"))
      expected.push_back(page[++k]);
    const std::string command = page[k - expected.size()].substr(2);
    const Lines printed = folder.output_of(command);
    EXPECT_TRUE(matches(expected, printed)) << "$ " << command << "\nprints\n" << joined(printed);
    const bool keep =
        std::find(expected.begin(), expected.end(), any_lines) != expected.end() || matches(expected, printed);
    const Lines& shown = keep ? expected : printed;
    renewed.insert(renewed.end(), shown.begin(), shown.end());
  }
  EXPECT_GE(sessions, 1U);
  if (std::getenv("DELCERT_RENEW") != nullptr) std::ofstream(path) << joined(renewed);
}

INSTANTIATE_TEST_SUITE_P(Pages, Documented, testing::ValuesIn(pages()), [](const auto& page) {
  std::string name = page.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(Sessions, that_print_something_else_are_noticed) {
  const Folder folder("sessions");
  const Lines version = folder.output_of("delcert --version");
  ASSERT_EQ(version.size(), 1U);
  EXPECT_TRUE(matches(version, version));
  EXPECT_TRUE(matches({any_lines, version[0]}, version));
  EXPECT_FALSE(matches({"delcert 0.0.0"}, version));
  EXPECT_FALSE(matches({}, version));
  EXPECT_FALSE(matches({version[0], any_lines, version[0]}, version));
  EXPECT_TRUE(matches({"a [0.10 s]"}, {"a [12.00 s]"}));
  EXPECT_FALSE(matches({"a [0.10 s] b"}, {"a [12.00 s] c"}));
  EXPECT_FALSE(matches(folder.output_of("delcert --versoin"), version));
}

TEST(Sessions, are_on_the_pages_that_users_begin_with) {
  const auto all = pages();
  for (const char* page : {"ARTIFACT.md", "docs/cli.md", "docs/bring-your-own-manifold.md", "docs/complex-file.md"})
    EXPECT_NE(std::find(all.begin(), all.end(), page), all.end()) << page;
}

}  // namespace
