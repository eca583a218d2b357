#include "kernel/topology/pure_complex.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "kernel/topology/lexicographic_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The different keys, one after the other, and for each entry the number of its key.
struct DifferentKeys {
  std::vector<std::uint32_t> keys;
  std::vector<std::uint32_t> number_of;
};

template <class Key>
DifferentKeys different_keys(std::size_t count, std::size_t length, std::size_t range, const Key& key) {
  DifferentKeys result;
  result.number_of.resize(count);
  for (const std::size_t entry : lexicographic_order(count, length, range, key)) {
    const auto is_last = [&] {
      const std::size_t last = result.keys.size() - length;
      for (std::size_t place = 0; place < length; ++place) {
        if (result.keys[last + place] != key(entry, place)) return false;
      }
      return true;
    };
    if (result.keys.empty() || !is_last()) {
      for (std::size_t place = 0; place < length; ++place) result.keys.push_back(key(entry, place));
    }
    result.number_of[entry] = static_cast<std::uint32_t>(result.keys.size() / length - 1);
  }
  return result;
}

/// The labels that there are, in increasing order.
std::vector<std::uint32_t> different_labels(const std::vector<std::uint32_t>& labels) {
  if (labels.empty()) return {};
  const std::uint32_t greatest = *std::max_element(labels.begin(), labels.end());
  std::vector<std::uint32_t> result;
  if (greatest >= labels.size()) {
    result = labels;
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
  std::vector<bool> is_there(std::size_t{greatest} + 1, false);
  for (const std::uint32_t label : labels) is_there[label] = true;
  for (std::uint32_t label = 0; label <= greatest; ++label) {
    if (is_there[label]) result.push_back(label);
  }
  return result;
}

/// The labels replaced by their places among the different ones, each simplex in increasing order.
std::vector<std::uint32_t> sorted_vertices(const std::vector<std::uint32_t>& labels, std::size_t corners) {
  const std::vector<std::uint32_t> different = different_labels(labels);
  const bool are_places = !different.empty() && different.back() < different.size();
  std::vector<std::uint32_t> result = labels;
  for (std::uint32_t& label : result) {
    if (!are_places)
      label =
          static_cast<std::uint32_t>(std::lower_bound(different.begin(), different.end(), label) - different.begin());
  }
  for (auto first = result.begin(); first != result.end(); first += static_cast<std::ptrdiff_t>(corners)) {
    const auto last = first + static_cast<std::ptrdiff_t>(corners);
    std::sort(first, last);
    const auto twice = std::adjacent_find(first, last);
    if (twice != last)
      throw InputError("a simplex has the label " + std::to_string(different[*twice]) + " more than once");
  }
  return result;
}

}  // namespace

PureComplex::PureComplex(Dimension dimension, const std::vector<std::uint32_t>& labels) {
  if (dimension.value < 0) throw std::invalid_argument("a complex has a dimension of at least 0");
  const auto m = static_cast<std::size_t>(dimension.value);
  if (labels.size() % (m + 1) != 0) throw std::invalid_argument("the labels are not m + 1 for each simplex");
  faces_.resize(m + 1);
  const std::vector<std::uint32_t> given = sorted_vertices(labels, m + 1);
  const std::size_t range = given.empty() ? 0 : std::size_t{*std::max_element(given.begin(), given.end())} + 1;
  faces_[m].vertices =
      different_keys(given.size() / (m + 1), m + 1, range, [&](std::size_t simplex, std::size_t place) {
        return given[simplex * (m + 1) + place];
      }).keys;
  for (std::size_t k = m; k > 0; --k) {
    const std::vector<std::uint32_t>& above = faces_[k].vertices;
    // Entry e is the face number e / (k + 1) without its vertex e % (k + 1).
    const auto vertex = [&](std::size_t entry, std::size_t place) {
      const std::size_t omitted = entry % (k + 1);
      return above[entry - omitted + place + (place < omitted ? 0 : 1)];
    };
    DifferentKeys found = different_keys(above.size(), k, range, vertex);
    faces_[k].facets = std::move(found.number_of);
    faces_[k - 1].vertices = std::move(found.keys);
  }
}

std::size_t PureComplex::count(int k) const {
  if (k < 0 || k > dimension()) return 0;
  const auto at = static_cast<std::size_t>(k);
  return faces_[at].vertices.size() / (at + 1);
}

std::int64_t PureComplex::euler_characteristic() const {
  std::int64_t result = 0;
  for (int k = 0; k <= dimension(); ++k) {
    const auto faces = static_cast<std::int64_t>(count(k));
    result += k % 2 == 0 ? faces : -faces;
  }
  return result;
}

std::span<const std::uint32_t> PureComplex::vertices(int k, std::size_t face) const {
  const auto at = static_cast<std::size_t>(k);
  return std::span(faces_[at].vertices).subspan(face * (at + 1), at + 1);
}

std::span<const std::uint32_t> PureComplex::facets(int k, std::size_t face) const {
  const auto at = static_cast<std::size_t>(k);
  return std::span(faces_[at].facets).subspan(face * (at + 1), at + 1);
}

}  // namespace delcert
