#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

namespace delcert {

/// Thrown by long work that was asked to stop. Exit status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; nothing was written") {}
};

/// The same where finished parts are kept in a log.
class InterruptedWithLog : public Interrupted {
 public:
  explicit InterruptedWithLog(const std::string& log)
      : what_("interrupted; the same command goes on from what is finished in " + log) {}
  [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

/// From now on the first interrupt (Ctrl-C) or request to terminate only sets a flag; the second ends the program at
/// once.
void catch_interruptions();

/// While it lives, an interruption that nobody has acted on after the grace ends the program: one line
/// "delcert: error: …" with this message, and the exit status of Interrupted. For work that cannot ask in time, such as
/// one long decision by algebraic numbers. Nothing is cleaned up then: not for what leaves unfinished files behind.
class InterruptionDeadline {
 public:
  explicit InterruptionDeadline(std::string message = Interrupted().what(),
                                std::chrono::milliseconds grace = std::chrono::milliseconds(500));
  ~InterruptionDeadline();
  InterruptionDeadline(const InterruptionDeadline&) = delete;
  InterruptionDeadline& operator=(const InterruptionDeadline&) = delete;

 private:
  void watch();

  std::string message_;
  std::chrono::milliseconds grace_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread watcher_;
};

/// Throws Interrupted if the flag is set. Cheap enough for every round of a loop that does some work.
void throw_if_interrupted();

}  // namespace delcert
