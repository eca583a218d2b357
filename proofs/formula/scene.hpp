#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <typeindex>
#include <vector>

#include "kernel/number/algebraic.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The value of a function for arguments that do not depend on the rung.
template <class Value>
struct KnownValue {
  const Function* function;
  std::vector<Item> arguments;
  Value value;
};

/// Known values, found again by function and arguments. A simplex has hundreds of faces, so their hashes stand close
/// together and are compared first.
template <class Value>
class KnownValues {
 public:
  /// nullptr if it is not known; valid until another is added.
  [[nodiscard]] const Value* find(const Function& function, std::span<const Item> arguments) const {
    const std::size_t hash = hash_of(function, arguments);
    for (std::size_t at = 0; at < hashes_.size(); ++at) {
      if (hashes_[at] != hash) continue;
      const KnownValue<Value>& known = values_[at];
      if (known.function == &function && std::ranges::equal(known.arguments, arguments)) return &known.value;
    }
    return nullptr;
  }
  const Value& add(const Function& function, std::span<const Item> arguments, Value value) {
    hashes_.push_back(hash_of(function, arguments));
    values_.push_back({&function, {arguments.begin(), arguments.end()}, std::move(value)});
    return values_.back().value;
  }
  void clear() {
    hashes_.clear();
    values_.clear();
  }

 private:
  [[nodiscard]] static std::size_t hash_of(const Function& function, std::span<const Item> arguments) {
    constexpr std::size_t odd = 0x9e3779b97f4a7c15;
    std::size_t result = std::hash<const void*>()(&function);
    for (const Item& argument : arguments) result = (result ^ (result >> 29U)) * odd + std::hash<Item>()(argument);
    return result;
  }
  std::vector<std::size_t> hashes_;
  std::vector<KnownValue<Value>> values_;
};

/// What one rung has computed about one instance.
template <class S>
struct RungCache {
  struct Attachment {
    const Object* object;
    std::type_index type;
    std::shared_ptr<const void> value;
  };
  KnownValues<Partial<S>> numbers;
  std::vector<Attachment> attachments;
  unsigned precision = 0;  ///< in bits, where the rung has several

  void clear() {
    numbers.clear();
    attachments.clear();
  }
};

/// One instance while formulas are evaluated on it: its names, the objects derived from it (faces, images …), and what
/// each rung has computed already. Not for several threads at once.
class Scene {
 public:
  /// Precondition: the bindings outlive the scene and do not change.
  explicit Scene(const Bindings& bindings) : bindings_(bindings) {}
  explicit Scene(Bindings&&) = delete;

  /// nullptr if the name is not bound.
  [[nodiscard]] const Binding* find(const std::string& name) const;

  /// The value of a function that does not depend on the rung; computed once, so that a derived object has one address.
  [[nodiscard]] Item item(const Function& function, const std::vector<Item>& arguments);
  [[nodiscard]] std::vector<Item> set(const Function& function, const std::vector<Item>& arguments);

  template <class S>
  [[nodiscard]] RungCache<S>& cache() {
    return std::get<RungCache<S>>(caches_);
  }

 private:
  const Bindings& bindings_;
  KnownValues<Item> items_;
  KnownValues<std::vector<Item>> sets_;
  std::tuple<RungCache<Interval>, RungCache<BigInterval>, RungCache<Surd>, RungCache<Algebraic>> caches_;
};

}  // namespace delcert
