#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/manifold/submanifold/chart_fitting.hpp"
#include "kernel/manifold/submanifold/cover_check.hpp"
#include "kernel/manifold/submanifold/shown_facet.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long exponent_of_mesh_slope = -8;

/// What there is of a mesh in a cylinder, and whether rule sub.graph holds.
struct MeshPatch {
  std::string failure;               ///< empty if it holds, for slopes and heights such as these
  std::vector<std::uint32_t> named;  ///< the facets that it is about
  bool is_crease = false;            ///< whether it is about their slope
  double slope = 0;                  ///< an upper bound
  double lid = 0;                    ///< all vertices of the facets over the disc are lower
  double free = 0;                   ///< all other facets over the disc are higher, or lower, than this
};

class PatchSearch {
 public:
  PatchSearch(const PolyhedralMesh& mesh, const TangentChart& chart, const Rational& radius)
      : mesh_(mesh), chart_(chart.enclosed()), radius_(scalar_from<Interval>(radius)) {}

  MeshPatch search() {
    double high = 2 * radius_.upper();
    for (bool is_enough = false; !is_enough;) {
      gather(high);
      if (numbers_.empty() || !find_sheet()) {
        result_.failure = "there is no facet over its centre";
        return result_;
      }
      look_at_sheet();
      // Facets that are larger than the patch have vertices as high as that.
      is_enough = !result_.failure.empty() || result_.lid < high / 2;
      high = 4 * result_.lid;
    }
    if (result_.failure.empty()) look_at_others();
    if (result_.failure.empty()) count_over_a_place();
    return result_;
  }

 private:
  /// The facets that may be over the disc, as high as this.
  void gather(double high) {
    numbers_.clear();
    facets_.clear();
    is_in_sheet_.clear();
    result_ = {};
    const double reach = radius_.upper();
    const std::array<Interval, 3> place{Interval::between(-reach, reach), Interval::between(-reach, reach),
                                        Interval::between(-high, high)};
    std::vector<std::uint32_t> all;
    visit_facets(mesh_, chart_, place.data(), [&](std::uint32_t facet) { all.push_back(facet); });
    std::sort(all.begin(), all.end());
    for (const std::uint32_t facet : all) {
      const ShownFacet shown(mesh_, chart_, facet);
      if (misses_disc(shown)) continue;
      numbers_.push_back(facet);
      facets_.push_back(shown);
    }
    is_in_sheet_.resize(numbers_.size());
    result_.free = high;
  }

