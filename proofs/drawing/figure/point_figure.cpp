#include "proofs/drawing/figure/point_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace delcert {

namespace {

constexpr std::array<Figure::Colour, 4> inks{{{31, 78, 121}, {181, 55, 31}, {45, 125, 70}, {122, 79, 163}}};
constexpr std::size_t most_names = 40;          ///< vertices of larger sets have no numbers
constexpr double relative_rank = 1e-9;          ///< below it, relative to the greatest, an extent is taken to be zero
constexpr double distance_of_panels = 2.6;      ///< for drawings of radius one
constexpr double angle_of_view[] = {0.5, 0.4};  ///< radians, about the first and the second axis

/// Sets of one ambient dimension, in coordinates of which the first two are drawn.
class Panel {
 public:
  explicit Panel(std::vector<const DrawnSet*> sets) : sets_(std::move(sets)) {
    Eigen::Index count = 0;
    for (const DrawnSet* set : sets_) count += static_cast<Eigen::Index>(set->points.size());
    const auto ambient = static_cast<Eigen::Index>(sets_.front()->points.front().size());
    Eigen::MatrixXd all(ambient, count);
    Eigen::Index column = 0;
    for (const DrawnSet* set : sets_) {
      for (const auto& point : set->points)
        all.col(column++) = Eigen::Map<const Eigen::VectorXd>(point.data(), ambient);
    }
    all.colwise() -= all.rowwise().mean().eval();
    const Eigen::JacobiSVD<Eigen::MatrixXd> extents(all, Eigen::ComputeThinU);
    const Eigen::VectorXd& lengths = extents.singularValues();
    while (rank_ < lengths.size() && lengths[rank_] > relative_rank * lengths[0]) ++rank_;
    const Eigen::Index shown = std::min<Eigen::Index>(rank_, 3);
    places_ = Eigen::Matrix3Xd::Zero(3, count);
    if (shown > 0) places_.topRows(shown) = extents.matrixU().leftCols(shown).transpose() * all;
    const Eigen::Vector3d middle = (places_.rowwise().minCoeff() + places_.rowwise().maxCoeff()) / 2;
    places_.colwise() -= middle;
    radius_ = places_.colwise().norm().maxCoeff();
    if (!(radius_ > 0)) radius_ = 1;
    if (rank_ >= 3) {
      places_ = Eigen::AngleAxisd(angle_of_view[0], Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(angle_of_view[1], Eigen::Vector3d::UnitY()).toRotationMatrix() * places_;
    }
  }

  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] std::string description() const {
    std::vector<std::string> parts;
    for (const DrawnSet* set : sets_) {
      parts.push_back(set->is_simplex          ? fmt::format("the simplex {}", set->name)
                      : set->points.size() > 1 ? fmt::format("{} points of {}", set->points.size(), set->name)
                                               : fmt::format("the point {}", set->name));
    }
    return fmt::format("{}{}", fmt::join(parts, ", "),
                       is_projected() ? fmt::format(", projected from dimension {}", rank_) : std::string());
  }

  /// Adds it with its centre at this abscissa, all lengths multiplied.
  void draw(Figure& figure, double abscissa, double factor) const {
    const auto on_page = [&](const Eigen::Vector3d& place) {
      return Figure::Point{abscissa + factor * place[0], factor * place[1]};
    };
    Eigen::Index column = 0;
    for (std::size_t at = 0; at < sets_.size(); ++at) {
      const DrawnSet& set = *sets_[at];
      const Figure::Colour ink = inks.at(at % inks.size());
      const auto count = static_cast<Eigen::Index>(set.points.size());
      const Eigen::Matrix3Xd own = places_.middleCols(column, count);
      column += count;
      if (set.is_simplex) {
        if (!is_projected() && count > 2) add_ball_and_altitude(figure, own, ink, on_page, factor);
        Figure::Path edges{{}, false, std::nullopt, ink, 2};
        for (Eigen::Index a = 0; a < count; ++a) {
          for (Eigen::Index b = a + 1; b < count; ++b)
            edges.lines.push_back({on_page(own.col(a)), on_page(own.col(b))});
        }
        if (!edges.lines.empty()) figure.paths.push_back(edges);
      }
      for (Eigen::Index vertex = 0; vertex < count; ++vertex) {
        figure.dots.push_back({on_page(own.col(vertex)), 4, ink});
        const bool is_alone = !set.is_simplex && count == 1;
        if (set.points.size() <= most_names)
          figure.names.push_back({on_page(own.col(vertex)), is_alone ? set.name : std::to_string(vertex), ink});
      }
    }
  }

