#include "proofs/drawing/manifold/chart_manifold.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/formula/map_piece.hpp"
#include "kernel/formula/plain_formula.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "proofs/drawing/manifold/upper_triangle.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr double gap_between_charts = 0.1;
/// On the border of two pieces either will do.
constexpr double border_width = 0x1p-30;

/// Borders and map of each piece.
std::vector<std::pair<std::unique_ptr<FormulaMap>, std::unique_ptr<FormulaMap>>> drawn_pieces(
    const std::vector<std::string>& variables, const std::vector<std::string>& formulas) {
  std::vector<ExpressionPointer> trees;
  for (const std::string& formula : formulas)
    trees.push_back(parse_plain_formula(formula, variables, AbsoluteValues::allowed));
  const auto ring = std::make_shared<const PolynomialRing>(variables);
  const auto pieces = pieces_of(trees, variables, ring);
  if (!pieces) throw InputError("manifold: a transition is neither rational nor piecewise linear");
  std::vector<std::pair<std::unique_ptr<FormulaMap>, std::unique_ptr<FormulaMap>>> result;
  for (const MapPiece& piece : *pieces) {
    std::vector<std::string> borders;
    std::vector<std::string> map;
    for (const Polynomial& p : piece.nonnegative) borders.push_back(p.text());
    for (const RationalFunction& f : piece.map) map.push_back(f.numerator.text());
    result.emplace_back(std::make_unique<FormulaMap>(variables, borders),
                        std::make_unique<FormulaMap>(variables, piece.nonnegative.empty() ? formulas : map));
  }
  return result;
}

}  // namespace

ChartManifold::ChartManifold(const CertificateSummary& certificate)
    : m_(static_cast<std::size_t>(certificate.manifold.dimension.value)) {
  unit_ = approximate_double(certificate.parameter("sampling_radius"));
  const nlohmann::ordered_json json = manifold_json(certificate);
  std::vector<std::vector<std::string>> variables;
  double next = 0;
  for (const auto& chart : json.at("charts")) {
    Field field;
    field.name = chart.at("name").get<std::string>();
    for (const auto& side : chart.at("domain")) field.sides.push_back({number_of(side.at(0)), number_of(side.at(1))});
    if (field.sides.size() != m_) throw InputError("manifold: the box of a chart is not of its dimension");
    const double width = field.sides[0][1] - field.sides[0][0];
    field.shift = next - field.sides[0][0];
    next += (1 + gap_between_charts) * width;
    variables.push_back(chart.at("variables").get<std::vector<std::string>>());
    fields_.push_back(std::move(field));
  }
  for (const auto& transition : json.at("transitions")) {
    const auto from = transition.at("from").get<std::uint32_t>();
    const auto to = transition.at("to").get<std::uint32_t>();
    if (from >= fields_.size() || to >= fields_.size()) throw InputError("manifold: a transition names no chart");
    const auto where = transition.at("where").get<std::vector<std::string>>();
    for (const bool is_inverse : {false, true}) {
      const std::uint32_t here = is_inverse ? to : from;
      const auto formulas = transition.at(is_inverse ? "inverse" : "map").get<std::vector<std::string>>();
      for (auto& [border, map] : drawn_pieces(variables[here], formulas)) {
        Transition added{here,    is_inverse ? from : to, std::move(map), nullptr, is_inverse, nullptr,
                         nullptr, std::move(border),      nullptr};
        added.values = std::make_unique<FormulaEvaluation<double>>(*added.map);
        added.borders = std::make_unique<FormulaEvaluation<double>>(*added.border);
        if (!where.empty()) {
          added.condition = std::make_unique<FormulaMap>(variables[from], where);
          added.conditions = std::make_unique<FormulaEvaluation<double>>(*added.condition);
        }
        transitions_.push_back(std::move(added));
      }
    }
  }
  const auto net = certificate.net();
  if (net.size() != certificate.points.size() || certificate.charts.size() != certificate.points.size())
    throw InputError("net, charts: there is not one for each label");
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::vector<double> chart = doubles_of(certificate.charts[label]);
    if (chart.size() != 1 + m_ * (m_ + 1) / 2 || !(chart[0] >= 0 && chart[0] < static_cast<double>(fields_.size())))
      throw InputError("charts: label " + std::to_string(label) + " has no chart of the atlas");
    homes_.push_back(static_cast<std::uint32_t>(chart[0]));
    chart.erase(chart.begin());
    matrices_.push_back(std::move(chart));
    centres_.push_back(doubles_of(net[label]));
    std::vector<double> point = triangle_solution(matrices_.back(), doubles_of(certificate.points[label]));
    if (point.size() != m_ || centres_.back().size() != m_)
      throw InputError("points: label " + std::to_string(label) + " has not as many coordinates as it needs");
    for (std::size_t axis = 0; axis < m_; ++axis) point[axis] += centres_.back()[axis];
    points_.push_back(std::move(point));
  }
}

