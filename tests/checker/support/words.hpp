#pragma once

#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {

/// Turns the elements of a torus, which are integer vectors, into words in the translations of a flat space form
/// without generators. The loops are those of the same translations.
void write_elements_as_words(Json& document);

}  // namespace delcert::checker_tests
