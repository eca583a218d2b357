#pragma once

#include <stdexcept>
#include <string>

namespace delcert {

/// Malformed input: says where (file, line, label), what was found and what was expected. Exit status 3.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Well-formed input for which the asked-for guarantee does not hold: names the item, the labels, the values.
/// Exit status 1.
class Rejection : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What could not be decided at the last rung. Exit status 2.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace delcert
