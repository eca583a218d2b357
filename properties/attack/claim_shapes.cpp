#include "properties/attack/claim_shapes.hpp"

namespace delcert {

std::vector<Shape> usual_shapes(const Claim& claim) {
  if (!claim.points) return instance_class(claim.instance).shapes();
  std::vector<Shape> result;
  for (int number = claim.points->number.least; number <= claim.points->number.most; ++number) {
    for (int m = claim.points->dimension.least; m <= claim.points->dimension.most; ++m) {
      result.push_back({number - 1, m});
    }
  }
  return result;
}

bool has_shape(const Claim& claim, const Shape& shape) {
  if (!claim.points) return instance_class(claim.instance).has(shape);
  return claim.points->number.contains(shape.k + 1) && claim.points->dimension.contains(shape.m);
}

}  // namespace delcert