bool ChartManifold::is_inside(std::uint32_t field, const double* x) const {
  for (std::size_t axis = 0; axis < m_; ++axis) {
    const auto& side = fields_[field].sides[axis];
    if (!(side[0] < x[axis] && x[axis] < side[1])) return false;
  }
  return true;
}

std::optional<ApproximateManifold::Place> ChartManifold::place(std::uint32_t label, std::uint32_t sheet) const {
  Place result{static_cast<double>(sheet)};
  const std::vector<double>& x = points_.at(label);
  if (sheet == homes_[label]) {
    std::copy(x.begin(), x.end(), result.begin() + 1);
    return result;
  }
  std::vector<double> image(m_);
  for (const Transition& transition : transitions_) {
    if (transition.from != homes_[label] || transition.to != sheet) continue;
    std::vector<double> borders(transition.border->function_count());
    if (!transition.borders->value(x.data(), borders.data()) ||
        std::any_of(borders.begin(), borders.end(), [](double value) { return value < -border_width; }))
      continue;
    if (!transition.values->value(x.data(), image.data()) || !is_inside(sheet, image.data())) continue;
    if (transition.conditions) {
      std::vector<double> conditions(transition.condition->function_count());
      if (!transition.conditions->value(transition.on_target ? image.data() : x.data(), conditions.data())) continue;
      if (std::any_of(conditions.begin(), conditions.end(), [](double value) { return !(value > 0); })) continue;
    }
    std::copy(image.begin(), image.end(), result.begin() + 1);
    return result;
  }
  return std::nullopt;
}

std::uint32_t ChartManifold::cell_sheet(const DrawnSimplex& simplex) {
  // The home of as many of its vertices as can be, of those charts that show all of them.
  std::optional<std::uint32_t> best;
  std::size_t most = 0;
  for (const std::uint32_t first : simplex.labels) {
    const std::uint32_t sheet = homes_.at(first);
    const auto at_home = static_cast<std::size_t>(std::count_if(
        simplex.labels.begin(), simplex.labels.end(), [&](std::uint32_t label) { return homes_.at(label) == sheet; }));
    const bool shows_all = std::all_of(simplex.labels.begin(), simplex.labels.end(),
                                       [&](std::uint32_t label) { return place(label, sheet).has_value(); });
    if (shows_all && at_home > most) {
      most = at_home;
      best = sheet;
    }
  }
  if (!best) throw InputError("simplices[" + std::to_string(simplex.position) + "]: no chart shows all of it");
  return *best;
}

std::optional<ApproximateManifold::ChartPlace> ChartManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                       std::uint32_t) const {
  const auto there = place(j, homes_.at(i));
  if (!there) return std::nullopt;
  std::vector<double> difference(m_);
  for (std::size_t axis = 0; axis < m_; ++axis) difference[axis] = (*there)[axis + 1] - centres_[i][axis];
  difference = triangle_times(matrices_[i], difference);
  ChartPlace result{};
  std::copy(difference.begin(), difference.end(), result.begin());
  return result;
}

std::optional<std::vector<double>> ChartManifold::drawn(DrawingModel, const Place& place) const {
  std::vector<double> result(place.begin() + 1, place.begin() + 1 + static_cast<std::ptrdiff_t>(m_));
  result[0] += fields_.at(static_cast<std::size_t>(place[0])).shift;
  return result;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> ChartManifold::domain() {
  std::vector<std::pair<Place, Place>> result;
  for (std::size_t field = 0; field < fields_.size(); ++field) {
    for (std::size_t corner = 0; corner < (std::size_t{1} << m_); ++corner) {
      Place from{static_cast<double>(field)};
      for (std::size_t axis = 0; axis < m_; ++axis) from[axis + 1] = fields_[field].sides[axis][corner >> axis & 1U];
      for (std::size_t axis = 0; axis < m_; ++axis) {
        if ((corner >> axis & 1U) != 0) continue;
        Place to = from;
        to[axis + 1] = fields_[field].sides[axis][1];
        result.emplace_back(from, to);
      }
    }
  }
  return result;
}

}  // namespace delcert
