#pragma once

#include <functional>

#include "kernel/ranks/communicator.hpp"

namespace delcert {

/// Runs the work of so many ranks in threads of this process, each with its own communicator, and returns when all have
/// ended. Where one throws, the others end at their next exchange, and what it has thrown is thrown on. The first rank
/// is run in this thread.
void run_ranks_in_threads(std::size_t count, const std::function<void(Communicator&)>& work);

}  // namespace delcert
