#include "kernel/manifold/submanifold/zero_set.hpp"

#include "support/error.hpp"

namespace delcert {

ZeroSet::ZeroSet(SubmanifoldDescription description) : description_(std::move(description)) {
  const std::size_t ambient = description_.variables.size();
  const std::size_t codimension = description_.equations.size();
  const auto refuse = [&](const std::string& reason) { throw InputError(description_.name + ": " + reason); };
  if (ambient < 2 || ambient > most_ambient_dimensions)
    refuse("there are " + std::to_string(ambient) + " variables: 2 to " + std::to_string(most_ambient_dimensions) +
           " are supported");
  if (codimension < 1 || static_cast<std::size_t>(description_.dimension.value) + codimension != ambient)
    refuse("its dimension is " + std::to_string(description_.dimension.value) + ", with " + std::to_string(ambient) +
           " variables and " + std::to_string(codimension) + " equations: it is the difference of the two");
  if (description_.box.size() != ambient)
    refuse("the box has " + std::to_string(description_.box.size()) + " sides, one for each variable is needed");
  for (std::size_t axis = 0; axis < ambient; ++axis) {
    if (description_.box[axis][0] >= description_.box[axis][1])
      refuse("the side of the box for " + description_.variables[axis] + " is empty");
  }
  map_ = std::make_shared<const FormulaMap>(description_.variables, description_.equations);
}

}  // namespace delcert
