#include <algorithm>
#include <array>

#include "proofs/checker/homology.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

LabelSet joined(const Certificate& c, Label i, const Label* labels) {
  LabelSet set{};
  const auto m = static_cast<std::size_t>(c.m);
  std::copy_n(labels, m, set.begin());
  const auto place = std::lower_bound(set.begin(), set.begin() + c.m, i);
  std::copy_backward(place, set.begin() + c.m, set.begin() + c.m + 1);
  *place = i;
  return set;
}

/// Whether star(j) lists the simplex.
bool lists(const Certificate& c, Label j, const LabelSet& simplex) {
  const auto m = static_cast<std::size_t>(c.m);
  std::array<Label, 4> rest{};
  std::remove_copy(simplex.begin(), simplex.begin() + c.m + 1, rest.begin(), j);
  std::size_t low = 0, high = c.star_size(j);
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const Label* labels = c.star_simplex(j, middle);
    const auto [in_star, in_rest] = std::mismatch(labels, labels + m, rest.begin());
    if (in_star == labels + m) return true;
    (*in_star < *in_rest ? low : high) = *in_star < *in_rest ? middle + 1 : middle;
  }
  return false;
}

/// Checks 2.agreement and returns the different simplices of the stars.
std::vector<LabelSet> check_agreement(const Certificate& c, Report& report) {
  std::vector<LabelSet> different;
  for (Label i = 0; i < c.n; ++i) {
    for (std::size_t s = 0; s < c.star_size(i); ++s) {
      const Label* labels = c.star_simplex(i, s);
      const LabelSet simplex = joined(c, i, labels);
      bool first = true;
      for (int k = 0; k < c.m; ++k) {
        const Label j = labels[k];
        const bool listed = lists(c, j, simplex);
        first = first && !(listed && j < i);
        if (listed || !c.interior[j]) continue;
        report.reject("2.agreement", [&] {
          return "star of " + std::to_string(i) + " has simplex " +
                 label_set(simplex.data(), simplex.data() + c.m + 1) + ", star of " + std::to_string(j) + " does not";
        });
      }
      if (first) different.push_back(simplex);
    }
  }
  return different;
}

std::string listed(const std::vector<std::string>& groups) {
  std::string text;
  for (const std::string& group : groups) text += (text.empty() ? "" : ", ") + group;
  return text;
}

}  // namespace

std::string check_level_2(const Certificate& c, Report& report) {
  std::vector<LabelSet> simplices = check_agreement(c, report);
  const std::size_t count = simplices.size();
  const FaceComplex complex(c.m, std::move(simplices));
  const std::int64_t euler = complex.euler_characteristic();
  std::string found = std::to_string(count) + " simplices, Euler characteristic " + std::to_string(euler) +
                      (c.has_boundary() ? ", not closed" : ", closed");
  if (c.simplices != count || c.euler_characteristic != euler || c.closed == c.has_boundary()) {
    report.reject("2.count", [&] {
      return "stated are " + std::to_string(c.simplices) + " simplices, Euler characteristic " +
             std::to_string(c.euler_characteristic) + (c.closed ? ", closed" : ", not closed") + "; found are " + found;
    });
  }
  if (c.homology.empty()) return found;
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
