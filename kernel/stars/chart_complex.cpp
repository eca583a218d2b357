#include "kernel/stars/chart_complex.hpp"

#include <algorithm>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// What is done for a label takes less than a microsecond.
constexpr std::size_t labels_in_a_part = 256;

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

/// Whether a star has this simplex, one of whose labels is its own.
template <int m>
bool has(const ChartStar<m>& star, const LabelSimplex<m>& simplex) {
  std::array<std::uint32_t, static_cast<std::size_t>(m)> others{};
  std::copy_if(simplex.begin(), simplex.end(), others.begin(),
               [&](std::uint32_t label) { return label != star.label.value; });
  const auto labels = [](const ChartSimplex<m>& seen) {
    std::array<std::uint32_t, static_cast<std::size_t>(m)> result;
    for (std::size_t at = 0; at < m; ++at) result[at] = seen[at].index;
    return result;
  };
  const auto found = std::lower_bound(star.simplices.begin(), star.simplices.end(), others,
                                      [&](const auto& seen, const auto& wanted) { return labels(seen) < wanted; });
  return found != star.simplices.end() && labels(*found) == others;
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
  const auto of_some = [this](std::size_t first, std::size_t last) {
    std::vector<LabelSimplex<m>> found;
    for (std::size_t at = first; at < last; ++at) {
      const ChartStar<m>& star = stars_[at];
      const auto begin = static_cast<std::ptrdiff_t>(found.size());
      for (const auto& others : star.simplices) {
        const auto simplex = simplex_of<m>(star.label, others);
        // Listed by the first of the stars that have it.
        const bool is_listed = std::any_of(simplex.begin(), simplex.end(), [&](std::uint32_t label) {
          return label < star.label.value && has<m>(stars_[label], simplex);
        });
        if (!is_listed) found.push_back(simplex);
      }
      std::sort(found.begin() + begin, found.end());
    }
    return found;
  };
  std::vector<LabelSimplex<m>> result;
  in_parts<labels_in_a_part>("list simplices", stars_.size(), no_progress(), of_some,
                             [&](const auto& found) { result.insert(result.end(), found.begin(), found.end()); });
  // So it is in order already, unless a star has a simplex that those of lesser labels have not.
  if (!std::is_sorted(result.begin(), result.end())) std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <int m>
PureComplex ChartComplex<m>::label_complex() const {
  const auto all = simplices();
  std::vector<std::uint32_t> labels;
  labels.reserve(all.size() * (m + 1));
  for (const auto& simplex : all) labels.insert(labels.end(), simplex.begin(), simplex.end());
  return {Dimension(m), labels};
}

template <int m>
std::vector<typename ChartComplex<m>::Listed> ChartComplex<m>::listed_where_some_miss() const {
  const auto of_some = [this](std::size_t first, std::size_t last) {
    std::vector<Listed> result;
    for (std::size_t at = first; at < last; ++at) {
      const ChartStar<m>& star = stars_[at];
      for (const auto& others : star.simplices) {
        const auto simplex = simplex_of<m>(star.label, others);
        const bool have_it = std::all_of(simplex.begin(), simplex.end(), [&](std::uint32_t label) {
          return label == star.label.value || !interior_[label] || has<m>(stars_[label], simplex);
        });
        if (!have_it) result.push_back({simplex, star.label.value});
      }
    }
    return result;
  };
  std::vector<Listed> result;
  in_parts<labels_in_a_part>(
      "compare stars", stars_.size(), no_progress(), of_some,
      [&](const std::vector<Listed>& found) { result.insert(result.end(), found.begin(), found.end()); });
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
StarAgreement ChartComplex<m>::agreement() const {
  StarAgreement result;
  std::vector<bool> concerned(stars_.size(), false);
  const std::vector<Listed> listed = listed_where_some_miss();
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
