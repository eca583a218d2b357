#include "kernel/manifold/gluing/formula_atlas.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <string>

#include "kernel/manifold/gluing/piecewise_values.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The half-widths of cells over √(B⁻¹)_kk·ε.
constexpr double glued_cell_factor = 1.5;

/// Evaluations of one map, for as many threads as ask for one.
template <class S>
class EvaluationPool {
 public:
  explicit EvaluationPool(const std::vector<CellMap>& pieces) : pieces_(pieces) {}

  template <class Use>
  auto with_one(const Use& use) {
    auto evaluation = taken();
    const auto result = use(*evaluation);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(evaluation));
    return result;
  }

 private:
  std::unique_ptr<PiecewiseValues<S>> taken() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        auto result = std::move(idle_.back());
        idle_.pop_back();
        return result;
      }
    }
    return std::make_unique<PiecewiseValues<S>>(pieces_);
  }

  const std::vector<CellMap>& pieces_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PiecewiseValues<S>>> idle_;
};

template <int m>
std::vector<Vector<Rational, m>> coordinates_of(const std::vector<NetPlace<m>>& net) {
  std::vector<Vector<Rational, m>> result;
  for (const NetPlace<m>& place : net) result.push_back(place.x);
  return result;
}

/// A cell is divided until its image is this part of the chart's box, and the entries of the derivative are known up to
/// this part of the greatest; at most so often along each axis.
constexpr double widest_image = 8;
constexpr double widest_derivative = 16;
constexpr int most_halvings_of_images = 4;

/// Whether all entries are as narrow as that.
bool are_narrow(const Interval* entries, std::size_t count) {
  double widest = 0;
  double greatest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    widest = std::max(widest, entries[k].upper() - entries[k].lower());
    greatest = std::max({greatest, entries[k].upper(), -entries[k].lower()});
  }
  return widest * widest_derivative <= greatest;
}

Interval hull(const Interval& a, const Interval& b) {
  return Interval::between(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
}

bool are_the_same_pieces(const std::vector<CellMap>& a, const std::vector<CellMap>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const CellMap& one, const CellMap& other) {
    return one.map() == other.map() && one.nonnegative() == other.nonnegative();
  });
}

/// The piece of the region that this point is in; of several, which do the same there, the first.
const CellMap& piece_at(const std::vector<CellMap>& pieces, const std::vector<Rational>& x) {
  return *std::find_if(pieces.begin(), pieces.end(), [&](const CellMap& piece) {
    return std::all_of(piece.nonnegative().begin(), piece.nonnegative().end(),
                       [&](const Polynomial& p) { return p.at(x) >= Rational(0); });
  });
}

double middle_double(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }

}  // namespace

template <int m>
struct FormulaAtlas<m>::Evaluations {
  std::vector<std::unique_ptr<EvaluationPool<Interval>>> on_filter;
  std::vector<std::unique_ptr<EvaluationPool<double>>> plain;
};

template <int m>
FormulaAtlas<m>::FormulaAtlas(std::shared_ptr<const ChartGluing> gluing, const std::vector<NetPlace<m>>& net,
                              Rational sampling_radius)
    : AffineAtlas<m>(coordinates_of<m>(net), std::move(sampling_radius)),
      gluing_(std::move(gluing)),
      evaluations_(std::make_unique<Evaluations>()) {
  require_places(net);
  for (const NetPlace<m>& place : net) home_.push_back(place.chart);
  for (const auto& transition : gluing_->transitions()) {
    evaluations_->on_filter.push_back(std::make_unique<EvaluationPool<Interval>>(transition.pieces));
    evaluations_->plain.push_back(std::make_unique<EvaluationPool<double>>(transition.pieces));
  }
  GluingMetric<m> metric(*gluing_);
  this->make_charts([&](Label i) { return metric.enclosed_at({home_[i.value], this->centres().approximate(i)}); });
  choose_patches();
  find_appearances();
  fill_cells();
}

template <int m>
FormulaAtlas<m>::~FormulaAtlas() = default;
template <int m>
FormulaAtlas<m>::FormulaAtlas(FormulaAtlas&&) noexcept = default;

