#pragma once

#include "properties/instances/net_object.hpp"

namespace delcert::test {

/// The integer points of the square [−n, n]², the origin first.
inline NetObject::Points square_points(long n) {
  NetObject::Points result{{Rational(0), Rational(0)}};
  for (long x = -n; x <= n; ++x) {
    for (long y = -n; y <= n; ++y) {
      if (x != 0 || y != 0) result.push_back({Rational(x), Rational(y)});
    }
  }
  return result;
}

/// The same as vectors.
inline std::vector<Vector<Rational, 2>> square_vectors(long n) {
  std::vector<Vector<Rational, 2>> result;
  for (const auto& point : square_points(n)) result.push_back({point[0], point[1]});
  return result;
}

}  // namespace delcert::test
