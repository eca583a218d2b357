#pragma once

#include <algorithm>

#include "kernel/manifold/atlas_file.hpp"
#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {

/// A built-in atlas.
inline FormulaAtlasDescription atlas_named(const std::string& name) {
  const auto& files = builtin_atlases();
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const BuiltinManifold& one) { return one.name == name; });
  if (file == files.end()) throw std::logic_error("no atlas " + name);
  return parse_atlas(file->text, file->name);
}

/// The open box |x_k| < r, and a core of r' about the same centre.
inline FormulaAtlasDescription::Chart cube_chart(const std::string& name, std::vector<std::string> variables,
                                                 const Rational& r, const Rational& core) {
  const std::size_t m = variables.size();
  return {name, std::move(variables), Sides(m, {-r, r}), Sides(m, {-core, core})};
}

/// Two squares with one transition.
inline FormulaAtlasDescription two_charts(const Rational& r, const Rational& core,
                                          FormulaAtlasDescription::Transition transition) {
  return {"two",
          Dimension(2),
          {cube_chart("n", {"x", "y"}, r, core), cube_chart("s", {"u", "v"}, r, core)},
          {std::move(transition)},
          {}};
}

/// The inversion in the unit circle, which glues two squares to a sphere.
inline FormulaAtlasDescription::Transition inversion() {
  return {0, 1, {"x/(x^2 + y^2)", "y/(x^2 + y^2)"}, {"u/(u^2 + v^2)", "v/(u^2 + v^2)"}, {}};
}

}  // namespace delcert::test
