#include "properties/instances/distortion_map_class.hpp"
#include "properties/instances/instance_class.hpp"
#include "properties/instances/simplex_class.hpp"
#include "properties/instances/simplex_pair_class.hpp"

namespace delcert {

// One line for each class, in alphabetical order.
const std::vector<const InstanceClass*>& instance_classes() {
  static const std::vector<const InstanceClass*> classes{
      &distortion_map_class(),
      &simplex_class(),
      &simplex_pair_class(),
  };
  return classes;
}

}  // namespace delcert
