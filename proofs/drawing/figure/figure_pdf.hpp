#pragma once

#include <string>

#include "proofs/drawing/figure/figure.hpp"

namespace delcert {

/// As PDF 1.4, one page, 12 cm wide or high like a tikzpicture; nothing is compressed. Its title is the description.
/// Names and the scale are set in Times, which the file names and does not contain; of their characters those that are
/// not ASCII become `?`.
[[nodiscard]] std::string pdf_of(const Figure& figure);

}  // namespace delcert
