#pragma once

#include <utility>
#include <vector>

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

namespace types {
inline const Type sizing{"sizing", false};
}  // namespace types

/// The function x ↦ min (h + ν|x − c|) over finitely many cones with apex c and height h > 0: positive and ν-Lipschitz.
class SizingObject : public Object {
 public:
  struct Cone {
    std::vector<Rational> apex;
    Rational height;
  };

  /// Throws InputError unless ν ≥ 0, there is a cone, heights are above 0, and apexes have the same dimension, 1 or
  /// more.
  SizingObject(Rational slope, std::vector<Cone> cones);

  [[nodiscard]] const Rational& slope() const { return slope_; }
  [[nodiscard]] const std::vector<Cone>& cones() const { return cones_; }
  [[nodiscard]] std::size_t dimension() const { return cones_.front().apex.size(); }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Rational slope_;
  std::vector<Cone> cones_;
};

/// Adds the kind sizing, the values of such functions, and the distance of points.
void add_sizing_quantities(Vocabulary& vocabulary);

}  // namespace delcert
