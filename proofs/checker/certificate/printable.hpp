#pragma once

#include <string>
#include <string_view>

namespace delcert::checker {

/// The text of a JSON string as it is written between its quotation marks, for a terminal: what moves the cursor,
/// clears the screen or turns the direction of writing around stands there as an escape sequence of JSON. Precondition:
/// valid UTF-8.
std::string printable(std::string_view text);

}  // namespace delcert::checker
