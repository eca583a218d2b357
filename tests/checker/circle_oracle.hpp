#pragma once

#include <string>

namespace delcert::checker_tests {

/// Whether what a certificate of a circle claims is true: a flat torus of dimension 1, by sorting its points, in the
/// kernel's rational arithmetic and with a reader of its own. Returns what is false, or nothing. Throws what its reader
/// throws of a document that it cannot read.
std::string fault_of_circle(const std::string& text);

}  // namespace delcert::checker_tests
