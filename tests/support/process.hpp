#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/content_of.hpp"

namespace delcert::test {

/// A program on its own, its streams in files.
class Process {
 public:
  Process(std::vector<std::string> arguments, std::filesystem::path streams) : streams_(std::move(streams)) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    std::filesystem::create_directories(streams_);
    id_ = ::fork();
    if (id_ != 0) return;
    redirect(STDOUT_FILENO, "output");
    redirect(STDERR_FILENO, "error");
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  ~Process() {
    if (!over_) {
      ::kill(id_, SIGKILL);
      wait();
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Until then a signal ends the program as it ends any program that has not begun to work.
  void wait_until_it_catches(int signal) {
    while (!has_ended()) {
      std::ifstream status("/proc/" + std::to_string(id_) + "/status");
      for (std::string line; std::getline(status, line);) {
        constexpr std::string_view key = "SigCgt:";
        if (!line.starts_with(key)) continue;
        const unsigned long caught = std::stoul(line.substr(key.size()), nullptr, 16);
        if (((caught >> (signal - 1)) & 1U) != 0) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] bool has_ended() {
    if (!over_) over_ = ::waitpid(id_, &status_, WNOHANG) == id_;
    return over_;
  }
  void send(int signal) {
    if (!has_ended()) ::kill(id_, signal);
  }
  /// The exit status; minus the number of the signal if one ended it.
  int wait() {
    if (!over_) ::waitpid(id_, &status_, 0);
    over_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  }
  [[nodiscard]] ::pid_t id() const { return id_; }
  [[nodiscard]] std::string output() const { return content_of(streams_ / "output"); }
  [[nodiscard]] std::string error() const { return content_of(streams_ / "error"); }

 private:
  void redirect(int stream, const char* name) const {
    const int file = ::open((streams_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || ::dup2(file, stream) < 0) ::_exit(126);
  }

  std::filesystem::path streams_;
  ::pid_t id_ = -1;
  int status_ = 0;
  bool over_ = false;
};

}  // namespace delcert::test
