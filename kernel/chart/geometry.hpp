#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "kernel/chart/atlas.hpp"

namespace delcert {

/// What a model of charts offers so that perturbation, stars, repair and separation work on it as they are
/// (docs/geometry.md has what each operation promises). `Atlas` says the same with virtual functions; the concept is
/// what a model is held to at compile time, exact transitions above all: a point seen exactly, or nothing, never a
/// midpoint.
template <class Model, int m>
concept Geometry = std::derived_from<Model, Atlas<m>> &&
    requires(const Model& model, Label i, const Sighting<m>& route, double distance, std::vector<Sighting<m>>& out,
             const Vector<Filter, m>& on_filter, const Vector<BigInterval, m>& on_big,
             const Vector<Rational, m>& exact) {
  { model.size() } -> std::same_as<std::size_t>;
  { model.metric() } -> std::same_as<const FrameMetric<m>&>;
  { model.net() } -> std::same_as<const PointSet<m>&>;
  { model.sampling_radius(i) } -> std::same_as<const Rational&>;
  { model.is_interior(i) } -> std::same_as<bool>;
  { model.neighbours(i) } -> std::same_as<std::vector<Sighting<m>>>;
  { model.sightings(i, distance, out) } -> std::same_as<void>;
  { model.carry(i, route, on_filter) } -> std::same_as<Vector<Filter, m>>;
  { model.carry(i, route, on_big) } -> std::same_as<Vector<BigInterval, m>>;
  { model.carry(i, route, exact) } -> std::same_as<std::optional<Vector<Rational, m>>>;
  { model.has_exact_transitions() } -> std::same_as<bool>;
} && !std::is_abstract_v<Model>;

}  // namespace delcert
