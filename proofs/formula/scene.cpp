#include "proofs/formula/scene.hpp"

namespace delcert {

const Binding* Scene::find(const std::string& name) const {
  const auto found = bindings_.find(name);
  return found == bindings_.end() ? nullptr : &found->second;
}

Item Scene::item(const Function& function, const std::vector<Item>& arguments) {
  for (const auto& known : items_) {
    if (known.function == &function && known.arguments == arguments) return known.value;
  }
  items_.push_back({&function, arguments, std::get<ItemFunction>(function.value)(arguments)});
  return items_.back().value;
}

std::vector<Item> Scene::set(const Function& function, const std::vector<Item>& arguments) {
  for (const auto& known : sets_) {
    if (known.function == &function && known.arguments == arguments) return known.value;
  }
  sets_.push_back({&function, arguments, std::get<SetFunction>(function.value)(arguments)});
  return sets_.back().value;
}

}  // namespace delcert
