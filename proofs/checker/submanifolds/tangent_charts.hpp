#pragma once

#include <functional>
#include <memory>

#include "proofs/checker/certificate/submanifold.hpp"
#include "proofs/checker/charts/chart_stars.hpp"
#include "proofs/checker/geometry/near_points.hpp"

namespace delcert::checker {

class Polyhedron;

/// The charts of a submanifold M: U_i, what is in the cylinder of a chart, is a graph over its disc.
class TangentCharts : public StarCharts<Ball> {
 public:
  explicit TangentCharts(const Certificate& c);
  ~TangentCharts() override;

  /// The rules sub.*, whatever level is looked at. All else presumes that they hold.
  std::string check(Report& report);

  const Submanifold& manifold() const { return M_; }
  const TangentChart<Interval>& chart(Label i) const { return charts_[i]; }
  const TangentPatch& patch(Label i) const { return patches_[i]; }
  /// The perturbed point in R^N, that of U_j over its home coordinates, or a vertex that is given.
  const Matrix<Interval>& point(Label j) const { return points_[j]; }
  const NearPoints& points() const { return near_points_; }
  const NearPoints& centres() const { return near_centres_; }
  /// Of a mesh; otherwise none.
  const Polyhedron* polyhedron() const { return polyhedron_.get(); }
  /// A bound below 1 of |1 - Y Df N| in the cylinder.
  double theta(Label i) const { return theta_[i]; }

  ShownPoints<Ball> shown(Label i, const Quantity& radius) const override;
  Vector<Interval> home(Label i, In<Interval>) const override { return c_.points.position<Interval>({i, {}}); }
  Vector<Ball> home(Label i, In<Ball>) const override { return c_.points.position<Ball>({i, {}}); }
  std::string fault_of_patches(Level level) const override;

  struct Cell;  // of the division of a cylinder

 private:
  struct Drift;
  void check_graph(Label i, Report& report);
  bool check_fibres(Label i, double& theta);
  bool has_fibres_at_once(Label i, double& theta);
  bool check_slopes(Label i, const Matrix<Interval>& foot);
  bool is_flat_at_once(Label i, const Matrix<Interval>& z, const Interval& blur);
  std::shared_ptr<const Drift> drift_in(Label i, const Matrix<Interval>& place);
  bool holds_in_cells(Label i, Matrix<Interval> box, const std::function<bool(Matrix<Interval>&)>& clip,
                      const std::function<Verdict(const Cell&, const Matrix<Interval>&, const Matrix<Interval>&,
                                                  std::vector<double>&)>& question);
  bool is_flat_at_corners(Label i, const Matrix<Interval>& place, const Matrix<Interval>& rise,
                          const std::vector<Matrix<Interval>>& changes, double more) const;
  Matrix<Interval> position_of(Label i, const Matrix<Interval>& place) const;
  Matrix<Interval> cylinder(Label i) const;
  bool clip_to_disc(Label i, Matrix<Interval>& place) const;
  bool is_middle_in_disc(Label i, const Matrix<Interval>& place) const;
  void check_box(Label i, Report& report) const;
  void check_radii(Label i, Report& report) const;
  void check_cover(Report& report);
  struct Cover;
  template <class N>
  TangentChart<N> chart_as(Label i) const;
  template <class N>
  Matrix<N> height_over(const TangentChart<N>& chart, const Matrix<N>& home, int steps) const;
  template <class N>
  Matrix<N> point_as(Label j) const;

  const Submanifold& M_;
  std::unique_ptr<Polyhedron> polyhedron_;
  mutable FormulaValues<Interval> values_;
  std::vector<TangentChart<Interval>> charts_;
  std::vector<TangentPatch> patches_;
  std::vector<double> theta_;  // |1 - Y Df N| <= theta < 1 in the cylinder
  std::vector<double>
      lid_;  // no point of M over the disc is as high as this, or has the height between it and `height`
  std::vector<Matrix<Interval>> points_;
  NearPoints near_points_, near_centres_;
  std::size_t cells_ = 0, parts_ = 0;
};

/// Levels 5, 5i and 6, as the functions of run.hpp: along the normals W, |K| is moved to M.
class GraphTriangulation {
 public:
  explicit GraphTriangulation(const TangentCharts& charts);
  std::string check(Report& report);            // 5
  std::string check_embedding(Report& report);  // 5i, after 5
  std::string check_metric(Report& report);     // 6, after 5

