#include "kernel/topology/edge_contraction.hpp"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>

namespace delcert {

namespace {

constexpr std::size_t most_vertices = 5;
constexpr std::uint32_t no_label = UINT32_MAX;

/// Labels in increasing order, then `no_label`.
using LabelSet = std::array<std::uint32_t, most_vertices>;

LabelSet without(const LabelSet& simplex, std::uint32_t label) {
  LabelSet result;
  result.fill(no_label);
  std::copy_if(simplex.begin(), simplex.end(), result.begin(), [label](std::uint32_t k) { return k != label; });
  return result;
}

bool contains(const LabelSet& simplex, std::uint32_t label) {
  return std::find(simplex.begin(), simplex.end(), label) != simplex.end();
}

/// All non-empty faces of these simplices, each once, in order.
void list_faces(const std::vector<LabelSet>& simplices, std::vector<LabelSet>& faces) {
  faces.clear();
  for (const LabelSet& simplex : simplices) {
    const auto size = static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), no_label) - simplex.begin());
    for (std::size_t subset = 1; subset < (std::size_t{1} << size); ++subset) {
      LabelSet face;
      face.fill(no_label);
      std::size_t next = 0;
      for (std::size_t k = 0; k < size; ++k) {
        if ((subset >> k & 1U) != 0) face[next++] = simplex[k];
      }
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

class EdgeContraction {
 public:
  EdgeContraction(std::size_t size, const std::vector<std::uint32_t>& labels) : size_(size) {
    for (std::size_t at = 0; at < labels.size(); at += size) {
      LabelSet simplex;
      simplex.fill(no_label);
      std::copy_n(labels.begin() + static_cast<std::ptrdiff_t>(at), size, simplex.begin());
      std::sort(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(size));
      for (std::size_t k = 0; k < size; ++k) {
        if (simplex[k] >= stars_.size()) stars_.resize(simplex[k] + 1);
        stars_[simplex[k]].push_back(static_cast<std::uint32_t>(simplices_.size()));
      }
      simplices_.push_back(simplex);
    }
    is_there_.assign(simplices_.size(), true);
    last_visit_.resize(stars_.size());
    left_ = simplices_.size();
  }

  ContractedComplex run() {
    for (std::uint32_t label = 0; label < stars_.size(); ++label) {
      if (!stars_[label].empty()) queue_.emplace(stars_[label].size(), label);
    }
    while (!queue_.empty()) {
      const auto [count, label] = queue_.top();
      queue_.pop();
      // An entry of before its star changed.
      if (count == stars_[label].size() && count > 0) contract_from(label);
    }
    for (std::size_t at = 0; at < simplices_.size(); ++at) {
      if (is_there_[at])
        result_.simplices.insert(result_.simplices.end(), simplices_[at].begin(),
                                 simplices_[at].begin() + static_cast<std::ptrdiff_t>(size_));
    }
    return std::move(result_);
  }

 private:
  void contract_from(std::uint32_t a) {
    // The boundary of a simplex has m + 2.
    if (left_ <= size_ + 1) return;
    std::vector<LabelSet> link;
    std::vector<std::uint32_t> neighbours;
    for (const std::uint32_t at : stars_[a]) {
      link.push_back(without(simplices_[at], a));
      neighbours.insert(neighbours.end(), link.back().begin(),
                        link.back().begin() + static_cast<std::ptrdiff_t>(size_ - 1));
    }
    list_faces(link, link_of_a_);
    ++visit_;
    for (const std::uint32_t label : neighbours) last_visit_[label] = visit_;
    // Of neighbours those first with which most simplices are shared: they go.
    std::sort(neighbours.begin(), neighbours.end());
    std::vector<std::pair<std::size_t, std::uint32_t>> candidates;
    for (std::size_t at = 0; at < neighbours.size();) {
      std::size_t end = at;
      while (end < neighbours.size() && neighbours[end] == neighbours[at]) ++end;
      candidates.emplace_back(neighbours.size() - (end - at), neighbours[at]);
      at = end;
    }
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [rank, b] : candidates) {
      if (fulfils_link_condition(a, b)) {
        contract(a, b);
        return;
      }
      ++result_.refused;
    }
  }

  /// lk(ab) is in both links; so it is enough to count. Of lk(b), which may be large, only the part matters whose
  /// vertices are in lk(a). Precondition: link_of_a_ has the faces of lk(a), and its vertices are marked.
  bool fulfils_link_condition(std::uint32_t a, std::uint32_t b) {
    std::vector<LabelSet> link;
    std::vector<LabelSet> link_of_edge;
    for (const std::uint32_t at : stars_[b]) {
      const LabelSet& simplex = simplices_[at];
      link.push_back(marked_part(simplex, b));
      if (link.back()[0] == no_label) link.pop_back();
      if (contains(simplex, a)) link_of_edge.push_back(without(without(simplex, b), a));
    }
    list_faces(link, near_part_of_link_of_b_);
    list_faces(link_of_edge, faces_);
    std::size_t common = 0;
    for (auto one = link_of_a_.begin(), other = near_part_of_link_of_b_.begin();
         one != link_of_a_.end() && other != near_part_of_link_of_b_.end();) {
      if (*one == *other) {
        ++common;
        ++one;
        ++other;
      } else {
        *one < *other ? ++one : ++other;
      }
    }
    return common == faces_.size();
  }

  /// The labels of a simplex, but for b, that are marked.
  [[nodiscard]] LabelSet marked_part(const LabelSet& simplex, std::uint32_t b) const {
    LabelSet result;
    result.fill(no_label);
    std::copy_if(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(size_), result.begin(),
                 [this, b](std::uint32_t label) { return label != b && last_visit_[label] == visit_; });
    return result;
  }

  /// a becomes b.
  void contract(std::uint32_t a, std::uint32_t b) {
    std::vector<std::uint32_t> changed;
    const std::vector<std::uint32_t> star = std::move(stars_[a]);
    stars_[a].clear();
    for (const std::uint32_t at : star) {
      LabelSet& simplex = simplices_[at];
      if (contains(simplex, b)) {
        is_there_[at] = false;
        --left_;
        for (std::size_t k = 0; k < size_; ++k) {
          if (simplex[k] == a) continue;
          std::erase(stars_[simplex[k]], at);
          changed.push_back(simplex[k]);
        }
      } else {
        *std::find(simplex.begin(), simplex.end(), a) = b;
        std::sort(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(size_));
        stars_[b].push_back(at);
        changed.insert(changed.end(), simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(size_));
      }
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t label : changed) queue_.emplace(stars_[label].size(), label);
    ++result_.contractions;
  }

  using Entry = std::pair<std::size_t, std::uint32_t>;

  std::size_t size_;
  std::vector<LabelSet> simplices_;
  std::vector<bool> is_there_;
  std::size_t left_ = 0;
  std::vector<std::vector<std::uint32_t>> stars_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<LabelSet> link_of_a_, near_part_of_link_of_b_, faces_;
  std::vector<std::size_t> last_visit_;  ///< of each label: the visit in which it was last seen in lk(a)
  std::size_t visit_ = 0;
  ContractedComplex result_;
};

}  // namespace

ContractedComplex contract_edges(Dimension dimension, const std::vector<std::uint32_t>& labels) {
  return EdgeContraction(static_cast<std::size_t>(dimension.value) + 1, labels).run();
}

}  // namespace delcert
