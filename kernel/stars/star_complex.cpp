#include "kernel/stars/star_complex.hpp"

#include <algorithm>
#include <iterator>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/sort_by_number.hpp"

namespace delcert {

namespace {

/// The number of different label sets of `count` vertices among the faces of the simplices.
template <int m>
std::size_t face_count(const std::vector<LiftedSimplex<m>>& simplices, int count) {
  std::vector<std::array<std::uint32_t, corners<m>>> faces;
  for (unsigned face = 1; face < (1U << corners<m>); ++face) {
    if (std::popcount(face) != count) continue;
    for (const auto& simplex : simplices) {
      std::array<std::uint32_t, corners<m>> labels{};
      std::size_t next = 0;
      for (std::size_t corner = 0; corner < corners<m>; ++corner) {
        if ((face >> corner & 1U) != 0) labels[next++] = simplex[corner].index;
      }
      faces.push_back(labels);
    }
  }
  sort_by_number(faces, [](const auto& labels) { return labels[0]; });
  return static_cast<std::size_t>(std::unique(faces.begin(), faces.end()) - faces.begin());
}

}  // namespace

std::vector<Label> labels_concerned_by(const std::vector<StarFailure>& failures) {
  std::vector<Label> result;
  for (const StarFailure& failure : failures)
    result.insert(result.end(), failure.concerned.begin(), failure.concerned.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <int m>
StarComplex<m>::StarComplex(std::vector<LiftedSimplex<m>> simplices, const std::vector<bool>& interior)
    : simplices_(std::move(simplices)), interior_(interior), first_(interior.size() + 1, 0) {
  const auto outside = [&](const LiftedSimplex<m>& simplex) {
    return std::none_of(simplex.begin(), simplex.end(), [&](const auto& vertex) { return interior_[vertex.index]; });
  };
  simplices_.erase(std::remove_if(simplices_.begin(), simplices_.end(), outside), simplices_.end());
  for (const auto& simplex : simplices_) {
    for (const auto& vertex : simplex) ++first_[vertex.index + 1];
  }
  for (std::size_t i = 0; i < interior_.size(); ++i) first_[i + 1] += first_[i];
  at_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t at = 0; at < simplices_.size(); ++at) {
    for (const auto& vertex : simplices_[at]) at_[next[vertex.index]++] = at;
  }
}

template <int m>
std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> StarComplex<m>::star(Label i) const {
  std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> result;
  if (!interior_[i.value]) return result;
  for (std::size_t entry = first_[i.value]; entry < first_[i.value + 1]; ++entry) {
    std::array<std::uint32_t, static_cast<std::size_t>(m)> others{};
    std::size_t next = 0;
    for (const auto& vertex : simplices_[at_[entry]]) {
      if (vertex.index != i.value && next < m) others[next++] = vertex.index;
    }
    result.push_back(others);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
long StarComplex<m>::euler_characteristic() const {
  long result = 0;
  for (int count = 1; count <= m + 1; ++count) {
    const long faces = static_cast<long>(face_count<m>(simplices_, count));
    result += count % 2 == 1 ? faces : -faces;
  }
  return result;
}

template <int m>
PureComplex StarComplex<m>::label_complex() const {
  std::vector<std::uint32_t> labels;
  labels.reserve(simplices_.size() * corners<m>);
  for (const auto& simplex : simplices_) {
    for (const auto& vertex : simplex) labels.push_back(vertex.index);
  }
  return {Dimension(m), labels};
}

template <int m>
std::vector<StarFailure> StarComplex<m>::failures_at(std::size_t first_label, std::size_t last_label) const {
  std::vector<StarFailure> failures;
  // The faces of dimension m−1 that contain a label: its m−1 other labels.
  std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m) - 1>> faces;
  for (std::size_t index = first_label; index < last_label; ++index) {
    const Label i(index);
    if (!interior_[index]) continue;
    const auto simplices = star(i);
    if (simplices.empty()) {
      failures.push_back({i, "its star is empty", {i}, FailureCause::combinatorial});
      continue;
    }
    faces.clear();
    for (const auto& others : simplices) {
      for (std::size_t omitted = 0; omitted < m; ++omitted) {
        auto& face = faces.emplace_back();
        for (std::size_t at = 0; at + 1 < m; ++at) face[at] = others[at + (at < omitted ? 0 : 1)];
      }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t first = 0; first < faces.size();) {
      std::size_t last = first;
      while (last < faces.size() && faces[last] == faces[first]) ++last;
      if (last - first != 2) {
        StarFailure failure{i,
                            "a face of its star is in " + std::to_string(last - first) + " simplices instead of 2",
                            {i},
                            FailureCause::combinatorial};
        for (const auto label : faces[first]) failure.concerned.emplace_back(label);
        failures.push_back(failure);
        break;
      }
      first = last;
    }
  }
  return failures;
}

template <int m>
std::vector<StarFailure> StarComplex<m>::combinatorial_failures() const {
  std::vector<StarFailure> failures;
  for (const auto& simplex : simplices_) {
    for (std::size_t corner = 1; corner < corners<m>; ++corner) {
      if (simplex[corner].index == simplex[corner - 1].index) {
        failures.push_back({Label(simplex[corner].index),
                            "a simplex of its star has this vertex twice",
                            {Label(simplex[corner].index)},
                            FailureCause::combinatorial});
      }
    }
  }
  if (!failures.empty()) return failures;
  in_parts<64>(
      "certify stars", interior_.size(), no_progress(),
      [this](std::size_t first, std::size_t last) { return failures_at(first, last); },
      [&failures](std::vector<StarFailure> found) {
        std::move(found.begin(), found.end(), std::back_inserter(failures));
      });
  return failures;
}

#define DELCERT_INSTANTIATE(m) template class StarComplex<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