  /// Whether the facet's projection certainly does not meet the closed disc.
  [[nodiscard]] bool misses_disc(const ShownFacet& facet) const {
    const Interval zero(0);
    const bool has_side = is_refuted(is_zero(facet.normal[2]));
    if (has_side && !facet.is_certainly_not_over(zero, zero)) return false;
    const Interval squared = square(radius_);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto& from = facet.corners[edge];
      const auto& to = facet.corners[(edge + 1) % 3];
      const Interval dx = to[0] - from[0];
      const Interval dy = to[1] - from[1];
      const Interval along = -(from[0] * dx + from[1] * dy);
      const Interval length = square(dx) + square(dy);
      Interval distance;
      if (is_proved(less(along, zero))) {
        distance = square(from[0]) + square(from[1]);
      } else if (is_proved(less(length, along))) {
        distance = square(to[0]) + square(to[1]);
      } else {
        if (!is_refuted(is_zero(length))) return false;
        distance = square(from[0] * dy - from[1] * dx) / length;
      }
      if (!is_proved(less(squared, distance))) return false;
    }
    // A vertical facet has no interior over the disc that its edges do not have.
    return true;
  }

  /// The facets that are connected, over the disc, with the one that is over the centre and nearest to it.
  bool find_sheet() {
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0;
    for (std::size_t at = 0; at < facets_.size(); ++at) {
      const ShownFacet& facet = facets_[at];
      if (!is_refuted(is_zero(facet.normal[2])) || facet.is_certainly_not_over(Interval(0), Interval(0))) continue;
      const Interval height =
          facet.corners[0][2] +
          (facet.normal[0] * facet.corners[0][0] + facet.normal[1] * facet.corners[0][1]) / facet.normal[2];
      if (absolute(height).upper() < least) {
        least = absolute(height).upper();
        first = at;
      }
    }
    if (!std::isfinite(least)) return false;
    std::vector<std::size_t> open{first};
    is_in_sheet_[first] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const std::uint32_t neighbour : mesh_.neighbours(numbers_[at])) {
        const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), neighbour);
        if (found == numbers_.end() || *found != neighbour) continue;
        const auto other = static_cast<std::size_t>(found - numbers_.begin());
        if (is_in_sheet_[other]) continue;
        is_in_sheet_[other] = true;
        open.push_back(other);
      }
    }
    is_up_ = facets_[first].normal[2].lower() > 0;
    return true;
  }

  void look_at_sheet() {
    double steepest = 0;
    std::size_t worst = 0;
    for (std::size_t at = 0; at < facets_.size(); ++at) {
      if (!is_in_sheet_[at]) continue;
      const auto& normal = facets_[at].normal;
      const Interval up = is_up_ ? normal[2] : -normal[2];
      double slope = std::numeric_limits<double>::infinity();
      if (is_proved(less(Interval(0), up))) slope = (square_root(square(normal[0]) + square(normal[1])) / up).upper();
      if (slope > steepest) {
        steepest = slope;
        worst = at;
      }
      for (const auto& corner : facets_[at].corners) result_.lid = std::max(result_.lid, absolute(corner[2]).upper());
    }
    result_.slope = steepest;
    if (!(steepest <= 1)) {
      result_.named = {numbers_[worst]};
      result_.failure = "is steeper than 1 in it";
      result_.is_crease = true;
    }
  }

  /// What is over the disc and not of the sheet has to be beyond the lid.
  void look_at_others() {
    for (std::size_t at = 0; at < facets_.size(); ++at) {
      if (is_in_sheet_[at]) continue;
      double least = std::numeric_limits<double>::infinity();
      bool is_above = true;
      bool is_below = true;
      for (const auto& corner : facets_[at].corners) {
        is_above = is_above && is_proved(less(Interval(0), corner[2]));
        is_below = is_below && is_proved(less(corner[2], Interval(0)));
        least = std::min(least, absolute(corner[2]).lower());
      }
      if (!is_above && !is_below) least = 0;
      if (least >= result_.free) continue;
      result_.free = least;
      result_.named = {numbers_[at]};
    }
    if (result_.free > result_.lid * (1 + 0x1p-5)) {
      result_.named.clear();
    } else {
      result_.failure = "comes, from another part of the mesh, too near";
    }
  }

  /// Some place has exactly one facet of the sheet over it.
  void count_over_a_place() {
    constexpr int tries = 16;
    for (int k = 1; k <= tries; ++k) {
      const Interval x = radius_ * Interval(k) / Interval(3 * tries);
      const Interval y = radius_ * Interval(7 * k % tries) / Interval(5 * tries);
      std::vector<std::uint32_t> over;
      for (std::size_t at = 0; at < facets_.size(); ++at) {
        if (is_in_sheet_[at] && !facets_[at].is_certainly_not_over(x, y)) over.push_back(numbers_[at]);
      }
      if (over.size() == 1) {
        result_.named.clear();
        result_.failure.clear();
        return;
      }
      result_.named = over;
      result_.failure = "lie over one another in it";
    }
  }

  const PolyhedralMesh& mesh_;
  const EnclosedChart<Interval>& chart_;
  Interval radius_;
  std::vector<std::uint32_t> numbers_;
  std::vector<ShownFacet> facets_;
  std::vector<bool> is_in_sheet_;
  bool is_up_ = true;
  MeshPatch result_;
};

class MeshFitting {
 public:
  MeshFitting(const PolyhedralMesh& mesh, const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
              const Progress& progress)
      : mesh_(mesh), centres_(centres), radii_(radii), progress_(progress) {
    in_parts(
        "make charts", centres.size(), progress,
        [&](std::size_t first, std::size_t last) {
          const auto sampler = mesh.sampler(approximate_double(radii.greatest()));
          std::vector<TangentChart> found;
          for (std::size_t at = first; at < last; ++at) found.push_back(chart_about(*sampler, centres[at]));
          return found;
        },
        [&](std::vector<TangentChart> found) {
          for (TangentChart& chart : found) charts_.push_back(std::move(chart));
        });
  }

