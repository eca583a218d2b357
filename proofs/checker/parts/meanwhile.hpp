#pragma once

#include <future>
#include <system_error>

#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {

/// Does some work in another thread, if a check may divide its work and there is such a thread; else when its result is
/// asked for. Either way `get` returns or throws what the work does. Precondition: until then nobody changes what the
/// work looks at, or looks at what it changes, and no process begins; the work decides nothing, spends nothing and
/// rounds nothing.
template <class Work>
auto meanwhile(const Work& work) {
  try {
    if (most_parts > 1) return std::async(std::launch::async, work);
  } catch (const std::system_error&) {  // there is none
  }
  return std::async(std::launch::deferred, work);
}

}  // namespace delcert::checker
