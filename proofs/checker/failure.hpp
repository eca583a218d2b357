#pragma once

#include <stdexcept>
#include <string>

namespace delcert::checker {

/// The file is not a certificate of this format: exit status 3. `rule` is "form.*" or "seal".
struct Malformed : std::runtime_error {
  Malformed(std::string broken_rule, const std::string& what)
      : std::runtime_error(what), rule(std::move(broken_rule)) {}
  std::string rule;
};

/// A check is too large for this reader: exit status 2.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The file cannot be read: exit status 64.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace delcert::checker
