#include "kernel/stars/approximate_star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// So much of the squared size of the images a determinant is above 0 that counts as such: far above its rounding.
constexpr double clearance = 0x1p-32;
/// Of the distances from the point: no image is farther than so many times another.
constexpr double most_spread = 0x1p12;

/// The images under the inversion, in units of the farthest; the origin stands for the point itself, and is last.
template <int m>
struct Inversion {
  std::vector<Vector<double, m>> image;
  std::vector<std::uint32_t> number;
  std::uint32_t farthest = 0;

  /// Whether distances allow for the determinants' rounding.
  bool fill(const std::vector<Vector<double, m>>& points, std::uint32_t home) {
    double nearest = std::numeric_limits<double>::infinity();
    double most = 0;
    image.reserve(points.size());
    for (std::uint32_t at = 0; at < points.size(); ++at) {
      if (at == home) continue;
      const auto y = difference(points[at], points[home]);
      const double squared = pairing(y, y);
      most = std::max(most, squared);
      if (squared < nearest) {
        nearest = squared;
        farthest = static_cast<std::uint32_t>(image.size());
      }
      image.push_back(scaled(1 / squared, y));
      number.push_back(at);
    }
    if (image.size() <= m || !(nearest > 0) || !(most <= nearest * most_spread * most_spread)) return false;
    const double unit = std::sqrt(nearest);
    for (auto& z : image) z = scaled(unit, z);
    image.push_back({});
    number.push_back(home);
    return true;
  }
  [[nodiscard]] std::uint32_t origin() const { return static_cast<std::uint32_t>(image.size()) - 1; }
};

/// The polygon of the images, counterclockwise from the farthest.
std::optional<std::vector<IndexSimplex<2>>> wrapped(const Inversion<2>& images) {
  std::vector<IndexSimplex<2>> result;
  const auto& z = images.image;
  std::uint32_t here = images.farthest;
  do {
    std::uint32_t next = here == 0 ? 1 : 0;
    const auto left_of = [&](std::uint32_t other) {
      const auto side = difference(z[next], z[here]);
      const auto way = difference(z[other], z[here]);
      return side[0] * way[1] - side[1] * way[0];
    };
    for (std::uint32_t other = 0; other < z.size(); ++other) {
      if (other != here && other != next && left_of(other) < 0) next = other;
    }
    for (std::uint32_t other = 0; other < z.size(); ++other) {
      if (other != here && other != next && !(left_of(other) > clearance)) return std::nullopt;
    }
    if (next == images.origin() || result.size() == z.size()) return std::nullopt;
    result.push_back({images.number[images.origin()], images.number[here], images.number[next]});
    here = next;
  } while (here != images.farthest);
  return result;
}

/// The facets of the hull of images in space.
class Wrapping {
 public:
  explicit Wrapping(const Inversion<3>& images) : images_(images), shadow_(images.image.size()) {}

  std::optional<std::vector<IndexSimplex<3>>> run() {
    // The nearest point, and the one that spans the least circle with it, are with the point itself in a simplex.
    open_.emplace_back(images_.farthest, second());
    open_.emplace_back(open_.back().second, open_.back().first);
    const std::size_t most_edges = 6 * images_.image.size();
    while (!open_.empty()) {
      const Edge edge = open_.back();
      open_.pop_back();
      if (is_done(edge)) continue;
      const auto apex = wrap(edge);
      if (!apex || !add(edge.first, edge.second, *apex) || done_.size() > most_edges) return std::nullopt;
    }
    return std::move(result_);
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  [[nodiscard]] bool is_done(const Edge& edge) const {
    return std::find(done_.begin(), done_.end(), edge) != done_.end();
  }

  /// A circle through the point itself is a line of images: the farthest line from the origin.
  [[nodiscard]] std::uint32_t second() const {
    const auto& z = images_.image;
    const auto& first = z[images_.farthest];
    std::uint32_t result = 0;
    double farthest = -1;
    for (std::uint32_t other = 0; other + 1 < z.size(); ++other) {
      if (other == images_.farthest) continue;
      const auto way = difference(z[other], first);
      const double along = pairing(way, first);
      const double squared = pairing(first, first) - along * along / pairing(way, way);
      if (squared > farthest) {
        farthest = squared;
        result = other;
      }
    }
    return result;
  }

  /// The image that turns the plane through an edge least far inwards: all others are clearly behind.
  [[nodiscard]] std::optional<std::uint32_t> wrap(const Edge& edge) {
    const auto& z = images_.image;
    const auto& a = z[edge.first];
    const auto axis = difference(z[edge.second], a);
    const double squared = pairing(axis, axis);
    // Two vectors that are orthogonal to the axis and to each other, of about its length.
    std::array<Vector<double, 3>, 3> pair{};
    std::size_t least = 0;
    for (std::size_t at = 1; at < 3; ++at) {
      if (std::fabs(axis[at]) < std::fabs(axis[least])) least = at;
    }
    pair[0] = axis;
    pair[1][least] = 1;
    const auto u = wedge<double, 3>(pair);
    pair[1] = u;
    const auto v = scaled(1 / std::sqrt(squared), wedge<double, 3>(pair));
    std::optional<std::uint32_t> result;
    for (std::uint32_t other = 0; other < z.size(); ++other) {
      const auto way = difference(z[other], a);
      shadow_[other] = {pairing(u, way), pairing(v, way)};
      if (other == edge.first || other == edge.second) continue;
      if (!result || turn(*result, other) > 0) result = other;
    }
    for (std::uint32_t other = 0; other < z.size(); ++other) {
      if (other == edge.first || other == edge.second || other == *result) continue;
      if (!(turn(*result, other) < -clearance * squared)) return std::nullopt;
    }
    if (*result == images_.origin()) return std::nullopt;
    return result;
  }
  [[nodiscard]] double turn(std::uint32_t from, std::uint32_t to) const {
    return shadow_[from][0] * shadow_[to][1] - shadow_[from][1] * shadow_[to][0];
  }

  /// Whether none of its edges was a facet's already.
  bool add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const Edge& edge : {Edge(a, b), Edge(b, c), Edge(c, a)}) {
      if (is_done(edge)) return false;
      done_.push_back(edge);
      open_.emplace_back(edge.second, edge.first);
    }
    result_.push_back({images_.number[images_.origin()], images_.number[a], images_.number[b], images_.number[c]});
    return true;
  }

  const Inversion<3>& images_;
  std::vector<Vector<double, 2>> shadow_;
  std::vector<Edge> open_;
  std::vector<Edge> done_;
  std::vector<IndexSimplex<3>> result_;
};

std::optional<std::vector<IndexSimplex<3>>> wrapped(const Inversion<3>& images) { return Wrapping(images).run(); }

}  // namespace

template <int m>
std::vector<IndexSimplex<m>> approximate_star(const std::vector<Vector<double, m>>& points, std::uint32_t home) {
  if constexpr (m == 2 || m == 3) {
    Inversion<m> images;
    if (images.fill(points, home)) {
      if (auto star = wrapped(images)) {
        for (auto& simplex : *star) std::sort(simplex.begin(), simplex.end());
        std::sort(star->begin(), star->end());
        return std::move(*star);
      }
    }
  }
  auto result = approximate_delaunay<m>(points);
  std::erase_if(result, [home](const IndexSimplex<m>& simplex) {
    return std::find(simplex.begin(), simplex.end(), home) == simplex.end();
  });
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                            \
  template std::vector<IndexSimplex<m>> approximate_star<m>(const std::vector<Vector<double, m>>& points, \
                                                            std::uint32_t home);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
