#pragma once

// In place of kernel/number/interval.hpp where bench/plain is the first of the folders for headers.

#include "bench/plain/tolerant_double.hpp"

namespace delcert {

using Interval = TolerantDouble;

}  // namespace delcert