  FittedCharts fit() {
    for (const int quarters : patch_quarters) {
      const Rational factor = Rational(quarters) / Rational(4);
      if (auto slope = fitting_slope(factor)) return {std::move(charts_), std::move(*slope), factor};
    }
    throw TooCoarse(reason_, {place_});
  }

 private:
  TangentChart chart_about(ManifoldSampler& sampler, const std::vector<Rational>& centre) const {
    std::vector<double> x;
    for (const Rational& coordinate : centre) x.push_back(approximate_double(coordinate));
    const auto normals = sampler.normals(x);
    auto chart = normals ? tangent_chart(*normals, 1, centre) : std::nullopt;
    if (!chart) throw Rejection(mesh_.name() + ": no normal at " + rough_text(x));
    return *std::move(chart);
  }

  std::optional<Rational> fitting_slope(const Rational& factor) {
    double slope = 0;
    bool holds = true;
    std::size_t next = 0;
    in_parts(
        "look at patches", charts_.size(), progress_,
        [&](std::size_t first, std::size_t last) {
          std::vector<MeshPatch> found;
          // What is not so at one chart is not looked at any further.
          for (std::size_t at = first; at < last && (found.empty() || found.back().failure.empty()); ++at)
            found.push_back(patch_of(at, factor));
          return found;
        },
        [&](const std::vector<MeshPatch>& found) {
          for (const MeshPatch& patch : found) {
            slope = std::max(slope, patch.slope);
            if (!patch.failure.empty() && holds) {
              holds = false;
              note(next, factor, patch);
            }
            ++next;
          }
          if (!found.empty() && !found.back().failure.empty()) next += usual_part_size - found.size();
        });
    if (!holds) return std::nullopt;
    const Rational result =
        rounded_up(Rational::exactly(slope) * (Rational(1) + Rational::power_of_two(-10)), exponent_of_mesh_slope);
    if (result > Rational(1)) return std::nullopt;
    return std::max(result, Rational::power_of_two(exponent_of_mesh_slope));
  }

  /// Also gives the chart its size: heights as on zero sets if nothing else is so near.
  MeshPatch patch_of(std::size_t at, const Rational& factor) {
    const RoundingGuard guard;
    const Rational radius = factor * radii_.of(at);
    MeshPatch patch = PatchSearch(mesh_, charts_[at], radius).search();
    if (!patch.failure.empty()) return patch;
    const Rational lid = Rational::exactly(patch.lid);
    const Rational free = Rational::exactly(patch.free);
    Rational height =
        std::max(lid * (Rational(1) + Rational::power_of_two(-5)), radii_.of(at) * Rational(Integer(13), Integer(8)));
    if (height * (Rational(1) + Rational::power_of_two(-6)) > free) height = (lid + free) / Rational(2);
    charts_[at].set_size(radius, rounded_down(height, binary_exponent(height) - 10));
    return patch;
  }

  void note(std::size_t label, const Rational& factor, const MeshPatch& patch) {
    std::vector<double> x;
    for (const Rational& coordinate : centres_[label]) x.push_back(approximate_double(coordinate));
    place_ = x;
    reason_ = mesh_.name() + ": label " + std::to_string(label) + " at " + rough_text(x) + ", patch of " +
              exact_text(factor) + " sampling radii: ";
    for (std::size_t k = 0; k < std::min<std::size_t>(patch.named.size(), 8); ++k)
      reason_ += std::string(k == 0 ? "facet " : ", ") + std::to_string(patch.named[k]);
    reason_ += (patch.named.empty() ? "" : " ") + patch.failure;
    if (!patch.named.empty())
      reason_ += patch.is_crease
                     ? ": " + mesh_.crease_near(patch.named.front())
                     : ": the mesh meets itself there, or the sampling radius is too large between two sheets";
  }

  const PolyhedralMesh& mesh_;
  const std::vector<std::vector<Rational>>& centres_;
  const SamplingRadii& radii_;
  const Progress& progress_;
  std::vector<TangentChart> charts_;
  std::string reason_;
  std::vector<double> place_;
};

/// Facets in parts that are in one cylinder each.
class FacetCover {
 public:
  FacetCover(const PolyhedralMesh& mesh, const std::vector<TangentChart>& charts)
      : mesh_(mesh), charts_(charts), grid_(3, width(charts)) {
    for (const TangentChart& chart : charts) {
      std::array<double, 3> x{};
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = approximate_double(chart.data().centre[axis]);
      grid_.insert(x.data());
      reach_ = std::max(reach_, approximate_double(chart.data().radius));
    }
  }

