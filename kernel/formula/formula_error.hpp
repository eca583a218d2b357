#pragma once

#include <cstddef>
#include <string>

#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

/// A formula that cannot be read or makes no sense, with the place in its text.
class FormulaError : public InputError {
 public:
  FormulaError(std::size_t offset, const std::string& message) : InputError(message), offset_(offset) {}

  /// The offset in the text of the formula, counted from 0, of what is wrong.
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

}  // namespace delcert