  /// After `check`: what a simplex is moved by along chart i, at most.
  double movement_in(Label i, std::size_t s) const { return greatest_lateral(i, s) * climb_[s]; }
  /// Whether in chart i the place of label k is farther than `by` beyond the hyperplane of a facet of the simplex.
  bool is_beside(Label i, Label k, std::size_t s, double by) const;

 private:
  /// What is known of f and W on a simplex, in the chart of one of its vertices. All numbers are upper bounds.
  struct Estimate {
    std::vector<Matrix<Interval>> slopes;  // Df at the vertices, by the second derivatives; or of facets
    double bend = 0;                       // |D^2 f|
    double around = 0;                     // displacement: how far from the simplex that is
    double theta = 0;                      // |1 - Df W|
    double longest = 0;                    // edge in R^N
    double climb = 0;                      // |s|
  };

  /// For a mesh, one for each vertex, with the greatest theta and climb; otherwise one.
  std::vector<Estimate> estimates(std::size_t s);
  Estimate estimate(std::size_t s);
  std::vector<Estimate> estimates_of_mesh(std::size_t s) const;
  double height_between(std::size_t s, double longest) const;
  void check_simplex(std::size_t s, Report& report);
  double contraction_in(Label i, std::size_t s, const Estimate& estimate) const;
  bool is_clear_of(Label k, std::size_t s) const;
  std::vector<bool> roomy_labels() const;
  std::vector<bool> wide_stars() const;
  double altitude_at(std::size_t k, std::size_t s) const;
  struct Straight;  // a simplex in R^N
  Straight straight(std::size_t s) const;
  bool are_apart(const Straight& a, const Straight& b) const;
  struct Extent {
    double low, high, moved;
  };
  Extent extent(const Matrix<Interval>& normal, const Matrix<Interval>& base, const Straight& one) const;
  bool are_apart_along(const Matrix<Interval>& normal, const Straight& a, const Straight& b) const;
  std::string check_pairs(Report& report);
  std::string check_normals(Report& report);
  double least_cosine(std::size_t s);
  void check_stretch(std::size_t s, Report& report);
  void check_cotangents(Report& report) const;
  /// |N_i^T (p'_v - c_i)|_inf + margin < height, certainly.
  bool is_below_lid(Label i, Label v, double margin) const;
  /// Upper bounds of |E_i^T W_v|, for one label or the greatest for those of a simplex.
  double lateral(Label i, Label v) const;
  double greatest_lateral(Label i, std::size_t s) const;
  /// The gradients of the barycentric coordinates of a simplex in chart i, one a row.
  Matrix<Interval> gradients(Label i, std::size_t s) const;
  /// The map from chart i to R^N that takes the simplex of the chart to the straight one.
  Matrix<Interval> lifted(Label i, std::size_t s) const;

  const TangentCharts& charts_;
  const Certificate& c_;
  FormulaValues<Interval> values_, middle_values_;
  std::vector<Interval> displacement_;            // of each simplex: what the claim is there
  std::vector<double> climb_, longest_;           // of each simplex: what |s| is at most; its longest edge in R^N
  std::vector<double> contraction_;               // of each vertex of each simplex, in its chart
  std::vector<double> least_climb_, most_climb_;  // of the simplices of each label
};

/// Level 4, after level 5, as the functions of run.hpp.
std::string check_restricted_delaunay(const TangentCharts& charts, const GraphTriangulation& triangulation,
                                      Report& report);

/// Level 1f, as the functions of run.hpp.
std::string check_given_stars(const Certificate& c, Report& report);

}  // namespace delcert::checker
