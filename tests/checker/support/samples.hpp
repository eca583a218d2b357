#pragma once

#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {

/// A model with what it may claim.
struct Sample {
  Model model;
  Claims claims;

  Json document() const { return certificate(model, claims); }
  Sample claiming(std::set<std::string> levels) const {
    Sample result = *this;
    result.claims.levels = std::move(levels);
    return result;
  }
};

/// The hexagonal torus with 28^2 points; epsilon is 1.9 times the covering radius, so that a point sees many others.
const Sample& wide_torus();
/// The hexagonal torus with 14^2 points; epsilon is barely more than the covering radius. In theory mode.
const Sample& narrow_torus();
/// The wide torus in a basis that is far from reduced.
const Sample& skewed_torus();
/// 30 points on a circle at distances of about 1.95 epsilon.
const Sample& circle();
/// The body-centred cubic torus with 16^3 points.
const Sample& cubic_torus();
/// 211 points in the plane, 13 of them interior.
const Sample& disc();
/// The torus of dimension 4 with 4^4 points; level 0 is not claimed.
const Sample& four_torus();

}  // namespace delcert::checker_tests
