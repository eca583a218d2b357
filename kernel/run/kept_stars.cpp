#include "kernel/run/kept_stars.hpp"

#include <algorithm>

#include "kernel/chart/length_units.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
KeptStars<m>::KeptStars(const Atlas<m>& atlas, const ModelGeometry& geometry, double required_protection,
                        LabelRange labels)
    : atlas_(atlas),
      geometry_(geometry),
      units_(atlas),
      required_protection_(required_protection),
      labels_(labels),
      stars_(atlas.size()),
      margins_(atlas.size()),
      reach_(atlas.size(), 0),
      outdated_(atlas.size(), true) {
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    interior_.push_back(atlas.is_interior(Label(index)));
    stars_[index].label = Label(index);
  }
}

template <int m>
void KeptStars<m>::update(const PointSet<m>& points, const Progress& progress) {
  std::vector<Label> labels;
  for (std::uint32_t index = labels_.first; index < labels_.last; ++index) {
    if (outdated_[index]) labels.emplace_back(index);
  }
  outdated_.assign(outdated_.size(), false);
  const ChartView<m> empty_view(atlas_, points, geometry_);
  for (const Label label : labels) failures_.erase(label.value);
  struct Found {
    double reach = 0;
    std::vector<std::pair<Label, std::vector<StarFailure>>> failures;
  };
  const auto certify = [&](std::size_t first, std::size_t last) {
    ChartView<m> view = empty_view;
    Found found;
    for (std::size_t at = first; at < last; ++at) {
      const Label label = labels[at];
      if (!interior_[label.value]) continue;
      CertifiedStar<m> star = chart_star<m>(view, label, required_protection_ * units_.of(label));
      star.star.simplices.shrink_to_fit();
      stars_[label.value] = std::move(star.star);
      margins_[label.value] = star.margins;
      reach_[label.value] = star.reach;
      found.reach = std::max(found.reach, star.reach);
      if (!star.failures.empty()) found.failures.emplace_back(label, std::move(star.failures));
    }
    return found;
  };
  in_parts("certify stars", labels.size(), progress, certify, [&](Found found) {
    include_reach(found.reach);
    for (auto& [label, failures] : found.failures) failures_.emplace(label.value, std::move(failures));
  });
}

template <int m>
void KeptStars<m>::include_reach(double reach) {
  farthest_reach_ = std::max(farthest_reach_, reach);
}

template <int m>
void KeptStars<m>::outdate(const std::vector<Label>& moved) {
  std::vector<Sighting<m>> seen;
  std::vector<bool> has_moved(outdated_.size());
  for (const Label label : moved) has_moved[label.value] = true;
  for (const Label label : moved) {
    // The distance of original points is the same from both sides, but for the distortion; a little more for its
    // rounding.
    const double stretch = 1 + approximate_double(geometry_.distortion);
    atlas_.sightings(label, farthest_reach_ * stretch * (1 + 0x1p-20), seen);
    for (const auto& sighting : seen) outdated_[sighting.index] = true;
    outdated_[label.value] = true;
  }
  if (!units_.vary()) return;
  // Of those that may see a moved point from far away most look less far.
  for (std::uint32_t index = 0; index < outdated_.size(); ++index) {
    if (!outdated_[index] || has_moved[index]) continue;
    atlas_.sightings(Label(index), reach_[index] * (1 + 0x1p-20), seen);
    outdated_[index] = std::any_of(seen.begin(), seen.end(), [&](const auto& other) { return has_moved[other.index]; });
  }
}

template <int m>
std::vector<StarFailure> KeptStars<m>::failures() const {
  std::vector<StarFailure> result;
  for (const auto& [label, failures] : failures_) result.insert(result.end(), failures.begin(), failures.end());
  return result;
}

template <int m>
bool KeptStars<m>::has_margins() const {
  for (std::uint32_t index = labels_.first; index < labels_.last; ++index) {
    if (interior_[index] && !failures_.contains(index)) return true;
  }
  return false;
}

template <int m>
LocalMargins KeptStars<m>::margins() const {
  LocalMargins result;
  bool is_first = true;
  for (std::uint32_t index = labels_.first; index < labels_.last; ++index) {
    if (!interior_[index] || failures_.contains(index)) continue;
    const LocalMargins here = margins_[index].as_multiples(units_, Label(index));
    if (is_first) result = here;
    result.include(here);
    is_first = false;
  }
  return result;
}

std::size_t star_count(const std::vector<StarFailure>& failures) {
  std::size_t result = 0;
  for (std::size_t at = 0; at < failures.size(); ++at) {
    if (at == 0 || failures[at].label != failures[at - 1].label) ++result;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) template class KeptStars<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
