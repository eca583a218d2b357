#pragma once

#include "kernel/ranks/communicator.hpp"

namespace delcert {

/// The processes that mpirun has started: all of MPI that the project uses. One lives from the beginning of main to its
/// end.
class MpiCommunicator final : public Communicator {
 public:
  MpiCommunicator(int& argc, char**& argv);
  ~MpiCommunicator() override;
  MpiCommunicator(const MpiCommunicator&) = delete;
  MpiCommunicator& operator=(const MpiCommunicator&) = delete;

  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::size_t size() const override { return size_; }
  /// Messages of any length, in pieces of less than a gigabyte, as MPI counts bytes by an int.
  [[nodiscard]] std::vector<Message> exchange(std::vector<Message> messages) override;

  /// Ends all processes with this status.
  [[noreturn]] void end_all(int status);

 private:
  std::size_t rank_ = 0;
  std::size_t size_ = 1;
};

}  // namespace delcert
