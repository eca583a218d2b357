#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "kernel/ranks/message.hpp"

namespace delcert {

/// One of several processes that make one triangulation: all of them call the same operations in the same order. What
/// is between the algorithm and MPI, or the threads of a test, or nothing.
class Communicator {
 public:
  virtual ~Communicator() = default;

  [[nodiscard]] virtual std::size_t rank() const = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Sends messages[r] to rank r, and returns what each rank has sent to this one, by ranks. Precondition: there are
  /// size() messages. Throws if another rank has ended.
  [[nodiscard]] virtual std::vector<Message> exchange(std::vector<Message> messages) = 0;
};

/// The messages of all ranks, by ranks, everywhere.
[[nodiscard]] inline std::vector<Message> gather_everywhere(Communicator& ranks, const Message& mine) {
  return ranks.exchange(std::vector<Message>(ranks.size(), mine));
}

/// The messages of all ranks at the first one, elsewhere empty ones.
[[nodiscard]] inline std::vector<Message> gather_at_first(Communicator& ranks, Message mine) {
  std::vector<Message> messages(ranks.size());
  messages[0] = std::move(mine);
  return ranks.exchange(std::move(messages));
}

/// What the first rank says, everywhere.
[[nodiscard]] inline Message of_first(Communicator& ranks, const Message& mine) {
  std::vector<Message> messages(ranks.size());
  if (ranks.rank() == 0) messages.assign(ranks.size(), mine);
  return ranks.exchange(std::move(messages))[0];
}

/// All values in one, in the order of ranks; the same everywhere. T is copied by its bytes.
template <class T, class Combine>
[[nodiscard]] T combined_everywhere(Communicator& ranks, const T& mine, const Combine& combine) {
  MessageWriter writer;
  writer.put(mine);
  const auto messages = gather_everywhere(ranks, writer.take());
  T result = MessageReader(messages[0]).get<T>();
  for (std::size_t rank = 1; rank < messages.size(); ++rank)
    result = combine(result, MessageReader(messages[rank]).get<T>());
  return result;
}

}  // namespace delcert
