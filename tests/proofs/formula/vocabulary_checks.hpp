#pragma once

#include <gtest/gtest.h>

#include <string>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"
#include "tests/support/ratio.hpp"

namespace delcert {

inline void PrintTo(Verdict verdict, std::ostream* stream) { *stream << name_of(verdict); }

}  // namespace delcert

namespace delcert::test {

inline ObjectPointer simplex(SimplexObject::Points points) {
  return std::make_shared<SimplexObject>(std::move(points));
}
inline ObjectPointer point(std::vector<Rational> coordinates) {
  return std::make_shared<PointObject>(std::move(coordinates));
}

/// The simplex with all edges of the same length, by its edges.
inline ObjectPointer regular(std::size_t dimension, const Rational& squared_edge) {
  SymmetricMatrix<Rational> squared_edges(dimension + 1);
  for (std::size_t i = 0; i <= dimension; ++i) {
    for (std::size_t j = 0; j < i; ++j) squared_edges(i, j) = squared_edge;
  }
  return std::make_shared<SimplexObject>(squared_edges);
}

/// What the formula is about these names: decided up the whole ladder.
inline Verdict verdict(const std::string& formula, const Bindings& bindings) {
  Signature signature;
  for (const auto& [name, binding] : bindings) {
    if (std::holds_alternative<Rational>(binding)) {
      signature[name] = types::number;
    } else if (std::holds_alternative<long>(binding)) {
      signature[name] = types::integer;
    } else {
      const bool is_point = dynamic_cast<const PointObject*>(std::get<ObjectPointer>(binding).get()) != nullptr;
      signature[name] = is_point ? types::point : types::simplex;
    }
  }
  Scene scene(bindings);
  return decide_statement(*type_checked(parse_formula(formula), full_vocabulary(), signature, types::truth), scene);
}

/// Holds, and the same with the other sense does not.
inline void expect_equal(const std::string& left, const std::string& right, const Bindings& bindings) {
  EXPECT_EQ(verdict(left + " = " + right, bindings), Verdict::proved) << left << " = " << right;
  EXPECT_EQ(verdict(left + " < " + right, bindings), Verdict::refuted) << left << " < " << right;
}

}  // namespace delcert::test