  void cover(std::uint32_t facet, CoverReport& report) const {
    struct Part {
      std::array<std::array<Interval, 3>, 3> corners;
      int halvings;
    };
    std::vector<Part> open(1);
    for (std::size_t corner = 0; corner < 3; ++corner)
      std::copy_n(mesh_.point(facet, corner), 3, open[0].corners[corner].begin());
    open[0].halvings = 0;
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      ++report.parts;
      if (is_in_a_cylinder(part.corners)) continue;
      if (part.halvings == most_halvings_of_facet) {
        BoxPart& left = report.open.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Interval middle = (part.corners[0][axis] + part.corners[1][axis] + part.corners[2][axis]) / Interval(3);
          left.lower.push_back(middle.lower());
          left.upper.push_back(middle.upper());
        }
        return;
      }
      std::size_t longest = 0;
      double most = 0;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        Interval squared(0);
        for (std::size_t axis = 0; axis < 3; ++axis)
          squared += square(part.corners[(edge + 1) % 3][axis] - part.corners[edge][axis]);
        if (squared.upper() > most) {
          most = squared.upper();
          longest = edge;
        }
      }
      for (const std::size_t kept : {longest, (longest + 1) % 3}) {
        Part half = part;
        ++half.halvings;
        const std::size_t moved = kept == longest ? (longest + 1) % 3 : longest;
        for (std::size_t axis = 0; axis < 3; ++axis)
          half.corners[moved][axis] =
              (part.corners[longest][axis] + part.corners[(longest + 1) % 3][axis]) / Interval(2);
        open.push_back(half);
      }
    }
  }

 private:
  static constexpr int most_halvings_of_facet = 24;

  static double width(const std::vector<TangentChart>& charts) {
    double result = 0;
    for (const TangentChart& chart : charts) result = std::max(result, approximate_double(chart.data().radius));
    return result > 0 ? result : 1;
  }

  [[nodiscard]] bool is_in_a_cylinder(const std::array<std::array<Interval, 3>, 3>& corners) const {
    std::array<double, 3> x{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      x[axis] = (corners[0][axis].lower() + corners[1][axis].lower() + corners[2][axis].lower()) / 3;
    bool found = false;
    grid_.visit(x.data(), reach_, [&](std::uint32_t label, double) {
      found = std::all_of(corners.begin(), corners.end(), [&](const auto& corner) { return is_in(label, corner); });
      return found;
    });
    return found;
  }
  [[nodiscard]] bool is_in(std::uint32_t label, const std::array<Interval, 3>& x) const {
    const TangentChart& chart = charts_[label];
    const Interval squared =
        square(chart.enclosed().coordinate(x.data(), 0)) + square(chart.enclosed().coordinate(x.data(), 1));
    return is_proved(less(squared, square(scalar_from<Interval>(chart.data().radius)))) &&
           is_proved(
               less(absolute(chart.enclosed().coordinate(x.data(), 2)), scalar_from<Interval>(chart.data().height)));
  }

  const PolyhedralMesh& mesh_;
  const std::vector<TangentChart>& charts_;
  AmbientGrid grid_;
  double reach_ = 0;
};

}  // namespace

FittedCharts PolyhedralMesh::fit_charts(const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
                                        const Progress& progress) const {
  if (radii.greatest() <= Rational(0)) throw InputError("the sampling radius is above 0");
  if (centres.empty()) throw InputError("a net has at least one point");
  return MeshFitting(*this, centres, radii, progress).fit();
}

CoverReport PolyhedralMesh::check_cover(const std::vector<TangentChart>& charts, const Progress& progress) const {
  CoverReport result;
  const FacetCover cover(*this, charts);
  in_parts(
      "cover the mesh", mesh_.triangles.size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        CoverReport found;
        for (std::size_t facet = first; facet < last; ++facet) cover.cover(static_cast<std::uint32_t>(facet), found);
        return found;
      },
      [&](CoverReport found) {
        result.parts += found.parts;
        for (BoxPart& part : found.open) result.open.push_back(std::move(part));
      });
  return result;
}

std::optional<BoxPart> PolyhedralMesh::singular_part() const { return std::nullopt; }

}  // namespace delcert
