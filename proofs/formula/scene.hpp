#pragma once

#include <memory>
#include <tuple>
#include <typeindex>
#include <vector>

#include "kernel/number/algebraic.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// What one rung has computed about one instance.
template <class S>
struct RungCache {
  struct Number {
    const Function* function;
    std::vector<Item> arguments;
    Partial<S> value;
  };
  struct Attachment {
    const Object* object;
    std::type_index type;
    std::shared_ptr<const void> value;
  };
  std::vector<Number> numbers;
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
  template <class Value>
  struct Derived {
    const Function* function;
    std::vector<Item> arguments;
    Value value;
  };

  const Bindings& bindings_;
  std::vector<Derived<Item>> items_;
  std::vector<Derived<std::vector<Item>>> sets_;
  std::tuple<RungCache<Interval>, RungCache<BigInterval>, RungCache<Surd>, RungCache<Algebraic>> caches_;
};

}  // namespace delcert
