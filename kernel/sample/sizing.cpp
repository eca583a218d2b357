#include "kernel/sample/sizing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "kernel/number/exact_text.hpp"
#include "kernel/random/counter_random.hpp"
#include "kernel/sample/point_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::string_view by_curvature = "curvature:";

Rational exact_value(const std::string& text, std::string_view part) {
  try {
    return parse_exact(part);
  } catch (const ExactTextError& error) {
    throw InputError("--sizing " + text + ": " + error.what());
  }
}

/// k and ν of "curvature:k,ν".
std::array<double, 2> numbers_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto number = [&](std::string_view part) {
    const Rational value = exact_value(text, part);
    if (value <= Rational(0)) throw InputError("--sizing " + text + ": " + std::string(part) + " is not above 0");
    return approximate_double(value);
  };
  if (comma == std::string::npos) throw InputError("--sizing " + text + ": expected curvature:K,NU");
  const std::string_view whole = text;
  return {number(whole.substr(by_curvature.size(), comma - by_curvature.size())), number(whole.substr(comma + 1))};
}

Sizing sizing_by_curvature(const EmbeddedManifold& manifold, double greatest, double share, double slope,
                           std::uint64_t seed, const Progress& progress) {
  constexpr std::uint32_t batch = 4096;
  constexpr std::uint32_t most_batches = 64;
  constexpr std::uint32_t worth_throwing = 400;
  /// A cone is there if it makes e less by a relative 1/8 at its apex.
  constexpr double worth_adding = 0.875;
  const std::unique_ptr<ManifoldSampler> sampler = manifold.sampler(greatest);
  Sizing result(manifold.ambient(), greatest);
  std::uint32_t added = batch;
  for (std::uint32_t round = 0; round < most_batches && added * worth_throwing >= batch; ++round) {
    progress("look for curvature", round, most_batches);
    added = 0;
    for (std::uint32_t dart = round * batch; dart < (round + 1) * batch; ++dart) {
      // Other numbers than those that points are made from.
      CounterRandom random(seed, RandomPurpose::darts, dart, 1);
      std::vector<double> x = sampler->dart(random);
      if (!sampler->project(x, nullptr)) continue;
      const double radius = share / sampler->curvature(x);
      if (!(radius > 0) || !(radius < worth_adding * result.at(x.data()))) continue;
      result.add({std::move(x), radius, slope});
      ++added;
    }
  }
  return result;
}

}  // namespace

void Sizing::add(Cone cone) {
  cones_.push_back(std::move(cone));
  constexpr std::size_t few = 64;
  if (cones_.size() - in_tree_ < std::max(few, in_tree_ / 4)) return;
  in_tree_ = cones_.size();
  nodes_.clear();
  nodes_.push_back({0, in_tree_, 0, 0, 0, {}, {}});
  build(0, 0);
}

void Sizing::build(std::size_t node, std::size_t axis) {
  constexpr std::size_t few = 8;
  const std::size_t begin = nodes_[node].begin;
  const std::size_t end = nodes_[node].end;
  Node& own = nodes_[node];
  own.least_radius = own.least_slope = std::numeric_limits<double>::infinity();
  own.lower = own.upper = cones_[begin].apex;
  for (std::size_t at = begin; at < end; ++at) {
    own.least_radius = std::min(own.least_radius, cones_[at].radius);
    own.least_slope = std::min(own.least_slope, cones_[at].slope);
    for (std::size_t k = 0; k < dimension_; ++k) {
      own.lower[k] = std::min(own.lower[k], cones_[at].apex[k]);
      own.upper[k] = std::max(own.upper[k], cones_[at].apex[k]);
    }
  }
  if (end - begin <= few) return;
  const std::size_t half = begin + (end - begin) / 2;
  const auto place = [this](std::size_t at) { return cones_.begin() + static_cast<std::ptrdiff_t>(at); };
  std::nth_element(place(begin), place(half), place(end),
                   [axis](const Cone& a, const Cone& b) { return a.apex[axis] < b.apex[axis]; });
  const std::size_t left = nodes_.size();
  nodes_[node].left = left;
  nodes_.push_back({begin, half, 0, 0, 0, {}, {}});
  nodes_.push_back({half, end, 0, 0, 0, {}, {}});
  build(left, (axis + 1) % dimension_);
  build(left + 1, (axis + 1) % dimension_);
}

double Sizing::bound(const Node& node, const double* x) const {
  double squared = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double off = std::max({node.lower[k] - x[k], x[k] - node.upper[k], 0.0});
    squared += off * off;
  }
  return node.least_radius + node.least_slope * std::sqrt(squared);
}

double Sizing::at(const double* x) const {
  double result = greatest_;
  const auto look = [&](const Cone& cone) {
    if (!(cone.radius < result)) return;
    double squared = 0;
    for (std::size_t k = 0; k < dimension_; ++k) squared += (x[k] - cone.apex[k]) * (x[k] - cone.apex[k]);
    result = std::min(result, cone.radius + cone.slope * std::sqrt(squared));
  };
  for (std::size_t at = in_tree_; at < cones_.size(); ++at) look(cones_[at]);
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    if (!(bound(node, x) < result)) continue;
    if (node.left == 0) {
      for (std::size_t at = node.begin; at < node.end; ++at) look(cones_[at]);
      continue;
    }
    // The more promising one first.
    const bool is_left_last = bound(nodes_[node.left], x) > bound(nodes_[node.left + 1], x);
    open.push_back(is_left_last ? node.left : node.left + 1);
    open.push_back(is_left_last ? node.left + 1 : node.left);
  }
  return result;
}

double Sizing::least() const {
  double result = greatest_;
  for (const Cone& cone : cones_) result = std::min(result, cone.radius);
  return result;
}

bool SizingRequest::is_by_curvature() const { return text.starts_with(by_curvature); }

std::vector<Sizing::Cone> read_cones(const std::string& file, std::size_t dimension) {
  std::vector<Sizing::Cone> result;
  for (const auto& line : read_points(file, Dimension(static_cast<int>(dimension + 2)))) {
    const Rational& radius = line[dimension];
    const Rational& slope = line[dimension + 1];
    if (radius <= Rational(0) || slope < Rational(0))
      throw InputError(file + ": the radius of a cone is above 0, and its slope not below: found " +
                       exact_text(radius) + " and " + exact_text(slope));
    auto& cone = result.emplace_back();
    for (std::size_t axis = 0; axis < dimension; ++axis) cone.apex.push_back(approximate_double(line[axis]));
    cone.radius = approximate_double(radius);
    cone.slope = approximate_double(slope);
  }
  return result;
}

Sizing sizing_of(const SizingRequest& request, const EmbeddedManifold& manifold, double greatest, std::uint64_t seed,
                 const Progress& progress) {
  Sizing result(manifold.ambient(), greatest);
  if (request.text.empty()) return result;
  if (request.is_by_curvature()) {
    const auto [share, slope] = numbers_of(request.text);
    if (!manifold.is_smooth()) throw InputError("--sizing " + request.text + ": " + manifold.name() + " is not smooth");
    return sizing_by_curvature(manifold, greatest, share, slope, seed, progress);
  }
  for (Sizing::Cone& cone : read_cones(request.text, manifold.ambient())) result.add(std::move(cone));
  return result;
}

}  // namespace delcert
