#include "proofs/checker/core/chunk_view.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "proofs/checker/parts/chunk_items.hpp"

namespace delcert::checker {
namespace {

std::string set_of(const Label* labels, std::size_t number) {
  std::string text = "{";
  for (std::size_t k = 0; k < number; ++k) text += (k == 0 ? "" : ", ") + std::to_string(labels[k]);
  return text + "}";
}

}  // namespace

ChunkView::Near ChunkView::near(std::size_t m, unsigned edges) {
  const std::size_t corners = m + 1;
  (void)chunks_.chunk(number_);  // has as many labels as the header states
  const Label first = chunks_.first(number_), end = chunks_.end(number_);
  // Layer by layer; of those before the last one all simplices are read.
  std::unordered_map<Label, unsigned> layer_of;
  std::vector<Label> layer, met;
  for (Label i = first; i < end; ++i) layer.push_back(i);
  for (const Label i : layer) layer_of.emplace(i, 0U);
  met = layer;
  for (unsigned far = 1; far <= edges && !layer.empty(); ++far) {
    std::vector<Label> next;
    for (const Label i : layer) {
      const std::size_t k = chunks_.chunk_of(i);
      const Chunk& chunk = chunks_.chunk(k);
      const Label in_chunk = i - chunks_.first(k);
      for (std::uint64_t at = chunk.star_begin[in_chunk]; at < chunk.star_begin[in_chunk + 1]; ++at) {
        for (std::size_t corner = 0; corner < corners; ++corner) {
          const Label j = chunk.labels[chunk.star[at] * corners + corner];
          if (layer_of.emplace(j, far).second) next.push_back(j);
        }
      }
    }
    met.insert(met.end(), next.begin(), next.end());
    layer = std::move(next);
  }
  std::sort(met.begin(), met.end());

  ChunkItems items;
  items.names = met;
  std::unordered_map<Label, Label> here;
  for (Label i = 0; i < met.size(); ++i) {
    here[met[i]] = i;
    items.whole.push_back(layer_of[met[i]] < edges);
  }
  Near result;
  struct Place {
    const Label* labels;
    const std::uint32_t* elements;
  };
  std::vector<Place> simplices;
  for (const Label i : met) {
    const std::size_t k = chunks_.chunk_of(i);
    const Chunk& chunk = chunks_.chunk(k);
    const Label in_chunk = i - chunks_.first(k);
    for (std::size_t axis = 0; axis < m; ++axis) {
      result.net.push_back(chunk.net[in_chunk * m + axis]);
      result.points.push_back(chunk.points[in_chunk * m + axis]);
    }
    if (layer_of[i] == edges) continue;
    for (std::uint64_t at = chunk.star_begin[in_chunk]; at < chunk.star_begin[in_chunk + 1]; ++at) {
      const std::size_t s = chunk.star[at];
      const Label* labels = &chunk.labels[s * corners];
      // Once, with the least of its labels of which all simplices are read.
      const auto* least = std::find_if(labels, labels + corners, [&](Label j) { return layer_of[j] < edges; });
      if (*least == i) simplices.push_back({labels, &chunk.elements[s * m]});
    }
  }
  std::sort(simplices.begin(), simplices.end(), [&](const Place& a, const Place& b) {
    return std::lexicographical_compare(a.labels, a.labels + corners, b.labels, b.labels + corners);
  });
  for (const Place& place : simplices) {
    for (std::size_t k = 0; k < corners; ++k) result.labels.push_back(here.at(place.labels[k]));
    result.elements.insert(result.elements.end(), place.elements, place.elements + m);
  }

  items.labels = {here.at(first), std::uint64_t{here.at(first)} + (end - first), first, chunks_.points()};
  const auto with_least_from = [&](Label least) {
    const auto at = std::lower_bound(simplices.begin(), simplices.end(), least,
                                     [](const Place& place, Label i) { return place.labels[0] < i; });
    return static_cast<std::uint64_t>(at - simplices.begin());
  };
  items.simplices = {with_least_from(first), with_least_from(end), chunks_.simplices_before(number_),
                     chunks_.simplices()};
  items.facets = chunks_.simplices() * corners / 2;
  chunk_items = std::move(items);
  return result;
}

void ChunkView::check_border(Report& report) {
  const Chunk& own = chunks_.chunk(number_);
  const std::size_t m = own.points.size() / (chunks_.end(number_) - chunks_.first(number_)), corners = m + 1;
  for (std::size_t s = 0; s * corners < own.labels.size(); ++s) {
    const Label* labels = &own.labels[s * corners];
    for (std::size_t at = 0; at < corners; ++at) {
      const std::size_t k = chunks_.chunk_of(labels[at]);
      if (k == number_) continue;
      const Chunk& other = chunks_.chunk(k);
      const std::size_t there = chunks_.find(other, labels);
      if (there * corners < other.labels.size() &&
          std::equal(&own.elements[s * m], &own.elements[s * m] + m, &other.elements[there * m]))
        continue;
      report.reject("chunk.border", [&] {
        return "simplex " + set_of(labels, corners) + " of chunk " + std::to_string(number_ + 1) + " is not in chunk " +
               std::to_string(k + 1) + ", where label " + std::to_string(labels[at]) + " is";
      });
    }
  }
}

void ChunkView::check_loops(core::Complex& complex, Report& report) {
  const core::Data& data = complex.data;
  const Chunk& own = chunks_.chunk(number_);
  const auto broken = [&](std::size_t loop) {
    report.reject("core.group", [&] {
      return "loop " + std::to_string(loop + 1) + " is not a closed path at label 0 along generator " +
             std::to_string(loop + 1);
    });
  };
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    Label label = 0;
    core::Elements::Id product = 0;
    for (const ChunkStep& step : loops[loop]) {
      if (step.labels[step.from] != label) broken(loop);
      label = step.labels[step.to];
      const auto element = [&](std::size_t k) {
        return k == 0 ? core::Elements::Id{0} : complex.elements.of(step.elements[k - 1]);
      };
      product = complex.elements.product(product, complex.elements.relative(element(step.from), element(step.to)));
      if (chunks_.chunk_of(step.labels[0]) != number_) continue;
      const std::size_t s = chunks_.find(own, step.labels.data());
      if (s * step.labels.size() < own.labels.size() &&
          std::equal(step.elements.begin(), step.elements.end(), &own.elements[s * step.elements.size()]))
        continue;
      report.reject("core.group", [&] {
        return "loop " + std::to_string(loop + 1) + " goes through simplex " +
               set_of(step.labels.data(), step.labels.size()) + ", which is not in the list";
      });
    }
    if (label != 0 || product != complex.elements.find(data.generators[loop])) broken(loop);
  }
}

std::uint32_t ChunkView::trees() {
  const std::vector<std::uint32_t>& numbers = chunks_.trees(number_);
  return *std::max_element(numbers.begin(), numbers.end()) + 1;
}

std::vector<std::array<std::uint64_t, 3>> ChunkView::joins() {
  const Chunk& own = chunks_.chunk(number_);
  const Label first = chunks_.first(number_);
  const std::size_t corners = own.points.size() / (chunks_.end(number_) - first) + 1;
  const std::vector<std::uint32_t>& numbers = chunks_.trees(number_);
  std::set<std::array<std::uint64_t, 3>> found;
  for (std::size_t s = 0; s < own.labels.size(); s += corners) {
    const Label* labels = &own.labels[s];
    const auto* mine = std::find_if(labels, labels + corners, [&](Label j) { return chunks_.chunk_of(j) == number_; });
    for (std::size_t at = 0; at < corners; ++at) {
      const std::size_t k = chunks_.chunk_of(labels[at]);
      if (k < number_) found.insert({numbers[*mine - first], k, chunks_.trees(k)[labels[at] - chunks_.first(k)]});
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace delcert::checker
