// Claims about simplices for tests, from their text.
#pragma once

#include <string>
#include <vector>

#include "proofs/formula/simplex_object.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert::test {

/// A claim about the class simplex with these lines of TOML after its name.
inline Claim claim_about_simplices(const std::string& name, const std::string& rest) {
  const std::string text = "name = \"" + name + "\"\ninstance = \"simplex\"\n" + rest;
  return parse_claim(text, name + ".toml", full_vocabulary(), all_signatures());
}

/// Wrong: the edges of an equilateral triangle are longer than its circumradius, those of a flat one are not.
inline Claim wrong_claim() {
  return claim_about_simplices("wrong",
                               "[[show]]\nname = \"radius\"\nclaim = \"circumradius(s) <= longest_edge(s)\"\n");
}

/// Right, with a twin, a parameter and a hypothesis that is needed.
inline Claim right_claim() {
  return claim_about_simplices("right",
                               "forall = { eta = \"(0, 1]\" }\n"
                               "given = [{ name = \"small\", claim = \"k <= 2\" }]\n"
                               "[[show]]\nname = \"radius\"\n"
                               "claim = \"eta*circumradius(s) <= longest_edge(s)/(2*thickness(s)) and k <= 2\"\n"
                               "twin = \"eta*circumradius(s) <= longest_edge(s)/4\"\n");
}

/// `right_claim` with one thing changed on which attacks depend, each time another: seven claims.
inline std::vector<Claim> changes_of_right_claim() {
  std::vector<Claim> result;
  const auto add = [&result](auto change) { change(result.emplace_back(right_claim())); };
  add([](Claim& changed) { changed.name += "r"; });
  add([](Claim& changed) { changed.instance += "s"; });
  add([](Claim& changed) { changed.parameters.at("eta").upper = Rational(2); });
  add([](Claim& changed) { changed.parameters.at("eta").has_lower = true; });
  add([](Claim& changed) { changed.hypotheses.clear(); });
  add([](Claim& changed) { changed.hypotheses[0].text += " "; });
  add([](Claim& changed) { changed.conclusions[0].text += " "; });
  return result;
}

inline ObjectPointer triangle(const Rational& x, const Rational& y) {
  return std::make_shared<SimplexObject>(SimplexObject::Points{{0, 0}, {1, 0}, {x, y}});
}

/// The triangle (0, 0), (1, 0), (x, y).
inline Bindings triangle_bindings(const Rational& x, const Rational& y) {
  return {{"s", triangle(x, y)}, {"k", 2L}, {"m", 2L}};
}

}  // namespace delcert::test
