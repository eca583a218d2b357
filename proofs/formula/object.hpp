#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "kernel/formula/expression.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

/// What a formula can speak of besides numbers: a simplex, a point, a net … Exact data, the same on every rung.
class Object {
 public:
  Object() = default;
  Object(const Object&) = default;
  Object(Object&&) = default;
  Object& operator=(const Object&) = default;
  Object& operator=(Object&&) = default;
  virtual ~Object() = default;

  /// The exact data, from which the kind's reader makes an equal object.
  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
};

using ObjectPointer = std::shared_ptr<const Object>;

/// A value that does not depend on the rung: an integer (a dimension, the number of a vertex) or an object.
using Item = std::variant<long, ObjectPointer>;

/// What an instance binds a name to.
using Binding = std::variant<Rational, long, ObjectPointer>;

/// The names of an instance and what they stand for, in alphabetical order.
using Bindings = std::map<std::string, Binding>;

}  // namespace delcert
