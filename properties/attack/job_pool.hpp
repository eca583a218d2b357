#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace delcert {

/// One of several jobs, by its number. A long one may give up, in whatever way, when `stopping` is set.
using Job = std::function<void(std::size_t number, const std::atomic<bool>& stopping)>;

/// Does the jobs 0 … count − 1, begun in this order, on so many threads (from 1 to 256; fewer where the system has no
/// more). `report` is called from the calling thread, some ten times a second. What it throws passes through: no more
/// jobs are begun then, and those that are begun are told to stop and waited for. If jobs throw, no more are begun, and
/// what the first of them in order threw passes through, whatever the number of threads.
void run_jobs(std::size_t count, unsigned threads, const Job& job, const std::function<void()>& report);

}  // namespace delcert