template <int m>
void FormulaAtlas<m>::require_places(const std::vector<NetPlace<m>>& net) const {
  for (std::size_t label = 0; label < net.size(); ++label) {
    const std::string what = "label " + std::to_string(label);
    if (net[label].chart >= gluing_->chart_count()) throw InputError(what + " is in no chart of the atlas");
    const auto& chart = gluing_->chart(net[label].chart);
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Rational& coordinate = net[label].x[axis];
      if (coordinate <= chart.domain[axis][0] || coordinate >= chart.domain[axis][1])
        throw InputError(what + " has the coordinate " + exact_text(coordinate) + ", outside of the chart " +
                         chart.name);
    }
  }
}

template <int m>
void FormulaAtlas<m>::choose_patches() {
  Label where{0};
  const bool fits = [&] {
    const RoundingGuard guard;
    return this->fit_patch_factor(
        [&](Label i, std::size_t axis) {
          const auto& side = gluing_->chart(home_[i.value]).domain[axis];
          const Rational centre = this->centre(i)[axis];
          return scalar_from<Interval>(minimum(centre - side[0], side[1] - centre)).lower();
        },
        where);
  }();
  if (fits) return;
  throw Rejection(gluing_->description().name + ": the sampling radius " + exact_text(this->sampling_radius()) +
                  " is too large: a patch of 4 of it about label " + std::to_string(where.value) +
                  " does not fit into the chart " + gluing_->chart(home_[where.value]).name +
                  ": take a smaller radius, or charts that overlap more");
}

template <int m>
double FormulaAtlas<m>::patch_reach() const {
  return scalar_from<Interval>(this->patch_radius()).upper();
}

template <int m>
Vector<double, m> FormulaAtlas<m>::in_unit_cube(const Shown& shown, const Vector<Interval, m>& place) const {
  Vector<double, m> result;
  for (std::size_t axis = 0; axis < m; ++axis)
    result[axis] = std::clamp(0.25 + (middle_double(place[axis]) - shown.lowest[axis]) * shown.scale[axis], 0.0, 0.75);
  return result;
}

template <int m>
void FormulaAtlas<m>::find_appearances() {
  shown_.resize(gluing_->chart_count());
  const RoundingGuard guard;
  std::vector<PiecewiseCells> on_cells;
  for (const auto& transition : gluing_->transitions()) on_cells.emplace_back(transition.pieces);
  for (std::uint32_t index = 0; index < this->size(); ++index) note_appearances(Label(index), on_cells);
}

template <int m>
void FormulaAtlas<m>::include_image(const MapOnCell& found, const Interval* derivative, bool is_first,
                                    Appearance& seen) {
  constexpr auto n = static_cast<std::size_t>(m);
  for (std::size_t row = 0; row < n; ++row) {
    seen.image[row] = is_first ? found.image[row] : hull(seen.image[row], found.image[row]);
    for (std::size_t column = 0; column < n; ++column) {
      Interval& entry = seen.derivative[row][column];
      entry = is_first ? derivative[row * n + column] : hull(entry, derivative[row * n + column]);
    }
  }
}