 private:
  [[nodiscard]] bool is_projected() const { return rank_ > 3; }

  template <class OnPage>
  static void add_ball_and_altitude(Figure& figure, const Eigen::Matrix3Xd& own, const Figure::Colour& ink,
                                    const OnPage& on_page, double factor) {
    const Eigen::Index k = own.cols() - 1;
    const auto edges_from = [&own, k](Eigen::Index vertex) {
      Eigen::Matrix3Xd result(3, k);
      for (Eigen::Index other = 0, at = 0; other <= k; ++other) {
        if (other != vertex) result.col(at++) = own.col(other) - own.col(vertex);
      }
      return result;
    };
    // The circumcentre c = p₀ + E x has 2 Eᵀ(c − p₀) = (|e_j|²)_j.
    const Eigen::Matrix3Xd edges = edges_from(0);
    const Eigen::MatrixXd gram = edges.transpose() * edges;
    const Eigen::FullPivLU<Eigen::MatrixXd> solver(gram);
    if (!solver.isInvertible()) return;
    const Eigen::Vector3d shift = edges * solver.solve(gram.diagonal() / 2);
    const Figure::Point centre = on_page(own.col(0) + shift);
    figure.circles.push_back({centre, factor * shift.norm(), ink, 1.2});
    figure.dots.push_back({centre, 2.5, ink});
    double least = 0;
    Eigen::Vector3d from;
    Eigen::Vector3d foot;
    for (Eigen::Index vertex = 0; vertex <= k; ++vertex) {
      // Onto the facet opposite: its edges from its first vertex.
      const Eigen::Matrix3Xd rays = edges_from(vertex);
      Eigen::Matrix3Xd facet = rays.rightCols(k - 1);
      facet.colwise() -= rays.col(0);
      const Eigen::Vector3d start = own.col(vertex) + rays.col(0);
      const Eigen::VectorXd along = facet.colPivHouseholderQr().solve(-rays.col(0));
      const Eigen::Vector3d end = start + facet * along;
      const double altitude = (end - own.col(vertex)).norm();
      if (vertex > 0 && altitude >= least) continue;
      least = altitude;
      from = own.col(vertex);
      foot = end;
    }
    figure.paths.push_back({{{on_page(from), on_page(foot)}}, false, std::nullopt, ink, 1.5, true});
  }

  std::vector<const DrawnSet*> sets_;
  Eigen::Index rank_ = 0;  ///< the dimension of the affine hull of all points
  Eigen::Matrix3Xd places_;
  double radius_ = 1;  ///< of a ball around the middle that has all points
};

}  // namespace

Figure figure_of(const std::vector<DrawnSet>& sets) {
  std::map<std::size_t, std::vector<const DrawnSet*>> by_dimension;
  for (const DrawnSet& set : sets) by_dimension[set.points.front().size()].push_back(&set);
  Figure result;
  std::vector<std::string> descriptions;
  const bool is_alone = by_dimension.size() == 1;
  for (const auto& [dimension, own] : by_dimension) {
    const Panel panel(own);
    panel.draw(result, distance_of_panels * static_cast<double>(descriptions.size()),
               is_alone ? 1 : 1 / panel.radius());
    if (is_alone) result.scale = round_scale(panel.radius() / 2);
    descriptions.push_back(panel.description());
  }
  result.description = fmt::format("{}", fmt::join(descriptions, "; "));
  return result;
}

}  // namespace delcert
