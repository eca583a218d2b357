#pragma once

#include <span>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"
#include "proofs/formula/evaluation.hpp"

namespace delcert {

namespace types {
inline const Type simplex{"simplex", false};
inline const Type simplices{"simplex", true};
inline const Type point{"point", false};
}  // namespace types

/// A simplex of an instance: rational coordinates in ℝᵐ, or rational squared edge lengths.
class SimplexObject : public Object {
 public:
  using Points = std::vector<std::vector<Rational>>;

  /// Throw std::invalid_argument unless there is a vertex, all points have the same dimension, and the squared edges
  /// are those of some simplex of a Euclidean space.
  explicit SimplexObject(Points points);
  explicit SimplexObject(const SymmetricMatrix<Rational>& squared_edges);

  [[nodiscard]] std::size_t vertex_count() const { return gram_.vertex_count(); }
  [[nodiscard]] std::size_t dimension() const { return gram_.dimension(); }
  /// m for a simplex with coordinates in ℝᵐ, k for one that is known by its edges only.
  [[nodiscard]] std::size_t ambient_dimension() const;
  [[nodiscard]] bool has_coordinates() const { return !points_.empty(); }
  [[nodiscard]] const Points& points() const { return points_; }
  [[nodiscard]] const EdgeGram<Rational>& exact_gram() const { return gram_; }

  /// The face of the vertices listed.
  [[nodiscard]] SimplexObject face(std::span<const std::size_t> vertices) const;

  /// Its Gram matrix on a rung, computed once for an instance.
  template <class S>
  [[nodiscard]] const EdgeGram<S>& gram(Evaluation<S>& evaluation) const {
    // From the exact matrix, so that every entry is as tight as the rung allows.
    return evaluation.template attached<EdgeGram<S>>(
        *this, [&] { return EdgeGram<S>(matrix_from<S>(gram_.gram()), matrix_from<S>(gram_.squared_edge_matrix())); });
  }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  SimplexObject(Points points, EdgeGram<Rational> gram) : points_(std::move(points)), gram_(std::move(gram)) {}
  Points points_;
  EdgeGram<Rational> gram_;
};

/// A point of an instance, by rational coordinates.
class PointObject : public Object {
 public:
  explicit PointObject(std::vector<Rational> coordinates) : coordinates_(std::move(coordinates)) {}
  [[nodiscard]] const std::vector<Rational>& coordinates() const { return coordinates_; }
  template <class S>
  [[nodiscard]] std::vector<S> on() const {
    std::vector<S> result;
    for (const Rational& coordinate : coordinates_) result.push_back(scalar_from<S>(coordinate));
    return result;
  }
  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  std::vector<Rational> coordinates_;
};

/// Exact numbers as JSON text and back; throw InputError for a text that is not a number, naming `where`.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<Rational>& numbers);
[[nodiscard]] std::vector<Rational> rationals_from(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace delcert
