#pragma once

#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {

/// A hexagonal torus with N^2 points whose radii are `stretch` times the covering radius, but for one, which is 8/9 of
/// that: radius_variation is 1/8 and fits with equality.
Sample graded_torus(int N = 28, double stretch = 1.7);
Json graded_document(const Sample& sample);
/// That of the usual torus, four points unperturbed: with the label number x + 28 y for a corner, a rectangle whose
/// diagonals are longer than 5/2 sampling radii of all labels, and shorter than that times 1 + radius_variation.
Json graded_document_with_rectangle(std::size_t x, std::size_t y);
/// The label with the lesser radius.
inline constexpr int lesser_label = 5;

/// So many times the sampling radius of the sample.
std::string radius_text(const Sample& sample, long long numerator, long long denominator);

}  // namespace delcert::checker_tests
