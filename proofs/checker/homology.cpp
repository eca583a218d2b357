#include "proofs/checker/homology.hpp"

#include <algorithm>

#include "proofs/checker/abelian_group.hpp"
#include "proofs/checker/smith_form.hpp"

namespace delcert::checker {
namespace {

LabelSet without(LabelSet face, std::size_t omitted) {
  const auto place = face.begin() + static_cast<std::ptrdiff_t>(omitted);
  std::copy(place + 1, face.end(), place);
  face.back() = 0;
  return face;
}

/// Where the faces of each first label begin; one more at the end. Faces that begin alike stand together.
std::vector<std::size_t> beginnings(const std::vector<LabelSet>& faces, std::size_t labels) {
  std::vector<std::size_t> result(labels + 1, 0);
  for (const LabelSet& face : faces) ++result[face[0] + 1];
  for (std::size_t label = 0; label < labels; ++label) result[label + 1] += result[label];
  return result;
}

/// In order, each once.
void sort(std::vector<LabelSet>& faces, std::size_t labels) {
  std::vector<std::size_t> next = beginnings(faces, labels);
  const std::vector<std::size_t> begin = next;
  std::vector<LabelSet> sorted(faces.size());
  for (const LabelSet& face : faces) sorted[next[face[0]]++] = face;
  for (std::size_t label = 0; label < labels; ++label)
    std::sort(sorted.begin() + std::ptrdiff_t(begin[label]), sorted.begin() + std::ptrdiff_t(begin[label + 1]));
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  faces = std::move(sorted);
}

}  // namespace

FaceComplex::FaceComplex(int m, std::vector<LabelSet> simplices) : m_(m), faces_(static_cast<std::size_t>(m) + 1) {
  for (const LabelSet& simplex : simplices)
    labels_ = std::max<std::size_t>(labels_, *std::max_element(simplex.begin(), simplex.end()) + 1);
  const auto dimension = static_cast<std::size_t>(m);
  faces_[dimension] = std::move(simplices);
  for (std::size_t k = dimension + 1; k-- > 0;) {
    std::vector<LabelSet>& faces = faces_[k];
    sort(faces, labels_);
    if (k > 0) faces_[k - 1].reserve((k + 1) * faces.size());
    for (std::size_t omitted = 0; k > 0 && omitted <= k; ++omitted) {
      for (const LabelSet& face : faces) faces_[k - 1].push_back(without(face, omitted));
    }
  }
}

FaceCount count_faces(std::size_t m, const std::vector<Label>& labels, Label begin, Label end) {
  // What follows a label in its simplices, label after label.
  std::vector<std::size_t> next(std::size_t{end} - begin + 1, 0);
  const auto is_in_range = [&](Label label) { return begin <= label && label < end; };
  for (const Label label : labels) {
    if (is_in_range(label)) ++next[label - begin + 1];
  }
  for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
  std::vector<std::size_t> places(next.back());
  const std::vector<std::size_t> first = next;
  for (std::size_t at = 0; at < labels.size(); ++at) {
    if (is_in_range(labels[at])) places[next[labels[at] - begin]++] = at;
  }
  FaceCount count;
  // Without their least label; two of the other labels, each increased by 1, in a number, 0 for none.
  std::vector<std::array<std::uint64_t, 2>> faces;
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    faces.clear();
    for (std::size_t number = first[k]; number < first[k + 1]; ++number) {
      const std::size_t later = m - places[number] % (m + 1);
      for (unsigned subset = 0; subset < 1U << later; ++subset) {
        auto& face = faces.emplace_back();
        std::size_t length = 0;
        for (std::size_t other = 0; other < later; ++other) {
          if ((subset >> other & 1) == 0) continue;
          face[length / 2] |= (std::uint64_t{labels[places[number] + 1 + other]} + 1) << 32 * (length % 2);
          ++length;
        }
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const auto& face : faces) {
      std::size_t dimension = 0;
      for (const std::uint64_t two : face)
        dimension += ((two & UINT32_MAX) != 0 ? 1U : 0U) + (two >> 32 != 0 ? 1U : 0U);
      count.simplices += dimension == m ? 1 : 0;
      count.euler_characteristic += dimension % 2 == 0 ? 1 : -1;
    }
  }
  return count;
}

/// A face that owns a row or a column of one boundary matrix can be left out of the next one (docs/homology.md).
std::vector<std::string> FaceComplex::homology() const {
  const auto m = static_cast<std::size_t>(m_);
  std::vector<std::vector<bool>> used;
  for (const auto& faces : faces_) used.emplace_back(faces.size(), false);
  std::vector<SmithForm> forms(m + 2);  // number k: the boundary of k-faces; the first and the last are 0
  const auto find = [&](std::size_t k) {
    // A facet of a manifold is in two simplices: transposed, the matrix for k = m has columns of two entries, and keeps
    // them so. So has the matrix for k = 1 as it is.
    const bool transposed = k == m;
    std::vector<Column> columns(faces_[transposed ? k - 1 : k].size());
    const std::size_t most = transposed ? 2 : k + 1;
    const std::vector<std::size_t> begin = beginnings(faces_[k - 1], labels_);
    const auto number_of = [&](const LabelSet& face) {
      const auto first = faces_[k - 1].begin();
      const auto place =
          std::lower_bound(first + std::ptrdiff_t(begin[face[0]]), first + std::ptrdiff_t(begin[face[0] + 1]), face);
      return static_cast<std::uint32_t>(place - first);
    };
    for (std::size_t face = faces_[k].size(); face-- > 0;) {
      if (used[k][face]) continue;
      for (std::size_t omitted = 0; omitted <= k; ++omitted) {
        const std::uint32_t at = number_of(without(faces_[k][face], omitted));
        if (used[k - 1][at]) continue;
        const std::int64_t sign = omitted % 2 == 0 ? 1 : -1;
        Column& column = columns[transposed ? at : face];
        if (column.empty()) column.reserve(most);
        column.push_back({transposed ? static_cast<std::uint32_t>(face) : at, sign});
      }
    }
    forms[k] = transposed ? reduce(std::move(columns), faces_[k].size(), used[k], used[k - 1])
                          : reduce(std::move(columns), faces_[k - 1].size(), used[k - 1], used[k]);
  };
  find(m);
  for (std::size_t k = 1; k < m; ++k) find(k);
  std::vector<std::string> result;
  for (std::size_t k = 0; k <= m; ++k)
    result.push_back(group_text(faces_[k].size() - forms[k].rank - forms[k + 1].rank, forms[k + 1].torsion));
  return result;
}

}  // namespace delcert::checker
