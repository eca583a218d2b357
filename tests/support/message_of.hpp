#pragma once

#include <string>

namespace delcert::test {

/// The message of the exception of this type that the action throws; "accepted" if it throws none.
template <class Exception, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Exception& exception) {
    return exception.what();
  }
  return "accepted";
}

/// Whether `text` has `part` in it.
inline bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace delcert::test
