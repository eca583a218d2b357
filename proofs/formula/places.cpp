#include "proofs/formula/places.hpp"

#include <algorithm>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/substitution.hpp"

namespace delcert {

namespace {

bool is_number(const Expression& term) {
  switch (term.operation) {
    case Operation::literal:
      return true;
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::power:
      return std::all_of(term.children.begin(), term.children.end(),
                         [](const auto& child) { return is_number(*child); });
    default:
      return false;
  }
}

bool is_bare(const Expression& term) {
  return term.operation == Operation::name || (term.operation == Operation::literal && term.value == Rational(0)) ||
         (term.operation == Operation::call && term.text != "sqrt" && term.text != "min" && term.text != "max");
}

bool is_product(Operation operation) { return operation == Operation::multiply || operation == Operation::divide; }
bool is_sum(Operation operation) { return operation == Operation::add || operation == Operation::subtract; }

class PlaceFinder {
 public:
  std::vector<Place> places;

  void statement(const Expression& node, bool stronger) {
    switch (node.operation) {
      case Operation::conjunction:
      case Operation::disjunction:
        for (std::size_t at = 0; at < 2; ++at) below(at, [&] { statement(*node.children[at], stronger); });
        return;
      case Operation::implication:
      case Operation::for_all:
      case Operation::exists:
        below(1, [&] { statement(*node.children[1], stronger); });
        return;
      case Operation::less:
      case Operation::less_equal:
        comparison(node, 0);
        return;
      case Operation::greater:
      case Operation::greater_equal:
        comparison(node, 1);
        return;
      default:
        return;
    }
  }

 private:
  template <class Visit>
  void below(std::size_t child, const Visit& visit) {
    path_.push_back(child);
    visit();
    path_.pop_back();
  }

  void add(PlaceKind kind, const Expression& term, bool smaller) {
    places.push_back({kind, path_, formula_text(term), smaller});
  }

  /// `smaller_side`: the number of the side that is said to be smaller. A statement says more if its larger side is
  /// smaller.
  void comparison(const Expression& node, std::size_t smaller_side) {
    for (std::size_t at = 0; at < 2; ++at) {
      const Expression& side = *node.children[at];
      const bool is_larger = at != smaller_side;
      if (is_bare(side) && !(is_larger && is_bare(*node.children[1 - at]))) continue;
      if (side.operation == Operation::literal && side.value == Rational(0)) continue;
      below(at, [&] {
        add(PlaceKind::bound, side, is_larger);
        inside(side, is_larger, true);
      });
    }
  }

  /// What a term is made of. `is_scaled`: a number that is a factor of it need not be a place of its own.
  void inside(const Expression& term, bool smaller, bool is_scaled) {
    if (is_number(term) || is_bare(term)) return;
    if (is_sum(term.operation)) {
      summands(term, smaller);
    } else if (is_product(term.operation)) {
      factors(term, smaller, is_scaled);
    } else if (term.operation == Operation::negate) {
      below(0, [&] { inside(*term.children[0], !smaller, is_scaled); });
    } else if (term.operation == Operation::power) {
      const bool turned = term.children[1]->operation == Operation::negate;
      below(0, [&] { argument(*term.children[0], smaller != turned); });
    } else if (term.operation == Operation::call) {
      for (std::size_t at = 0; at < term.children.size(); ++at) {
        below(at, [&] { argument(*term.children[at], smaller); });
      }
    }
  }

  /// Of a power or a root: a number in it is not scaled with the whole.
  void argument(const Expression& term, bool smaller) {
    if (is_number(term)) {
      if (term.operation != Operation::literal || term.value != Rational(0)) add(PlaceKind::constant, term, smaller);
      return;
    }
    inside(term, smaller, false);
  }

  void summands(const Expression& sum, bool smaller) {
    for (std::size_t at = 0; at < 2; ++at) {
      const Expression& part = *sum.children[at];
      const bool here = smaller != (at == 1 && sum.operation == Operation::subtract);
      below(at, [&] {
        if (is_sum(part.operation)) {
          summands(part, here);
        } else {
          add(PlaceKind::summand, part, here);
          inside(part, here, true);
        }
      });
    }
  }

  void factors(const Expression& product, bool smaller, bool is_scaled) {
    for (std::size_t at = 0; at < 2; ++at) {
      const Expression& part = *product.children[at];
      const bool here = smaller != (at == 1 && product.operation == Operation::divide);
      below(at, [&] {
        if (is_number(part)) {
          if (!is_scaled) add(PlaceKind::constant, part, here);
        } else if (is_product(part.operation)) {
          factors(part, here, is_scaled);
        } else {
          add(PlaceKind::factor, part, here);
          inside(part, here, is_scaled);
        }
      });
    }
  }

  std::vector<std::size_t> path_;
};

template <class Change>
ExpressionPointer changed_at(const ExpressionPointer& node, const std::vector<std::size_t>& path, std::size_t depth,
                             const Change& change) {
  if (depth == path.size()) return change(node);
  auto result = std::make_shared<Expression>(*node);
  auto& child = result->children.at(path[depth]);
  child = changed_at(child, path, depth + 1, change);
  // 3/4 of an integer need not be an integer.
  if (result->type == types::integer && child->type == types::number) result->type = types::number;
  return result;
}

}  // namespace

const char* name_of(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::bound:
      return "bound";
    case PlaceKind::summand:
      return "summand";
    case PlaceKind::constant:
      return "constant";
    default:
      return "factor";
  }
}

std::vector<Place> places_in(const Expression& statement) {
  PlaceFinder finder;
  finder.statement(statement, true);
  return std::move(finder.places);
}

ExpressionPointer with_place_scaled(const ExpressionPointer& statement, const Place& place, const Rational& factor) {
  return changed_at(statement, place.path, 0, [&](const ExpressionPointer& term) {
    auto product = std::make_shared<Expression>();
    product->operation = Operation::multiply;
    product->type = types::number;
    product->children = {number_expression(factor), term};
    return ExpressionPointer(product);
  });
}

ExpressionPointer without_place(const ExpressionPointer& statement, const Place& place) {
  const Rational neutral(place.kind == PlaceKind::factor ? 1 : 0);
  return changed_at(statement, place.path, 0, [&](const ExpressionPointer&) { return number_expression(neutral); });
}

FocusedStatement focused(const ExpressionPointer& statement, const Place& place) {
  Place there = place;
  there.path.clear();
  // The conjunctions are left out of the path; what is above them is rebuilt around what is below.
  const auto rebuilt = [&](const auto& self, const ExpressionPointer& node, std::size_t depth) -> ExpressionPointer {
    if (depth == place.path.size() || is_comparison(node->operation)) {
      there.path.insert(there.path.end(), place.path.begin() + static_cast<std::ptrdiff_t>(depth), place.path.end());
      return node;
    }
    const std::size_t at = place.path[depth];
    if (node->operation == Operation::conjunction) return self(self, node->children[at], depth + 1);
    there.path.push_back(at);
    auto result = std::make_shared<Expression>(*node);
    result->children[at] = self(self, node->children[at], depth + 1);
    return result;
  };
  FocusedStatement result;
  result.formula = rebuilt(rebuilt, statement, 0);
  result.place = std::move(there);
  return result;
}

}  // namespace delcert
