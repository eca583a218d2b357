#include "kernel/ranks/thread_ranks.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace delcert {

namespace {

/// Thrown in the ranks that wait for one that has ended.
struct AnotherRankHasEnded : std::runtime_error {
  AnotherRankHasEnded() : std::runtime_error("another rank has ended") {}
};

/// Where the messages of all ranks meet.
class Meeting {
 public:
  explicit Meeting(std::size_t count) : count_(count), sent_(count), received_(count) {}

  std::vector<Message> exchange(std::size_t rank, std::vector<Message> messages) {
    std::unique_lock lock(mutex_);
    if (has_ended_) throw AnotherRankHasEnded();
    sent_[rank] = std::move(messages);
    if (++arrived_ == count_) {
      arrived_ = 0;
      ++round_;
      for (std::size_t to = 0; to < count_; ++to) {
        received_[to].clear();
        for (std::size_t from = 0; from < count_; ++from) received_[to].push_back(std::move(sent_[from].at(to)));
      }
      changed_.notify_all();
    } else {
      const std::size_t round = round_;
      changed_.wait(lock, [&] { return has_ended_ || round_ != round; });
      if (round_ == round) throw AnotherRankHasEnded();
    }
    return std::move(received_[rank]);
  }

  /// The first of these is kept.
  void end_with(const std::exception_ptr& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
    has_ended_ = true;
    changed_.notify_all();
  }
  [[nodiscard]] const std::exception_ptr& error() const { return error_; }

 private:
  std::size_t count_;
  std::vector<std::vector<Message>> sent_, received_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t arrived_ = 0;
  std::size_t round_ = 0;
  bool has_ended_ = false;
  std::exception_ptr error_;
};

class ThreadRank final : public Communicator {
 public:
  ThreadRank(Meeting& meeting, std::size_t rank, std::size_t size) : meeting_(meeting), rank_(rank), size_(size) {}

  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::size_t size() const override { return size_; }
  [[nodiscard]] std::vector<Message> exchange(std::vector<Message> messages) override {
    return meeting_.exchange(rank_, std::move(messages));
  }

 private:
  Meeting& meeting_;
  std::size_t rank_, size_;
};

}  // namespace

void run_ranks_in_threads(std::size_t count, const std::function<void(Communicator&)>& work) {
  Meeting meeting(count);
  const auto run = [&](std::size_t rank) {
    ThreadRank communicator(meeting, rank, count);
    try {
      work(communicator);
    } catch (...) {
      meeting.end_with(std::current_exception());
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t rank = 1; rank < count; ++rank) threads.emplace_back(run, rank);
  run(0);
  for (std::thread& thread : threads) thread.join();
  if (meeting.error()) std::rethrow_exception(meeting.error());
}

}  // namespace delcert
