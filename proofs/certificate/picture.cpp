#include "proofs/certificate/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/error.hpp"

namespace delcert {

namespace {

using Point = std::array<double, 2>;

constexpr double picture_size = 720;
constexpr double margin = 12;

class Drawing {
 public:
  explicit Drawing(const CertificateSummary& certificate) : certificate_(certificate) {
    const auto gram = [&](std::size_t row, std::size_t column) {
      return approximate_double(certificate.manifold.gram[row][column]);
    };
    // Cartesian = Lᵀx with G = LLᵀ.
    first_ = {std::sqrt(gram(0, 0)), 0};
    second_ = {gram(1, 0) / first_[0], 0};
    second_[1] = std::sqrt(gram(1, 1) - second_[0] * second_[0]);
  }

  std::string svg() {
    std::string triangles;
    for (const auto& simplex : certificate_.simplices)
      triangles += triangle(frame_point(simplex.at(0), 0), frame_point(simplex.at(1), simplex.at(3)),
                            frame_point(simplex.at(2), simplex.at(4)));
    if (is_torus()) outline_ = {cartesian({0, 0}), cartesian({1, 0}), cartesian({1, 1}), cartesian({0, 1})};
    for (const Point& corner : outline_) include(corner);
    const double scale = (picture_size - 2 * margin) / std::max(highest_[0] - lowest_[0], highest_[1] - lowest_[1]);
    const double width = (highest_[0] - lowest_[0]) * scale + 2 * margin;
    const double height = (highest_[1] - lowest_[1]) * scale + 2 * margin;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        "<g transform=\"translate({2:.3f} {3:.3f}) scale({4:.5f} -{4:.5f})\" stroke=\"#1c3144\" "
        "stroke-width=\"{5:.6f}\" stroke-linejoin=\"round\">\n",
        width, height, margin - lowest_[0] * scale, margin + highest_[1] * scale, scale, 0.8 / scale);
    out += triangles;
    if (!outline_.empty()) {
      out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#c8102e\" stroke-width=\"{:.6f}\"/>\n", path(outline_),
                         2 / scale);
    }
    return out + "</g>\n</svg>\n";
  }

 private:
  [[nodiscard]] bool is_torus() const { return certificate_.manifold.family == ManifoldFamily::flat_torus; }
  [[nodiscard]] Point cartesian(const Point& x) const {
    return {first_[0] * x[0] + second_[0] * x[1], second_[1] * x[1]};
  }
  [[nodiscard]] Point frame_point(std::uint32_t label, std::uint32_t element) const {
    const auto& point = certificate_.points.at(label);
    Point result{approximate_double(point.at(0)), approximate_double(point.at(1))};
    if (element == 0) return result;
    for (std::size_t axis = 0; axis < 2; ++axis) result[axis] += certificate_.elements.at(element - 1).at(axis);
    return result;
  }

  void include(const Point& x) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lowest_[axis] = std::min(lowest_[axis], x[axis]);
      highest_[axis] = std::max(highest_[axis], x[axis]);
    }
  }

  static std::string path(const std::vector<Point>& points) {
    std::string result;
    for (const Point& point : points)
      result += fmt::format("{}{:.5f} {:.5f}", result.empty() ? "M" : "L", point[0], point[1]);
    return result + "Z";
  }

  std::string triangle(const Point& a, const Point& b, const Point& c) {
    const std::vector<Point> corners{cartesian(a), cartesian(b), cartesian(c)};
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      include(corners[k]);
      const Point& next = corners[(k + 1) % 3];
      longest = std::max(longest, std::hypot(next[0] - corners[k][0], next[1] - corners[k][1]));
    }
    const double area = std::abs((corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
                                 (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]));
    // Thickness: least altitude / (2 · longest edge), at most √3/4.
    const double share = std::clamp(area / (longest * longest) / (std::sqrt(3.0) / 2), 0.0, 1.0);
    return fmt::format("<path d=\"{}\" fill=\"rgb({:.0f} {:.0f} {:.0f})\"/>\n", path(corners), 250 - 150 * share,
                       240 - 70 * share, 220 + 10 * share);
  }

  const CertificateSummary& certificate_;
  Point first_{};
  Point second_{};
  Point lowest_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point highest_{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::vector<Point> outline_;
};

}  // namespace

std::string picture_svg(const CertificateSummary& certificate) {
  if (certificate.manifold.dimension != Dimension(2)) {
    throw InputError("pictures are of two-dimensional certificates; this one has dimension " +
                     std::to_string(certificate.manifold.dimension.value));
  }
  if (certificate.family != "flat-torus" && certificate.family != "euclidean-ball")
    throw InputError("pictures are of flat tori and Euclidean balls; this one is of the family " + certificate.family);
  return Drawing(certificate).svg();
}

}  // namespace delcert
