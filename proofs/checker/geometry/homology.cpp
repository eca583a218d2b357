#include "proofs/checker/geometry/homology.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "proofs/checker/arithmetic/abelian_group.hpp"
#include "proofs/checker/arithmetic/smith_form.hpp"

namespace delcert::checker {
namespace {

/// In order, each once.
void sort(std::vector<LabelSet>& faces) {
  if (!std::is_sorted(faces.begin(), faces.end())) std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

/// A facet of a face, but for its first label; number k of face number f comes from the place f (k + 1) + k.
struct Facet {
  std::uint64_t second_and_third;
  Label fourth;
  std::uint32_t place;
};

/// The facets of these faces of dimension k, in order; in `boundary`, of each place, which one it is.
std::vector<LabelSet> facets_of(const std::vector<LabelSet>& faces, std::size_t k,
                                std::vector<std::uint32_t>& boundary) {
  boundary.resize(faces.size() * (k + 1));
  // Those of each first label together.
  std::vector<std::size_t> next;
  for (const LabelSet& face : faces) {
    if (face[1] >= next.size()) next.resize(face[1] + std::size_t{1}, 0);
    next[face[0]] += k;
    ++next[face[1]];
  }
  std::size_t sum = 0;
  for (std::size_t& begin : next) sum += std::exchange(begin, sum);
  std::vector<Facet> facets(boundary.size());
  for (std::size_t place = 0; place < boundary.size(); ++place) {
    LabelSet face = faces[place / (k + 1)];
    const auto omitted = face.begin() + static_cast<std::ptrdiff_t>(place % (k + 1));
    std::copy(omitted + 1, face.end(), omitted);
    facets[next[face[0]]++] = {std::uint64_t{face[1]} << 32 | face[2], face[3], static_cast<std::uint32_t>(place)};
  }
  std::vector<LabelSet> result;
  std::size_t begin = 0;
  for (std::size_t label = 0; label < next.size(); ++label) {
    const auto first = facets.begin() + std::ptrdiff_t(begin), last = facets.begin() + std::ptrdiff_t(next[label]);
    std::sort(first, last, [](const Facet& a, const Facet& b) {
      return std::tie(a.second_and_third, a.fourth) < std::tie(b.second_and_third, b.fourth);
    });
    for (auto at = first; at != last; ++at) {
      const bool is_new = at == first || at[-1].second_and_third != at->second_and_third || at[-1].fourth != at->fourth;
      if (is_new) {
        result.push_back({static_cast<Label>(label), static_cast<Label>(at->second_and_third >> 32),
                          static_cast<Label>(at->second_and_third & UINT32_MAX), at->fourth});
      }
      boundary[at->place] = static_cast<std::uint32_t>(result.size() - 1);
    }
    begin = next[label];
  }
  return result;
}

}  // namespace

FaceComplex::FaceComplex(int m, std::vector<LabelSet> simplices)
    : m_(static_cast<std::size_t>(m)), size_(m_ + 1), boundary_(m_ + 1) {
  sort(simplices);
  for (std::size_t k = m_; k > 0; --k) {
    size_[k] = simplices.size();
    simplices = facets_of(simplices, k, boundary_[k]);
  }
  size_[0] = simplices.size();
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
  std::vector<std::vector<bool>> used;
  for (const std::size_t size : size_) used.emplace_back(size, false);
  std::vector<SmithForm> forms(m_ + 2);  // number k: the boundary of k-faces; the first and the last are 0
  const auto find = [&](std::size_t k) {
    // A facet of a manifold is in two simplices: transposed, the matrix for k = m has columns of two entries. So has
    // the matrix for k = 1 as it is.
    const bool transposed = k == m_;
    std::vector<bool>&used_rows = used[transposed ? k : k - 1], &used_columns = used[transposed ? k - 1 : k];
    const std::size_t rows = used_rows.size(), columns = used_columns.size();
    const auto for_entries = [&](const auto& f) {
      for (auto face = static_cast<std::uint32_t>(size_[k]); face-- > 0;) {
        for (std::size_t omitted = 0; omitted <= k; ++omitted) {
          const std::uint32_t facet = boundary_[k][face * (k + 1) + omitted];
          if (!used[k][face] && !used[k - 1][facet])
            f(transposed ? facet : face, Entry{transposed ? face : facet, omitted % 2 == 0 ? 1 : -1});
        }
      }
    };
    std::vector<std::uint8_t> number(columns, 0);
    for_entries([&](std::uint32_t column, const Entry&) {
      if (number[column] < 3) ++number[column];
    });
    if (std::all_of(number.begin(), number.end(), [](std::uint8_t of) { return of == 0 || of == 2; })) {
      std::vector<Link> links(columns);
      for_entries([&](std::uint32_t column, const Entry& entry) {
        Link& link = links[column];
        link.sign = --number[column] == 1 ? entry.coefficient : link.sign * entry.coefficient;
        link.row[number[column]] = entry.face;
      });
      // The last facets first: what then is left of dimension 2 is reduced several times faster.
      forms[k] = reduce_links(links, transposed, rows, used_rows, used_columns);
    } else {
      std::vector<Column> list(columns);
      for_entries([&](std::uint32_t column, const Entry& entry) {
        if (list[column].empty()) list[column].reserve(transposed ? 2 : k + 1);
        list[column].push_back(entry);
      });
      forms[k] = reduce(std::move(list), rows, used_rows, used_columns);
    }
  };
  find(m_);
  for (std::size_t k = 1; k < m_; ++k) find(k);
  std::vector<std::string> result;
  for (std::size_t k = 0; k <= m_; ++k)
    result.push_back(group_text(size_[k] - forms[k].rank - forms[k + 1].rank, forms[k + 1].torsion));
  return result;
}

}  // namespace delcert::checker
