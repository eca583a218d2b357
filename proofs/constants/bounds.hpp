#pragma once

#include "kernel/number/rational.hpp"

namespace delcert {

/// Rational numbers between which a real number lies; equal where it is known exactly.
struct Bounds {
  Rational lower;
  Rational upper;
};

}  // namespace delcert
