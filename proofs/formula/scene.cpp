#include "proofs/formula/scene.hpp"

namespace delcert {

const Binding* Scene::find(const std::string& name) const {
  const auto found = bindings_.find(name);
  return found == bindings_.end() ? nullptr : &found->second;
}

Item Scene::item(const Function& function, const std::vector<Item>& arguments) {
  if (const Item* known = items_.find(function, arguments)) return *known;
  return items_.add(function, arguments, std::get<ItemFunction>(function.value)(arguments));
}

std::vector<Item> Scene::set(const Function& function, const std::vector<Item>& arguments) {
  if (const auto* known = sets_.find(function, arguments)) return *known;
  return sets_.add(function, arguments, std::get<SetFunction>(function.value)(arguments));
}

}  // namespace delcert
