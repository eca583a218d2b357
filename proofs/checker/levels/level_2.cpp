#include <algorithm>
#include <array>

#include "proofs/checker/core/core.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/geometry/homology.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

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

std::string check_count(const Certificate& c, core::Core* core, Report& report) {
  const core::Complex* complex = core != nullptr && (c.m == 2 || c.m == 3) ? core->with_facets() : nullptr;
  const auto count = [&](std::size_t from, std::size_t to, Report&) {
    const auto begin = static_cast<Label>(from), end = static_cast<Label>(to);
    const FaceCount found = complex != nullptr ? core::count_faces(*complex, begin, end)
                                               : count_faces(c.m_size(), c.simplex_labels, begin, end);
    return Counts{found.simplices, found.euler_characteristic};
  };
  const auto [simplices, euler] = in_parts("2.count", Items::labels, c.n, report, count,
                                           {"simplices", "euler_characteristic"}, complex != nullptr ? 1U << 20 : 64);
  const char* kind = c.has_boundary() ? ", not closed" : ", closed";
  // The counts of a part say nothing: whoever adds them up compares them.
  const bool counted =
      !own_share.is_whole() || (simplices == static_cast<std::int64_t>(c.simplices) && euler == c.euler_characteristic);
  if (!counted || c.closed == c.has_boundary()) {
    report.reject("2.count", [&, simplices = simplices, euler = euler] {
      return "stated are " + std::to_string(c.simplices) + " simplices, Euler characteristic " +
             std::to_string(c.euler_characteristic) + (c.closed ? ", closed" : ", not closed") + "; found are " +
             std::to_string(simplices) + " simplices, Euler characteristic " + std::to_string(euler) + kind;
    });
  }
  return std::string("{simplices} simplices, Euler characteristic {euler_characteristic}") + kind;
}

std::string check_homology(const Certificate& c, Report& report) {
  const std::vector<std::string> groups = FaceComplex(c.m, simplices_of(c)).homology();
  if (c.homology != groups) {
    report.reject("2.homology",
                  [&] { return "stated is the homology " + listed(c.homology) + "; found is " + listed(groups); });
  }
  return ", homology " + listed(groups);
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
