#include "apps/ranks/mpi_communicator.hpp"

// The interface for C++ is no longer one of MPI.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace delcert {

namespace {

constexpr std::size_t most_at_once = std::size_t{1} << 29U;

/// Calls transfer(at, count, tag) for each piece.
template <class Transfer>
void in_pieces(std::size_t size, const Transfer& transfer) {
  int tag = 0;
  for (std::size_t at = 0; at < size; at += most_at_once)
    transfer(at, static_cast<int>(std::min(most_at_once, size - at)), tag++);
}

}  // namespace

// Where MPI fails, it ends all processes with a message of its own: that is how it comes.
MpiCommunicator::MpiCommunicator(int& argc, char**& argv) {
  int provided = 0;
  // Threads of a rank compute; only the first one calls MPI.
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  rank_ = static_cast<std::size_t>(rank);
  size_ = static_cast<std::size_t>(size);
}

MpiCommunicator::~MpiCommunicator() { MPI_Finalize(); }

std::vector<Message> MpiCommunicator::exchange(std::vector<Message> messages) {
  std::vector<std::uint64_t> sizes(size_), sizes_here(size_);
  for (std::size_t to = 0; to < size_; ++to) sizes[to] = messages.at(to).size();
  MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, sizes_here.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::vector<Message> result(size_);
  std::vector<MPI_Request> requests;
  for (std::size_t from = 0; from < size_; ++from) {
    if (from == rank_) continue;
    result[from].resize(sizes_here[from]);
    in_pieces(result[from].size(), [&](std::size_t at, int count, int tag) {
      MPI_Irecv(result[from].data() + at, count, MPI_BYTE, static_cast<int>(from), tag, MPI_COMM_WORLD,
                &requests.emplace_back());
    });
  }
  for (std::size_t to = 0; to < size_; ++to) {
    if (to == rank_) continue;
    in_pieces(messages[to].size(), [&](std::size_t at, int count, int tag) {
      MPI_Isend(messages[to].data() + at, count, MPI_BYTE, static_cast<int>(to), tag, MPI_COMM_WORLD,
                &requests.emplace_back());
    });
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  result[rank_] = std::move(messages[rank_]);
  return result;
}

void MpiCommunicator::end_all(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);
}

}  // namespace delcert
