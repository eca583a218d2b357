#include <algorithm>
#include <array>

#include "proofs/checker/homology.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

std::vector<LabelSet> simplices_of(const Certificate& c) {
  std::vector<LabelSet> result(c.simplex_count());
  for (std::size_t s = 0; s < result.size(); ++s) std::copy_n(c.simplex(s), c.m_size() + 1, result[s].begin());
  return result;
}

std::string listed(const std::vector<std::string>& groups) {
  std::string text;
  for (const std::string& group : groups) text += (text.empty() ? "" : ", ") + group;
  return text;
}

}  // namespace

std::string check_level_2(const Certificate& c, bool is_manifold, Report& report) {
  const std::size_t count = c.simplex_count();
  const FaceComplex complex(c.m, simplices_of(c));
  const std::int64_t euler = complex.euler_characteristic();
  std::string found = std::to_string(count) + " simplices, Euler characteristic " + std::to_string(euler) +
                      (c.has_boundary() ? ", not closed" : ", closed");
  if (c.simplices != count || c.euler_characteristic != euler || c.closed == c.has_boundary()) {
    report.reject("2.count", [&] {
      return "stated are " + std::to_string(c.simplices) + " simplices, Euler characteristic " +
             std::to_string(c.euler_characteristic) + (c.closed ? ", closed" : ", not closed") + "; found are " + found;
    });
  }
  // What is no manifold can have any homology, and that can take any time to find.
  if (c.homology.empty() || !is_manifold || !report.findings.empty()) return found;
  const std::vector<std::string> groups = complex.homology();
  if (c.homology != groups) {
    report.reject("2.homology",
                  [&] { return "stated is the homology " + listed(c.homology) + "; found is " + listed(groups); });
  }
  found += ", homology " + listed(groups);
  return found;
}

/// 4r + 2 rho epsilon < 9 epsilon.
std::string check_level_2s(const Certificate& c, Report& report) {
  const Rational reach = Rational(4) * c.circumradius.exact + Rational(2) * c.rho.exact * c.epsilon.exact;
  if (less(reach, Rational(9) * c.epsilon.exact) != Verdict::proved) {
    report.reject("2s.patch", [] { return "4 circumradius + 2 perturbation epsilon is not below 9 epsilon"; });
  }
  return "every chart of a star sees the same star";
}

}  // namespace delcert::checker
