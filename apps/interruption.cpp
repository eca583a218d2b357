#include "apps/interruption.hpp"

#include <csignal>

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

}  // namespace delcert
