#pragma once

#include <gtest/gtest.h>

#include <string>

namespace delcert::test {

/// The message of the exception of this type that the action throws; fails the test, and is "accepted", if it throws
/// none.
template <class Exception, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Exception& exception) {
    return exception.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "accepted";
}

/// Whether `text` has `part` in it.
inline bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace delcert::test
