#include "kernel/perturb/colouring.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// For each label, colours that it must not have.
class Forbidden {
 public:
  explicit Forbidden(std::size_t labels) : bits_(labels, 0) {}

  void forbid(std::uint32_t label, std::uint32_t colour) {
    if (colour >= 64 * words_) widen();
    bits_[label * words_ + colour / 64] |= std::uint64_t{1} << (colour % 64);
  }
  [[nodiscard]] std::uint32_t least_allowed(std::uint32_t label) const {
    std::uint32_t result = 0;
    for (std::size_t word = 0; word < words_; ++word) {
      const int taken = std::countr_one(bits_[label * words_ + word]);
      result += static_cast<std::uint32_t>(taken);
      if (taken < 64) break;
    }
    return result;
  }

 private:
  void widen() {
    std::vector<std::uint64_t> wider(2 * bits_.size(), 0);
    for (std::size_t at = 0; at < bits_.size(); ++at) wider[at / words_ * 2 * words_ + at % words_] = bits_[at];
    bits_ = std::move(wider);
    words_ *= 2;
  }

  std::size_t words_ = 1;  // for each label
  std::vector<std::uint64_t> bits_;
};

}  // namespace

template <int m>
std::vector<std::uint32_t> more_colours_of(const Atlas<m>& atlas, const Rational& reach,
                                           std::vector<std::uint32_t> known, std::uint32_t end,
                                           const Progress& progress) {
  const auto sighted_from = [&](std::size_t first, std::size_t last) {
    std::vector<std::vector<std::uint32_t>> result;
    std::vector<Sighting<m>> seen;
    for (auto index = static_cast<std::uint32_t>(first); index < last; ++index) {
      const double length = approximate_double(reach * atlas.sampling_radius(Label(index)));
      atlas.sightings(Label(index), length * (1 + 0x1p-30), seen);
      auto& others = result.emplace_back();
      for (const auto& sighting : seen) {
        if (sighting.index != index) others.push_back(sighting.index);
      }
    }
    return result;
  };
  std::vector<std::uint32_t> colours;
  Forbidden forbidden(atlas.size());
  in_parts("colour", end, progress, sighted_from, [&](const auto& sighted) {
    for (const auto& others : sighted) {
      const auto index = static_cast<std::uint32_t>(colours.size());
      for (const std::uint32_t other : others) {
        if (other < index) forbidden.forbid(index, colours[other]);
      }
      const std::uint32_t colour = index < known.size() ? known[index] : forbidden.least_allowed(index);
      for (const std::uint32_t other : others) {
        if (other > index) forbidden.forbid(other, colour);
      }
      colours.push_back(colour);
    }
  });
  return colours;
}

template <int m>
std::vector<std::uint32_t> colours_of(const Atlas<m>& atlas, const Rational& reach, const Progress& progress) {
  return more_colours_of<m>(atlas, reach, {}, static_cast<std::uint32_t>(atlas.size()), progress);
}

#define DELCERT_INSTANTIATE(m)                                                                                         \
  template std::vector<std::uint32_t> colours_of<m>(const Atlas<m>&, const Rational&, const Progress&);                \
  template std::vector<std::uint32_t> more_colours_of<m>(const Atlas<m>&, const Rational&, std::vector<std::uint32_t>, \
                                                         std::uint32_t, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
