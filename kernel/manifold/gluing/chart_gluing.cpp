#include "kernel/manifold/gluing/chart_gluing.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/map_piece.hpp"
#include "kernel/formula/plain_formula.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

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
      const std::vector<MapPiece> map = pieces(given_.map, from_.variables, "map");
      const std::vector<MapPiece> inverse = pieces(given_.inverse, to_.variables, "inverse");
      require_identity(map, inverse, "inverse of map", from_.variables);
      require_identity(inverse, map, "map of inverse", to_.variables);
      const std::vector<Polynomial> where = conditions();
      ChartGluing::Transition there{given_.from, given_.to, what_, {}};
      for (const MapPiece& piece : map)
        there.pieces.emplace_back(piece.map, to_.domain, where, nonzero(piece.map, inverse),
                                  formulas(piece, given_.map, from_.variables), piece.nonnegative);
      ChartGluing::Transition back{given_.to, given_.from, "the inverse of " + what_, {}};
      for (const MapPiece& piece : inverse) {
        std::vector<Polynomial> seen;
        for (const Polynomial& condition : where) seen.push_back(sign_after(condition, piece.map));
        back.pieces.emplace_back(piece.map, from_.domain, seen, nonzero(piece.map, map),
                                 formulas(piece, given_.inverse, to_.variables), piece.nonnegative);
      }
      out.push_back(std::move(there));
      out.push_back(std::move(back));
    } catch (const std::length_error& error) {
      fail(error.what());
    } catch (const FormulaError& error) {
      fail(error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(name_ + ": " + what_ + ": " + reason); }

  [[nodiscard]] std::vector<ExpressionPointer> parsed(const std::vector<std::string>& texts,
                                                      const std::vector<std::string>& variables,
                                                      AbsoluteValues absolute_values) const {
    std::vector<ExpressionPointer> result;
    for (const std::string& text : texts) result.push_back(parse_plain_formula(text, variables, absolute_values));
    return result;
  }

  [[nodiscard]] std::vector<MapPiece> pieces(const std::vector<std::string>& texts,
                                             const std::vector<std::string>& variables, const std::string& key) const {
    const auto formulas = parsed(texts, variables, AbsoluteValues::allowed);
    auto result = pieces_of(formulas, variables, ring_);
    if (result) return *std::move(result);
    for (std::size_t at = 0; at < formulas.size(); ++at) {
      if (pieces_of({formulas[at]}, variables, ring_)) continue;
      fail(key + ", formula " + std::to_string(at + 1) +
           (has_absolute_values(*formulas[at])
                ? ": not piecewise linear, or of too many pieces"
                : ": not a rational function, or a division by 0, or too large to be written out"));
    }
    fail(key + ": not piecewise linear, or of too many pieces");
  }

  [[nodiscard]] std::vector<Polynomial> conditions() const {
    std::vector<Polynomial> result;
    for (const std::string& text : given_.where) {
      const auto f = rational_function_of(*parse_plain_formula(text, from_.variables), from_.variables, ring_);
      if (!f || !f->denominator.constant()) fail("where: not a polynomial");
      result.push_back(f->numerator);
    }
    return result;
  }

  /// The map as the file has it; if that has absolute values, the rational functions of the piece.
  [[nodiscard]] FormulaMap formulas(const MapPiece& piece, const std::vector<std::string>& given,
                                    const std::vector<std::string>& variables) const {
    const std::vector<ExpressionPointer> trees = parsed(given, variables, AbsoluteValues::allowed);
    if (std::none_of(trees.begin(), trees.end(), [](const auto& tree) { return has_absolute_values(*tree); }))
      return {variables, given};
    std::vector<std::string> texts;
    for (const RationalFunction& f : piece.map)
      texts.push_back(f.denominator.constant() ? f.numerator.text()
                                               : "(" + f.numerator.text() + ")/(" + f.denominator.text() + ")");
    return {ring_->names(), texts};
  }

  /// That second∘first is the identity.
  void require_identity(const std::vector<MapPiece>& first, const std::vector<MapPiece>& second,
                        const std::string& which, const std::vector<std::string>& variables) const {
    const auto both = composed(second, first);
    for (std::size_t axis = 0; axis < variables.size(); ++axis) {
      const bool holds = both && std::all_of(both->begin(), both->end(), [&](const MapPiece& piece) {
                           return piece.map[axis] == variable_function(ring_, axis);
                         });
      if (holds) continue;
      throw Rejection(name_ + ": " + what_ + ": atlas.inverse: the " + which + " is not the identity: coordinate " +
                      std::to_string(axis + 1) + " is not " + variables[axis]);
    }
  }

  /// Denominators of the map, and of the inverse after it.
  [[nodiscard]] static std::vector<Polynomial> nonzero(const std::vector<RationalFunction>& map,
                                                       const std::vector<MapPiece>& inverse) {
    std::vector<Polynomial> result;
    const auto add = [&](const Polynomial& p) {
      if (!p.constant() && std::find(result.begin(), result.end(), p) == result.end()) result.push_back(p);
    };
    for (const RationalFunction& f : map) add(f.denominator);
    for (const MapPiece& piece : inverse) {
      for (const RationalFunction& g : piece.map) add(composed(g.denominator, map).numerator);
    }
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
