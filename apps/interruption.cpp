#include "apps/interruption.hpp"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "apps/exit_status.hpp"

namespace delcert {

namespace {

volatile std::sig_atomic_t interruption_requested = 0;

extern "C" void request_interruption(int) { interruption_requested = 1; }

}  // namespace

void catch_interruptions() {
  interruption_requested = 0;
  struct sigaction action {};
  action.sa_handler = request_interruption;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void throw_if_interrupted() {
  if (interruption_requested != 0) throw Interrupted();
}

InterruptionDeadline::InterruptionDeadline(std::string message, std::chrono::milliseconds grace)
    : message_(std::move(message)), grace_(grace), watcher_([this] { watch(); }) {}

InterruptionDeadline::~InterruptionDeadline() {
  {
    const std::scoped_lock lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  watcher_.join();
}

void InterruptionDeadline::watch() {
  constexpr std::chrono::milliseconds between_looks(50);
  std::unique_lock lock(mutex_);
  const auto is_over = [this] { return over_; };
  while (interruption_requested == 0) {
    if (changed_.wait_for(lock, between_looks, is_over)) return;
  }
  if (changed_.wait_for(lock, grace_, is_over)) return;
  report_error(std::cerr, message_);
  std::_Exit(static_cast<int>(ExitStatus::interrupted));
}

}  // namespace delcert
