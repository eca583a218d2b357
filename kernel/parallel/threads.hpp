#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace delcert {

/// While one of these lives, parallel work takes at most this many threads at a time, the one that asks for it among
/// them, and that many even where there are fewer processors. Of several alive the least holds; they end in the reverse
/// order. Without one, as many as there are processors. No result depends on it.
class [[nodiscard]] ThreadLimit {
 public:
  /// 0: as many as there are processors.
  explicit ThreadLimit(unsigned threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// How many threads parallel work that is asked for now takes at most.
[[nodiscard]] unsigned thread_limit();

/// Calls part(0) … part(count − 1), each once, in any order, several at a time if the limit of threads is above 1, and
/// returns when all have returned. What was done before is seen by all of them, and what they do is seen afterwards.
/// Precondition: no part throws, or asks for parallel work.
void run_parts(std::size_t count, const std::function<void(std::size_t)>& part);

/// Throws std::runtime_error if this thread computes in a way that nothing may rest on, as `arithmetic_self_test`
/// finds, which is asked once in each thread. Precondition: rounding to nearest.
void require_fit_thread();

}  // namespace delcert