template <int m>
typename FormulaAtlas<m>::Following FormulaAtlas<m>::follow(std::size_t transition, const Cell& still,
                                                            const Cell& moved, PiecewiseCells& on_cells,
                                                            Appearance& seen) const {
  constexpr auto n = static_cast<std::size_t>(m);
  struct Part {
    Cell cell;
    int halvings;
  };
  const Sides& box = gluing_->chart(gluing_->transitions()[transition].to).domain;
  const Cell whole = cell_around(box);
  bool is_first = true;
  std::vector<Part> parts{{moved, 0}};
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    const MapOnCell found = on_cells.on(part.cell);
    if (found.is_excluded) continue;
    bool is_narrow = found.is_regular;
    for (std::size_t axis = 0; axis < m && is_narrow; ++axis)
      is_narrow = found.image[axis].upper() - found.image[axis].lower() <=
                  (whole[axis].upper() - whole[axis].lower()) / widest_image;
    std::array<Interval, n * n> derivative;
    const auto is_differentiable = [&](PiecewiseValues<Interval>& map) {
      return centred_derivative(map, part.cell, n, derivative.data());
    };
    const bool is_known = is_narrow && evaluations_->on_filter[transition]->with_one(is_differentiable);
    is_narrow = is_known && are_narrow(derivative.data(), n * n);
    if (!is_narrow && part.halvings < most_halvings_of_images * m) {
      const auto axis = static_cast<std::size_t>(part.halvings % m);
      const double middle = middle_double(part.cell[axis]);
      Part half{part.cell, part.halvings + 1};
      half.cell[axis] = Interval::between(part.cell[axis].lower(), middle);
      parts.push_back(half);
      half.cell[axis] = Interval::between(middle, part.cell[axis].upper());
      parts.push_back(half);
      continue;
    }
    if (!found.is_regular || !(is_known || evaluations_->on_filter[transition]->with_one(is_differentiable)))
      return Following::uncertain;
    include_image(found, derivative.data(), is_first, seen);
    is_first = false;
  }
  if (is_first) return Following::nowhere;
  // What is outside of the box is in no patch.
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double lower = std::max(seen.image[axis].lower(), whole[axis].lower());
    const double upper = std::min(seen.image[axis].upper(), whole[axis].upper());
    if (lower > upper) return Following::nowhere;
    seen.image[axis] = Interval::between(lower, upper);
  }
  seen.is_seen = evaluations_->on_filter[transition]->with_one(
      [&](PiecewiseValues<Interval>& map) { return map.value(still.data(), seen.place.data()); });
  return seen.is_seen || on_cells.on(still).is_excluded ? Following::somewhere : Following::uncertain;
}

template <int m>
void FormulaAtlas<m>::note_appearances(Label i, std::vector<PiecewiseCells>& on_cells) {
  const Interval radius = scalar_from<Interval>(greatest_displacement() * this->sampling_radius());
  Appearance at_home{i.value, 0, true, enclosed_centre(i), {}, {}};
  Cell moved;
  Cell still;
  for (std::size_t axis = 0; axis < m; ++axis) {
    still[axis] = at_home.place[axis];
    const Interval half = radius * Interval::exactly(this->enclosed(i).stretch[axis]);
    moved[axis] = Interval::between((still[axis] - half).lower(), (still[axis] + half).upper());
    at_home.image[axis] = moved[axis];
    at_home.derivative[axis][axis] = Interval(1);
  }
  shown_[home_[i.value]].appearances.push_back(at_home);
  std::vector<std::size_t> followed;
  for (std::size_t t = 0; t < gluing_->transitions().size(); ++t) {
    const ChartGluing::Transition& transition = gluing_->transitions()[t];
    if (transition.from != home_[i.value]) continue;
    Appearance seen{i.value, static_cast<std::uint32_t>(t + 1), false, {}, {}, {}};
    const Following found = follow(t, still, moved, on_cells[t], seen);
    if (found == Following::nowhere) continue;
    if (found == Following::uncertain)
      throw Undecided(gluing_->description().name + ": label " + std::to_string(i.value) + ": " + transition.name +
                      " is not certainly defined about it, nor certainly not: take a smaller radius");
    // The same function may be listed for several pieces.
    const bool is_known = std::any_of(followed.begin(), followed.end(), [&](std::size_t other) {
      return gluing_->transitions()[other].to == transition.to &&
             are_the_same_pieces(gluing_->transitions()[other].pieces, transition.pieces);
    });
    if (is_known) continue;
    followed.push_back(t);
    shown_[transition.to].appearances.push_back(seen);
  }
}

template <int m>
void FormulaAtlas<m>::fill_cells() {
  Vector<double, m> widths{};
  for (std::uint32_t index = 0; index < this->size(); ++index)
    widths = sum(widths, this->enclosed(Label(index)).stretch);
  widths = scaled(glued_cell_factor * approximate_double(this->sampling_radius()) / static_cast<double>(this->size()),
                  widths);
  for (std::size_t chart = 0; chart < shown_.size(); ++chart) {
    Shown& shown = shown_[chart];
    Vector<double, m> unit;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const auto& side = gluing_->chart(chart).domain[axis];
      shown.lowest[axis] = approximate_double(side[0]);
      shown.scale[axis] = 0.5 / approximate_double(side[1] - side[0]);
      unit[axis] = widths[axis] * shown.scale[axis];
    }
    shown.by_place = std::make_unique<TorusCells<m>>(unit);
    shown.by_image = std::make_unique<TorusCells<m>>(unit);
    for (std::uint32_t at = 0; at < shown.appearances.size(); ++at) {
      const Appearance& seen = shown.appearances[at];
      if (seen.is_seen) shown.by_place->insert(at, in_unit_cube(shown, seen.place));
      shown.by_image->insert(at, in_unit_cube(shown, seen.image));
      for (std::size_t axis = 0; axis < m; ++axis)
        shown.spread[axis] = std::max(shown.spread[axis], seen.image[axis].upper() - seen.image[axis].lower());
    }
  }
}

