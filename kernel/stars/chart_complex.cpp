#include "kernel/stars/chart_complex.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// A simplex as a star has it.
template <int m>
struct Listed {
  LabelSimplex<m> simplex;
  std::uint32_t star;
  friend auto operator<=>(const Listed&, const Listed&) = default;
};

template <int m>
LabelSimplex<m> simplex_of(Label label, const ChartSimplex<m>& others) {
  LabelSimplex<m> result;
  for (std::size_t at = 0; at < m; ++at) result[at] = others[at].index;
  result[m] = label.value;
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
std::vector<Label> labels_of(const LabelSimplex<m>& simplex) {
  return std::vector<Label>(simplex.begin(), simplex.end());
}

/// All simplices with all stars that have them, sorted.
template <int m>
std::vector<Listed<m>> all_listed(const std::vector<ChartStar<m>>& stars) {
  std::vector<Listed<m>> result;
  for (const auto& star : stars) {
    for (const auto& others : star.simplices) result.push_back({simplex_of<m>(star.label, others), star.label.value});
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

template <int m>
ChartComplex<m>::ChartComplex(std::vector<ChartStar<m>> stars, const std::vector<bool>& interior)
    : stars_(std::move(stars)), interior_(interior) {}

template <int m>
std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> ChartComplex<m>::star(Label i) const {
  std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> result;
  for (const auto& others : stars_[i.value].simplices) {
    auto& labels = result.emplace_back();
    for (std::size_t at = 0; at < m; ++at) labels[at] = others[at].index;
    std::sort(labels.begin(), labels.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
std::vector<Label> ChartComplex<m>::neighbours(Label i) const {
  std::vector<Label> result;
  for (const auto& others : stars_[i.value].simplices) {
    for (const auto& seen : others) result.push_back(label_of<m>(seen));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <int m>
std::vector<ChartSimplex<m>> ChartComplex<m>::first_seen_from(Label i) const {
  std::vector<ChartSimplex<m>> result;
  if (!is_interior(i)) return result;
  for (const auto& others : stars_[i.value].simplices) {
    const bool is_first = std::none_of(others.begin(), others.end(), [&](const auto& seen) {
      return seen.index < i.value && is_interior(label_of<m>(seen));
    });
    if (is_first) result.push_back(others);
  }
  return result;
}

template <int m>
std::vector<LabelSimplex<m>> ChartComplex<m>::simplices() const {
  std::vector<LabelSimplex<m>> result;
  for (const auto& listed : all_listed<m>(stars_)) {
    if (result.empty() || result.back() != listed.simplex) result.push_back(listed.simplex);
  }
  return result;
}

template <int m>
PureComplex ChartComplex<m>::label_complex() const {
  std::vector<std::uint32_t> labels;
  for (const auto& simplex : simplices()) labels.insert(labels.end(), simplex.begin(), simplex.end());
  return {Dimension(m), labels};
}

template <int m>
StarAgreement ChartComplex<m>::agreement() const {
  StarAgreement result;
  std::vector<bool> concerned(stars_.size(), false);
  const auto listed = all_listed<m>(stars_);
  for (std::size_t first = 0; first < listed.size();) {
    std::size_t last = first;
    while (last < listed.size() && listed[last].simplex == listed[first].simplex) ++last;
    const auto& simplex = listed[first].simplex;
    std::vector<std::uint32_t> missing;
    for (const std::uint32_t label : simplex) {
      const bool has_it = std::any_of(listed.begin() + static_cast<std::ptrdiff_t>(first),
                                      listed.begin() + static_cast<std::ptrdiff_t>(last),
                                      [&](const auto& entry) { return entry.star == label; });
      if (!has_it && interior_[label]) missing.push_back(label);
    }
    if (!missing.empty()) {
      result.missing += missing.size();
      std::string text = simplex_text(labels_of<m>(simplex)) + " is in the star of label " +
                         std::to_string(listed[first].star) + " but not of";
      for (const std::uint32_t label : missing) {
        concerned[label] = true;
        text += (label == missing.front() ? " " : ", ") + std::to_string(label);
      }
      result.failures.push_back(
          {Label(missing.front()), std::move(text), labels_of<m>(simplex), FailureCause::combinatorial});
    }
    first = last;
  }
  for (std::uint32_t index = 0; index < concerned.size(); ++index) {
    if (concerned[index]) result.labels.emplace_back(index);
  }
  result.stars = result.labels.size();
  return result;
}

template <int m>
std::optional<PlaceSimplex<m>> places_of(const ChartView<m>& view, const LabelSimplex<m>& labels) {
  PlaceSimplex<m> result;
  for (std::size_t corner = 0; corner <= m; ++corner) {
    const auto place = view.find(Label(labels[corner]));
    if (!place) return std::nullopt;
    result[corner] = *place;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m)    \
  template class ChartComplex<m>; \
  template std::optional<PlaceSimplex<m>> places_of<m>(const ChartView<m>&, const LabelSimplex<m>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
