#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// A block of the documentation between "```console" and "```": commands after "$ ", each followed by its output.
struct Session {
  std::string command;
  std::string output;
};

std::vector<Session> sessions_of(const std::string& path) {
  std::ifstream stream(path);
  std::vector<Session> sessions;
  bool in_console = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      in_console = line == "```console";
    } else if (in_console && line.starts_with("$ ")) {
      sessions.push_back({line.substr(2), ""});
    } else if (in_console && !sessions.empty()) {
      sessions.back().output += line + "\n";
    }
  }
  return sessions;
}

/// What the command prints on either stream, when `delcert` is the program that was just built.
std::string output_of(const std::string& command) {
  const std::string shell_command = "delcert() { '" DELCERT_PROGRAM "' \"$@\"; }; { " + command + "; } 2>&1";
  std::FILE* pipe = popen(shell_command.c_str(), "r");
  if (pipe == nullptr) return "cannot run a shell";
  std::string output;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) != 0;)
    output.append(buffer.data(), count);
  pclose(pipe);
  return output;
}

TEST(Documented, commands_print_what_the_documentation_shows) {
  for (const std::string page : {"cli.md", "complex-file.md"}) {
    const auto sessions = sessions_of(DELCERT_DOCUMENTATION + page);
    ASSERT_GE(sessions.size(), 2U);
    for (const Session& session : sessions) EXPECT_EQ(output_of(session.command), session.output) << session.command;
  }
}

TEST(Documented, commands_that_print_something_else_are_noticed) {
  EXPECT_NE(output_of("delcert --version"), "delcert 0.0.0\n");
  EXPECT_NE(output_of("delcert --versoin"), output_of("delcert --version"));
}

}  // namespace
