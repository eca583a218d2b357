#pragma once

#include <cstdint>
#include <string>

namespace delcert::checker {

/// From now on the process ends with exit status 2, undecided, after it has written these words to the standard output,
/// when so many seconds have passed. At most one limit of time, and one of memory, is in force.
void limit_time(double seconds, const std::string& words);
/// The limit of time is lifted, so that what is written next is written whole.
void lift_time_limit();

/// The same when more than so many bytes of memory would be in use, by whatever library. Call it before any number of
/// FLINT or GMP exists.
void limit_memory(std::uint64_t bytes, const std::string& words);
/// Without a limit memory is asked of the system in large steps, and kept: large pages take less time to get, and to
/// share with processes that begin later.
void keep_memory();

}  // namespace delcert::checker
