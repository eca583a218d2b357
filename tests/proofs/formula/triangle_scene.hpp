#pragma once

#include <memory>
#include <string_view>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "proofs/formula/type_check.hpp"
#include "tests/proofs/formula/words_about_simplices.hpp"

// Formulas about a right triangle, a flat one and a few numbers.

namespace delcert::triangle_scene {

using words_about_simplices::vocabulary;

/// A right triangle with legs 3 and 4; t lies on a line.
inline const Bindings& bindings() {
  static const Bindings result = [] {
    using Points = SimplexObject::Points;
    const auto simplex = [](Points points) -> Binding {
      return ObjectPointer(std::make_shared<SimplexObject>(std::move(points)));
    };
    Bindings made;
    made["s"] = simplex({{0, 0}, {3, 0}, {0, 4}});
    made["t"] = simplex({{0, 0}, {1, 0}, {2, 0}});
    made["v"] = simplex({{1, 2}});
    made["k"] = 2L;
    made["n"] = -1L;
    made["x"] = Rational(Integer(1), Integer(3));
    made["zero"] = Rational(0);
    return made;
  }();
  return result;
}

inline const Signature& signature() {
  static const Signature result{{"s", types::simplex},  {"t", types::simplex}, {"v", types::simplex},
                                {"k", types::integer},  {"n", types::integer}, {"x", types::number},
                                {"zero", types::number}};
  return result;
}

inline ExpressionPointer typed(std::string_view text, const Type& type) {
  return type_checked(parse_formula(text), vocabulary(), signature(), type);
}

inline Verdict decided(std::string_view text) {
  Scene scene(bindings());
  return decide_statement(*typed(text, types::truth), scene);
}

inline std::optional<Rational> exactly(std::string_view text) {
  Scene scene(bindings());
  return exact_value(*typed(text, types::number), scene);
}

}  // namespace delcert::triangle_scene