template <int m>
void FormulaAtlas<m>::sightings(Label i, double distance, std::vector<Sighting<m>>& out) const {
  out.clear();
  const Vector<double, m> half_widths = scaled(distance, this->enclosed(i).stretch);
  const RoundingGuard guard;
  const double most = distance * distance;  // rounded upwards
  const Vector<Interval, m> here = enclosed_centre(i);
  const Shown& shown = shown_[home_[i.value]];
  visit_cells(shown, *shown.by_place, here, half_widths, [&](const Appearance& seen) {
    if (this->may_be_within(i, difference(seen.place, here), most)) out.push_back({seen.label, {}, seen.route});
  });
  std::sort(out.begin(), out.end());
}

template <int m>
void FormulaAtlas<m>::throw_undefined(std::size_t transition) const {
  throw Undecided(gluing_->description().name + ": " + gluing_->transitions()[transition].name +
                  " is not certainly defined at a point that it is asked for");
}

template <int m>
template <class S>
Vector<S, m> FormulaAtlas<m>::offset_on(Label i, const Sighting<m>& seen, const Vector<S, m>& moved) const {
  const Vector<S, m> x = sum(this->centres().template coordinates<S>(label_of<m>(seen)), moved);
  const Vector<S, m> centre = this->centres().template coordinates<S>(i);
  if (seen.element == 0) return difference(x, centre);
  const std::size_t transition = seen.element - 1;
  Vector<S, m> there;
  if constexpr (std::same_as<S, Interval>) {
    const bool is_defined = evaluations_->on_filter[transition]->with_one(
        [&](PiecewiseValues<Interval>& map) { return map.value(x.data(), there.data()); });
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!is_defined) there.fill(Interval::between(-infinity, infinity));
  } else if constexpr (std::same_as<S, Rational>) {
    const std::vector<Rational> place(x.begin(), x.end());
    const CellMap& piece = piece_at(gluing_->transitions()[transition].pieces, place);
    for (std::size_t axis = 0; axis < m; ++axis) {
      const auto value = value_at(piece.map()[axis], place);
      if (!value) throw_undefined(transition);
      there[axis] = *value;
    }
  } else if constexpr (std::same_as<S, BigInterval>) {
    PiecewiseValues<BigInterval> map(gluing_->transitions()[transition].pieces);
    if (!map.value(x.data(), there.data())) throw_undefined(transition);
  } else {
    Vector<double, m> plain;
    Vector<double, m> image;
    for (std::size_t axis = 0; axis < m; ++axis) plain[axis] = x[axis].lower();
    (void)evaluations_->plain[transition]->with_one(
        [&](PiecewiseValues<double>& map) { return map.value(plain.data(), image.data()); });
    for (std::size_t axis = 0; axis < m; ++axis) there[axis] = S::exactly(image[axis]);
  }
  return difference(there, centre);
}

template <int m>
Vector<Filter, m> FormulaAtlas<m>::offset(Label i, const Sighting<m>& seen, const Vector<Filter, m>& moved) const {
  return offset_on<Filter>(i, seen, moved);
}
template <int m>
Vector<BigInterval, m> FormulaAtlas<m>::offset(Label i, const Sighting<m>& seen,
                                               const Vector<BigInterval, m>& moved) const {
  return offset_on<BigInterval>(i, seen, moved);
}
template <int m>
Vector<Rational, m> FormulaAtlas<m>::offset(Label i, const Sighting<m>& seen, const Vector<Rational, m>& moved) const {
  return offset_on<Rational>(i, seen, moved);
}

template class FormulaAtlas<2>;
template class FormulaAtlas<3>;

}  // namespace delcert
