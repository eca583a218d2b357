#pragma once

#include "tests/checker/support/certificate_text.hpp"

// Certificates of runs on atlases by formulas, without their seals; each is made once.
namespace delcert::checker_tests {

/// sphere-2-stereographic.
const Json& sphere_document();
/// The same with fewer points.
const Json& coarse_sphere_document();
/// torus-2-by-charts: the square torus in four rectangles.
const Json& torus_document();
/// cone-torus: two cone points; transitions fold.
const Json& cone_document();

}  // namespace delcert::checker_tests
