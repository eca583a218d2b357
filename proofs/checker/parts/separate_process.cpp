#include "proofs/checker/parts/separate_process.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <system_error>
#include <utility>

namespace delcert::checker {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

[[noreturn]] void be_child(const std::function<int()>& function, const std::array<int, 2>& ends, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  int status = no_outcome;
  if (::getppid() == parent && ::dup2(ends[1], STDOUT_FILENO) >= 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    status = function();
    std::cout.flush();
  }
  ::_exit(status);
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 65536> part{};
  while (true) {
    const ssize_t size = ::read(descriptor, part.data(), part.size());
    if (size == 0 || (size < 0 && errno != EINTR)) return text;
    if (size > 0) text.append(part.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

SeparateProcess::SeparateProcess(const std::function<int()>& function) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) fail("no pipe");
  std::cout.flush();
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ == 0) be_child(function, ends, parent);
  ::close(ends[1]);
  output_ = ends[0];
  if (child_ < 0) {
    ::close(output_);
    fail("no process");
  }
}

SeparateProcess::~SeparateProcess() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::close(output_);
  ::waitpid(child_, nullptr, 0);
}

Ended SeparateProcess::end() {
  Ended ended;
  ended.output = read_all(output_);
  ::close(output_);
  int state = 0;
  const pid_t child = std::exchange(child_, -1);
  while (::waitpid(child, &state, 0) < 0) {
    if (errno != EINTR) fail("the process is lost");
  }
  ended.signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
  ended.status = WIFEXITED(state) ? WEXITSTATUS(state) : no_outcome;
  return ended;
}

}  // namespace delcert::checker
