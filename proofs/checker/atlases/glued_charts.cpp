#include "proofs/checker/atlases/glued_charts.hpp"

#include <algorithm>

#include "proofs/checker/atlases/gluing_verification.hpp"

namespace delcert::checker {
namespace {

Cell as_cell(const Vector<Interval>& x, std::size_t m) {
  Cell result(m, 1);
  for (std::size_t k = 0; k < m; ++k) result[k] = x[k];
  return result;
}
Vector<Interval> as_vector(const Cell& x) {
  Vector<Interval> result{};
  for (std::size_t k = 0; k < x.size(); ++k) result[k] = x[k];
  return result;
}
Vector<Interval> enclosed(const Vector<Rational>& x) {
  return {enclosure(x[0]), enclosure(x[1]), enclosure(x[2]), enclosure(x[3])};
}

/// The image of a point, exactly; none where a denominator vanishes.
std::optional<Vector<Rational>> image_of(const RationalMap& map, const Vector<Rational>& x) {
  Vector<Rational> result{};
  for (std::size_t k = 0; k < map.size(); ++k) {
    const Rational below = map[k].denominator.at(x);
    if (below.sign() == 0) return std::nullopt;
    result[k] = map[k].numerator.at(x) / below;
  }
  return result;
}

bool is_inside(const Vector<Rational>& x, const Sides& box) {
  Verdict result = Verdict::proved;
  for (std::size_t k = 0; k < box.size(); ++k)
    result = conjunction(result, conjunction(less(box[k][0].exact, x[k]), less(x[k], box[k][1].exact)));
  return result == Verdict::proved;
}

}  // namespace

GluedCharts::GluedCharts(const Certificate& c) : AffineCharts(c), gluing_(*c.gluing) {
  for (Label i = 0; i < c.n; ++i) {
    homes_.push_back(c.home_chart(i));
    for (std::size_t k = 0; k < c.m_size(); ++k) greatest_stretch_ = std::max(greatest_stretch_, stretch(i)[k]);
  }
}

std::string GluedCharts::check(Report& report) {
  passages_ = passages_of(gluing_, [&](std::size_t t) {
    report.reject("atlas.inverse", [&] {
      return "map and inverse of transition " + std::to_string(t) + " are not inverse to one another";
    });
  });
  if (!report.findings.empty()) return "";
  for (const Passage& passage : passages_) values_.emplace_back(passage);
  const std::string summary = check_gluing(gluing_, passages_, report);
  for (Label i = 0; i < c_.n; ++i) check_patch(i, report);
  if (!report.findings.empty()) return "";
  find_appearances();
  for (Label j = 0; j < c_.n; ++j) check_distortion(j, report);
  return summary + "; " + std::to_string(c_.n) +
         " charts of labels, distorted by <= " + rounded_up(c_.distortion.exact);
}

/// atlas.patch: |x_k - c_k| <= patch_radius sqrt((B_i^-1)_kk) is in the open box.
void GluedCharts::check_patch(Label i, Report& report) const {
  const Vector<Rational> centre = c_.net.position<Rational>({i, {}});
  const Sides& box = gluing_.charts[homes_[i]].domain;
  bool inside = is_inside(centre, box);
  for (std::size_t k = 0; k < c_.m_size(); ++k) {
    Rational squared(0);
    for (std::size_t l = k; l < c_.m_size(); ++l) squared = squared + square(inverse(i)(k, l));
    squared = squared * square(gluing_.patch_radius.exact);
    for (const Rational& room : {centre[k] - box[k][0].exact, box[k][1].exact - centre[k]})
      inside = inside && less(squared, square(room)) == Verdict::proved;
  }
  if (!inside)
    report.reject("atlas.patch", [&] { return "the patch of label " + std::to_string(i) + " is not inside its box"; });
}

/// Whether the perturbed point is in the domain of the passage, and where it goes.
bool GluedCharts::is_in_domain(std::size_t number, Label j, Vector<Interval>& place) const {
  const Passage& passage = passages_[number];
  const OnCell found = values_[number].on(as_cell(point<Interval>(j), c_.m_size()));
  if (found.excluded) return false;
  if (found.regular && found.here == Verdict::proved && is_inside_open(found.image, *passage.box)) {
    place = as_vector(found.image);
    return true;
  }
  const Vector<Rational>& x = point<Rational>(j);
  for (const Polynomial& p : passage.positive) {
    if (p.at(x).sign() <= 0) return false;
  }
  for (const Polynomial& p : passage.region) {
    if (p.at(x).sign() < 0) return false;
  }
  for (const Polynomial& p : passage.nonzero) {
    if (p.at(x).sign() == 0) return false;
  }
  const auto image = image_of(passage.map, x);
  if (!image || !is_inside(*image, *passage.box)) return false;
  place = enclosed(*image);
  return true;
}

Vector<Rational> GluedCharts::exact_place(const Appearance& seen) const {
  const Vector<Rational>& x = point<Rational>(seen.label);
  return seen.passage ? *image_of(passages_[*seen.passage].map, x) : x;
}

void GluedCharts::find_appearances() {
  const std::size_t charts = gluing_.charts.size();
  shown_.resize(charts);
  at_home_.resize(charts);
  std::vector<std::vector<Matrix<Interval>>> places(charts), centres(charts);
  for (Label j = 0; j < c_.n; ++j) {
    const std::size_t home = homes_[j];
    at_home_[home].push_back(j);
    centres[home].push_back(as_cell(c_.net.position<Interval>({j, {}}), c_.m_size()));
    if (!is_inside(point<Rational>(j), gluing_.charts[home].domain)) continue;
    shown_[home].push_back({j, std::nullopt, point<Interval>(j)});
    for (std::size_t t = 0; t < passages_.size(); ++t) {
      if (passages_[t].from != home) continue;
      std::vector<Appearance>& there = shown_[passages_[t].to];
      // Where several passages lead to one chart they lead to one point of it: boxes are embedded.
      if (!there.empty() && there.back().label == j) continue;
      Vector<Interval> place{};
      if (is_in_domain(t, j, place)) there.push_back({j, t, place});
    }
  }
  for (std::size_t chart = 0; chart < charts; ++chart) {
    for (const Appearance& seen : shown_[chart]) places[chart].push_back(as_cell(seen.place, c_.m_size()));
    near_points_.emplace_back(places[chart]);
    near_centres_.emplace_back(centres[chart]);
  }
}

const Vector<Interval>* GluedCharts::place(std::size_t chart, Label j) const {
  const auto found = std::lower_bound(shown_[chart].begin(), shown_[chart].end(), j,
                                      [](const Appearance& seen, Label label) { return seen.label < label; });
  return found == shown_[chart].end() || found->label != j ? nullptr : &found->place;
}

ShownPoints<Rational> GluedCharts::shown(Label i, const Quantity& radius) const {
  const double most = radius.filter.upper();
  Interval squared(0);
  for (std::size_t k = 0; k < c_.m_size(); ++k) squared = squared + square(Interval::between(0, stretch(i)[k]));
  std::vector<const Appearance*> seen;
  near_points_[homes_[i]].visit(as_cell(c_.net.position<Interval>({i, {}}), c_.m_size()), most * upper_root(squared),
                                [&](std::uint32_t at) {
                                  const Appearance& one = shown_[homes_[i]][at];
                                  const Vector<Interval> x = in_chart<Interval>(i, one.place);
                                  if (dot(x, x, c_.m_size()).lower() <= most * most) seen.push_back(&one);
                                });
  std::sort(seen.begin(), seen.end(), [](const Appearance* a, const Appearance* b) { return a->label < b->label; });
  ShownPoints<Rational> result(c_.m_size());
  for (const Appearance* one : seen) result.add(one->label, in_chart<Interval>(i, one->place));
  result.exact = [this, i, seen = std::move(seen)](std::size_t at) {
    return in_chart<Rational>(i, exact_place(*seen[at]));
  };
  return result;
}

std::string GluedCharts::fault_of_patches(Level level) const {
  const Rational reach = level == level_1 ? c_.reach_1() : Rational(c_.reach_2s.exact);
  if (less(reach, gluing_.patch_radius.exact) == Verdict::proved) return "";
  return std::string(level == level_1 ? "perturbation + 2 circumradius + protection" : "reach") +
         " is not below patch_radius";
}

/// atlas.distortion: wherever a point within perturbation epsilon of p_j, in the chart of j, is in the patch of a label
/// i, the transition makes vectors longer by at most distortion.
void GluedCharts::check_distortion(Label j, Report& report) const {
  const std::size_t m = c_.m_size();
  const double moved = (c_.rho.filter * c_.epsilon.filter).upper();
  Cell cell(m, 1);
  const Vector<Interval> centre = c_.net.position<Interval>({j, {}});
  for (std::size_t k = 0; k < m; ++k) {
    const double half = moved * stretch(j)[k];
    cell[k] = centre[k] + Interval::between(-half, half);
  }
  check_stretches(j, passages_.size(), cell, 0, report);
  for (std::size_t t = 0; t < passages_.size(); ++t) {
    if (passages_[t].from == homes_[j]) check_stretches(j, t, cell, 0, report);
  }
}

/// Whether the rule holds on a cell.
Verdict GluedCharts::is_stretched_little(Label j, std::size_t passage, const Cell& cell) const {
  const std::size_t m = c_.m_size();
  const bool at_home = passage == passages_.size();
  const OnCell found = at_home ? OnCell{} : values_[passage].on(cell);
  if (found.excluded) return Verdict::proved;
  if (!at_home && !found.has_image) return Verdict::undecided;
  const bool known = at_home || found.regular;
  const Cell& image = at_home ? cell : found.image;
  const std::size_t chart = at_home ? homes_[j] : passages_[passage].to;
  Matrix<Interval> derivative(m, m);
  for (std::size_t k = 0; k < m * m; ++k) derivative[k] = enclosure(inverse(j)(k / m, k % m));
  if (!at_home && known) derivative = values_[passage].jacobian(cell) * derivative;
  const Interval& patch = gluing_.patch_radius.filter;
  Verdict all = Verdict::proved;
  // |x| <= sqrt(m) times the greatest coordinate.
  const double reach = patch.upper() * greatest_stretch_ * upper_root(Interval(static_cast<int>(m)));
  near_centres_[chart].visit(image, reach, [&](std::uint32_t at) {
    const Label i = at_home_[chart][at];
    if (i == j) return;
    const Vector<Interval> x = in_chart<Interval>(i, as_vector(image));
    const Verdict in_patch = less(dot(x, x, m), square(patch));
    if (in_patch == Verdict::refuted) return;
    Verdict little = Verdict::undecided;
    if (known) {
      Budget::spend(30);
      Matrix<Interval> here(m, m);
      for (std::size_t k = 0; k < m * m; ++k) here[k] = enclosed_matrix(i)(k / m, k % m);
      const Matrix<Interval> whole = here * derivative, gram = transposed_times(whole, whole);
      SquareMatrix<Interval> rest(m);
      for (std::size_t row = 0; row < m; ++row) {
        for (std::size_t k = 0; k < m; ++k)
          rest(row, k) = (row == k ? square(Interval(1) + c_.distortion.filter) : Interval(0)) - gram(row, k);
      }
      little = is_positive_definite(rest);
    }
    all = conjunction(all, disjunction(little, negation(in_patch)));
  });
  return all;
}

void GluedCharts::check_stretches(Label j, std::size_t passage, const Cell& cell, std::size_t halvings,
                                  Report& report) const {
  if (!report.findings.empty() || is_stretched_little(j, passage, cell) == Verdict::proved) return;
  constexpr std::size_t most_halvings = 8;
  const std::size_t m = c_.m_size();
  if (halvings == most_halvings * m) {
    return report.reject("atlas.distortion", [&] {
      return "the chart of " + std::to_string(j) + " and another may be distorted by more than distortion";
    });
  }
  for (const Cell& half : halves(cell, halvings % m)) check_stretches(j, passage, half, halvings + 1, report);
}

}  // namespace delcert::checker
