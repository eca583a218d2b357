#pragma once

#include <vector>

#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {

/// A simplex with the motions that take its labels to its lifts.
template <class Motion>
struct MovedSimplex {
  Labels labels;
  std::vector<Motion> motions;
};

/// The loop of a certificate from label 0 to its image under a motion, each step to the neighbour that is nearest to
/// the end: in a Delaunay complex that gets there. Elsewhere it may not: then an empty loop, which is another motion.
/// `step(h, a, b)` is h a^-1 b, `remaining(label, h)` a distance from the end, `at_end(h)` whether h is the motion.
template <class Motion, class Step, class Remaining, class AtEnd>
Json edge_path(const std::vector<MovedSimplex<Motion>>& simplices, const Motion& identity, const Step& step,
               const Remaining& remaining, const AtEnd& at_end) {
  std::vector<std::vector<std::size_t>> at;
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (const int j : simplices[s].labels) {
      if (at.size() <= static_cast<std::size_t>(j)) at.resize(static_cast<std::size_t>(j) + 1);
      at[static_cast<std::size_t>(j)].push_back(s);
    }
  }
  Json path = Json::array();
  std::size_t label = 0;
  Motion here = identity;
  double least = remaining(0, here);
  while (label != 0 || !at_end(here)) {
    bool nearer = false;
    std::size_t best = 0, from = 0, to = 0;
    Motion next = here;
    for (const std::size_t s : label < at.size() ? at[label] : std::vector<std::size_t>{}) {
      const auto& [labels, motions] = simplices[s];
      std::size_t a = 0;
      while (labels[a] != static_cast<int>(label)) ++a;
      for (std::size_t b = 0; b < labels.size(); ++b) {
        if (a == b) continue;
        const Motion there = step(here, motions[a], motions[b]);
        const double left = remaining(labels[b], there);
        if (left >= least - 1e-12) continue;
        nearer = true;
        least = left;
        best = s;
        from = a;
        to = b;
        next = there;
      }
    }
    if (!nearer) return Json::array();
    for (const std::size_t number : {best, from, to}) path.push_back(number);
    label = static_cast<std::size_t>(simplices[best].labels[to]);
    here = next;
  }
  return path;
}

}  // namespace delcert::checker_tests
