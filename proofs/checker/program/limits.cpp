#include "proofs/checker/program/limits.hpp"

#include <flint/flint.h>
#include <gmp.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace delcert::checker {
namespace {

constexpr int undecided_status = 2;

// Written in advance: a handler may not allocate.
std::string words_of_time, words_of_memory;

[[noreturn]] void end_with(const std::string& words) {
  std::size_t written = 0;
  while (written < words.size()) {
    const ssize_t more = ::write(STDOUT_FILENO, words.data() + written, words.size() - written);
    if (more <= 0) break;
    written += static_cast<std::size_t>(more);
  }
  ::_exit(undecided_status);
}

void time_is_up(int) { end_with(words_of_time); }
[[noreturn]] void memory_is_up() { end_with(words_of_memory); }

void* owned(void* memory) {
  if (memory == nullptr) memory_is_up();
  return memory;
}
void* allocate(std::size_t size) { return owned(std::malloc(size > 0 ? size : 1)); }
void* allocate_zeros(std::size_t number, std::size_t size) {
  return owned(std::calloc(number > 0 ? number : 1, size > 0 ? size : 1));
}
void* reallocate(void* memory, std::size_t size) { return owned(std::realloc(memory, size > 0 ? size : 1)); }
void* reallocate_known(void* memory, std::size_t, std::size_t size) { return reallocate(memory, size); }
void free_known(void* memory, std::size_t) { std::free(memory); }

void set_timer(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
  if (seconds > 0 && timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;
  if (::setitimer(ITIMER_REAL, &timer, nullptr) != 0) throw std::runtime_error("the limit of time cannot be set");
}

}  // namespace

void limit_time(double seconds, const std::string& words) {
  words_of_time = words;
  std::signal(SIGALRM, time_is_up);
  set_timer(seconds);
}

void lift_time_limit() { set_timer(0); }

void limit_memory(std::uint64_t bytes, const std::string& words) {
  words_of_memory = words;
  std::set_new_handler(memory_is_up);
  mp_set_memory_functions(allocate, reallocate_known, free_known);
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, std::free);
#ifdef __GLIBC__
  ::mallopt(M_ARENA_MAX, 1);  // another thread sets none aside
#endif
  const rlimit limit{bytes, bytes};
  if (::setrlimit(RLIMIT_AS, &limit) != 0) throw std::runtime_error("the limit of memory cannot be set");
}

void keep_memory() {
#ifdef __GLIBC__
  constexpr int step = 1 << 24, much = 1 << 25;  // the most that is allowed
  ::mallopt(M_TOP_PAD, step);
  ::mallopt(M_MMAP_THRESHOLD, much);
  ::mallopt(M_TRIM_THRESHOLD, 8 * much);
#endif
}

}  // namespace delcert::checker
