#include "kernel/manifold/gluing/chart_gluing.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/plain_formula.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Functions = std::vector<RationalFunction>;

class TransitionReader {
 public:
  TransitionReader(const FormulaAtlasDescription& description, std::size_t number, RingPointer ring)
      : name_(description.name),
        given_(description.transitions[number]),
        from_(description.charts[given_.from]),
        to_(description.charts[given_.to]),
        ring_(std::move(ring)),
        what_("transition " + std::to_string(number + 1) + ", from " + from_.name + " to " + to_.name) {}

  void read_into(std::vector<ChartGluing::Transition>& out) const {
    try {
      const Functions map = functions(given_.map, from_.variables, "map");
      const Functions inverse = functions(given_.inverse, to_.variables, "inverse");
      require_identity(map, inverse, "inverse of map", from_.variables);
      require_identity(inverse, map, "map of inverse", to_.variables);
      std::vector<Polynomial> where;
      std::vector<Polynomial> seen_from_there;
      for (const RationalFunction& condition : functions(given_.where, from_.variables, "where")) {
        if (!condition.denominator.constant()) fail("where: not a polynomial");
        where.push_back(condition.numerator);
        const RationalFunction there = composed(condition.numerator, inverse);
        seen_from_there.push_back(there.denominator.constant() ? there.numerator : there.numerator * there.denominator);
      }
      out.push_back({given_.from, given_.to, what_,
                     CellMap(map, to_.domain, where, nonzero(map, inverse), FormulaMap(from_.variables, given_.map)),
                     FormulaMap(from_.variables, given_.map)});
      out.push_back({given_.to, given_.from, "the inverse of " + what_,
                     CellMap(inverse, from_.domain, seen_from_there, nonzero(inverse, map),
                             FormulaMap(to_.variables, given_.inverse)),
                     FormulaMap(to_.variables, given_.inverse)});
    } catch (const std::length_error& error) {
      fail(error.what());
    } catch (const FormulaError& error) {
      fail(error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(name_ + ": " + what_ + ": " + reason); }

  [[nodiscard]] Functions functions(const std::vector<std::string>& texts, const std::vector<std::string>& variables,
                                    const std::string& key) const {
    Functions result;
    for (const std::string& text : texts) {
      const auto f = rational_function_of(*parse_plain_formula(text, variables), variables, ring_);
      if (!f)
        fail(key + ", formula " + std::to_string(result.size() + 1) +
             ": not a rational function, or a division by 0, or too large to be written out");
      result.push_back(*f);
    }
    return result;
  }

  /// That second∘first is the identity.
  void require_identity(const Functions& first, const Functions& second, const std::string& which,
                        const std::vector<std::string>& variables) const {
    for (std::size_t axis = 0; axis < first.size(); ++axis) {
      const auto found = composed(second[axis], first);
      if (found && *found == variable_function(ring_, axis)) continue;
      throw Rejection(name_ + ": " + what_ + ": atlas.inverse: the " + which + " is not the identity: coordinate " +
                      std::to_string(axis + 1) + " is not " + variables[axis]);
    }
  }

  /// Denominators of the map, and of the inverse after it.
  [[nodiscard]] static std::vector<Polynomial> nonzero(const Functions& map, const Functions& inverse) {
    std::vector<Polynomial> result;
    const auto add = [&](const Polynomial& p) {
      if (!p.constant() && std::find(result.begin(), result.end(), p) == result.end()) result.push_back(p);
    };
    for (const RationalFunction& f : map) add(f.denominator);
    for (const RationalFunction& g : inverse) add(composed(g.denominator, map).numerator);
    return result;
  }

  const std::string& name_;
  const FormulaAtlasDescription::Transition& given_;
  const FormulaAtlasDescription::Chart& from_;
  const FormulaAtlasDescription::Chart& to_;
  RingPointer ring_;
  std::string what_;
};

}  // namespace

ChartGluing::ChartGluing(FormulaAtlasDescription description)
    : description_(std::move(description)), ring_(CellMap::ring(dimension())) {
  for (std::size_t number = 0; number < description_.transitions.size(); ++number)
    TransitionReader(description_, number, ring_).read_into(transitions_);
}

}  // namespace delcert
