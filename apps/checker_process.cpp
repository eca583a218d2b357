#include "apps/checker_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "apps/checker_path.hpp"

namespace delcert {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(int reason, const std::string& what) {
  throw std::system_error(reason, std::generic_category(), what);
}

}  // namespace

fs::path installed_checker() {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  const char* search_path = std::getenv("PATH");
  const auto candidates = checker_candidates(self, search_path == nullptr ? "" : search_path);
  fs::path checker = first_executable(candidates);
  if (!checker.empty()) return checker;
  std::string places;
  for (const fs::path& candidate : candidates) places += "\n  " + candidate.string();
  throw std::runtime_error("delcert-check is not installed; looked for" + places);
}

CheckerRun run_checker_with(const fs::path& checker, std::vector<std::string> arguments) {
  std::string program = checker.string();
  std::vector<char*> words{program.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "cannot make a pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  pid_t child = 0;
  const int reason = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  CheckerRun result;
  std::array<char, 4096> buffer{};
  while (reason == 0) {
    const ssize_t count = read(ends[0], buffer.data(), buffer.size());
    if (count > 0) result.output.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) break;
  }
  close(ends[0]);
  if (reason != 0) fail(reason, "cannot run " + program);
  int state = 0;
  while (waitpid(child, &state, 0) < 0) {
    if (errno != EINTR) fail(errno, "cannot wait for " + program);
  }
  result.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  return result;
}

CheckerRun run_checker_on(const fs::path& checker, const fs::path& certificate) {
  return run_checker_with(checker, {"--json", "--", certificate.string()});
}

}  // namespace delcert
