#include "properties/instances/adaptive_sampling_class.hpp"
#include "properties/instances/configuration_point_class.hpp"
#include "properties/instances/curved_configuration_class.hpp"
#include "properties/instances/curved_net_class.hpp"
#include "properties/instances/distortion_map_class.hpp"
#include "properties/instances/exponential_charts_class.hpp"
#include "properties/instances/forbidden_configuration_class.hpp"
#include "properties/instances/instance_class.hpp"
#include "properties/instances/local_net_class.hpp"
#include "properties/instances/point_set_class.hpp"
#include "properties/instances/run_class.hpp"
#include "properties/instances/simplex_class.hpp"
#include "properties/instances/simplex_pair_class.hpp"
#include "properties/instances/stable_net_class.hpp"
#include "properties/instances/transported_configuration_class.hpp"

namespace delcert {

// One line for each class, in alphabetical order.
const std::vector<const InstanceClass*>& instance_classes() {
  static const std::vector<const InstanceClass*> classes{
      &adaptive_sampling_class(),
      &curved_configuration_class(),
      &curved_net_class(),
      &distortion_map_class(),
      &exponential_charts_class(),
      &forbidden_configuration_class(),
      &local_net_class(),
      &configuration_point_class(),
      &point_set_class(),
      &run_class(),
      &simplex_class(),
      &simplex_pair_class(),
      &stable_net_class(),
      &transported_configuration_class(),
  };
  return classes;
}

}  // namespace delcert
