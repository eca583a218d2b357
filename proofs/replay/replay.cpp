#include "proofs/replay/replay.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "proofs/replay/digest.hpp"
#include "proofs/replay/enclosure.hpp"
#include "proofs/replay/polynomial.hpp"
#include "proofs/replay/squares.hpp"

namespace delcert::replay {

namespace {

using Json = nlohmann::json;
using Box = std::vector<Side>;

std::optional<Number> read_end(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Number::read(json.get<std::string>());
}

/// The integers of a range, whose ends belong to it.
void round_inwards(Side& side) {
  const auto whole = [](const Number& x, bool up) {
    Number result;
    if (up) {
      fmpz_cdiv_q(fmpq_numref(result.raw()), fmpq_numref(x.raw()), fmpq_denref(x.raw()));
    } else {
      fmpz_fdiv_q(fmpq_numref(result.raw()), fmpq_numref(x.raw()), fmpq_denref(x.raw()));
    }
    return result;
  };
  if (side.lower) {
    Number first = whole(*side.lower, true);
    if (side.lower_open && first == *side.lower) first = first + Number(1);
    side.lower = first;
    side.lower_open = false;
  }
  if (side.upper) {
    Number last = whole(*side.upper, false);
    if (side.upper_open && last == *side.upper) last = last - Number(1);
    side.upper = last;
    side.upper_open = false;
  }
}

class GoalReplay {
 public:
  GoalReplay(const Json& json, const NodePointer& statement, const std::vector<std::string>& names, const Box& ranges)
      : json_(json), statement_(statement), names_(names), ranges_(ranges), variables_(names) {}

  std::size_t run() {
    if (json_.at("statement").get<std::string>() != text_of(*statement_)) throw Rejected("another statement");
    for (const Json& name : json_.at("squared")) {
      ranges_[variables_.index(name.get<std::string>())].is_squared = true;
    }
    precision_ = json_.at("precision").get<long>();
    if (precision_ < 2 || precision_ > 4096) throw Rejected("a precision that is not from 2 to 4096");
    make_boxes();
    for (const Json& factor : json_.at("factors")) {
      factors_.push_back(Polynomial::read(factor.get<std::string>(), variables_));
      if (factors_.back().constant()) throw Rejected("a factor that is a constant");
    }
    comparisons_ = comparisons_of(*statement_);
    const Json& atoms = json_.at("atoms");
    if (atoms.size() != comparisons_.size()) throw Rejected("as many comparisons as the statement has not");
    for (std::size_t i = 0; i < atoms.size(); ++i) read_comparison(*comparisons_[i], atoms[i]);
    if (json_.contains("squares")) {
      require_proved_by_squares(json_.at("squares"),
                                {*statement_, comparisons_, products_, factors_, ranges_, boxes_, variables_});
      return 1;
    }
    const Json& trees = json_.at("trees");
    if (trees.size() != boxes_.size()) throw Rejected("as many trees as the ranges have parts not");
    for (std::size_t i = 0; i < boxes_.size(); ++i) walk(trees[i], boxes_[i]);
    return leaves_;
  }

 private:
  /// The whole real line is cut at 0.
  void make_boxes() {
    boxes_ = {Box{}};
    for (const Side& range : ranges_) {
      std::vector<Side> parts{range};
      if (!range.lower && !range.upper) {
        parts.push_back(range);
        parts[0].upper = Number(0);
        parts[0].upper_open = false;
        parts[1].lower = Number(0);
        parts[1].lower_open = false;
      }
      std::vector<Box> longer;
      for (const Box& box : boxes_) {
        for (const Side& part : parts) {
          longer.push_back(box);
          longer.back().push_back(part);
        }
      }
      boxes_ = std::move(longer);
    }
    for (const Box& box : boxes_) {
      for (const Side& side : box) (void)variable_side(side);
    }
  }

  void read_comparison(const Node& comparison, const Json& json) {
    const std::string by = json.at("by").get<std::string>();
    products_.emplace_back();
    if (by == "enclosure") return;
    if (by != "polynomial") throw Malformed("a comparison by " + by);
    Product product;
    product.constant = Number::read(json.at("constant").get<std::string>());
    Polynomial numerator(variables_, product.constant);
    Polynomial denominator(variables_, Number(1));
    for (const Json& power : json.at("powers")) {
      const auto factor = power.at(0).get<std::size_t>();
      const long exponent = power.at(1).get<long>();
      Polynomial& side = exponent > 0 ? numerator : denominator;
      side = side * factors_.at(factor).power(static_cast<unsigned long>(std::abs(exponent)));
      product.powers.emplace_back(factor, exponent);
    }
    for (const Json& divisor : json.at("divisors")) product.divisors.push_back(divisor.get<std::size_t>());
    FractionReader reader(variables_, boxes_);
    const Fraction left = reader.read(*comparison.parts[0]);
    const Fraction right = reader.read(*comparison.parts[1]);
    const Polynomial difference = left.numerator * right.denominator - right.numerator * left.denominator;
    if (!(difference * denominator == numerator * left.denominator * right.denominator)) {
      throw Rejected("a product that is not the difference of " + text_of(comparison));
    }
    // Everything that has been divided by is made of the divisors; so are the denominators.
    for (const Polynomial& divisor : reader.divisors) require_made_of(divisor, product.divisors);
    require_made_of(denominator, product.divisors);
    products_.back() = std::move(product);
  }

  void require_made_of(Polynomial p, const std::vector<std::size_t>& divisors) const {
    for (const std::size_t divisor : divisors) {
      while (const auto quotient = p.divided_by(factors_.at(divisor))) p = *quotient;
    }
    const auto rest = p.constant();
    if (!rest || rest->sign() == 0) throw Rejected("a divisor that is not listed");
  }

  void walk(const Json& tree, const Box& box) {
    if (tree.is_string()) {
      ++leaves_;
      const std::string kind = tree.get<std::string>();
      if (kind != "leaf" && kind != "exact") throw Malformed("a leaf that is " + kind);
      if (kind == "exact" && !std::all_of(box.begin(), box.end(), [](const Side& side) { return side.is_point(); })) {
        throw Rejected("an exact leaf that is no point");
      }
      require_proved(box);
      return;
    }
    if (!tree.is_array() || tree.size() != 5) throw Malformed("a tree that is neither a leaf nor cut in two");
    const std::size_t at = variables_.index(tree[0].get<std::string>());
    const Number last = Number::read(tree[1].get<std::string>());
    const Number next = Number::read(tree[2].get<std::string>());
    const Side& side = box.at(at);
    const bool gap_is_empty = side.is_integer ? last.is_integer() && next == last + Number(1) : last == next;
    if (!gap_is_empty)
      throw Rejected("a cut that leaves out " + names_[at] + " between " + last.text() + " and " + next.text());
    const bool is_inside = (!side.lower || *side.lower <= last) && (!side.upper || next <= *side.upper);
    if (!is_inside) throw Rejected("a cut outside of the box");
    Box lower = box;
    lower[at].upper = last;
    lower[at].upper_open = false;
    Box upper = box;
    upper[at].lower = next;
    upper[at].lower_open = false;
    walk(tree[3], lower);
    walk(tree[4], upper);
  }

  static std::string text_of_box(const Box& box, const std::vector<std::string>& names) {
    std::string result;
    for (std::size_t i = 0; i < box.size(); ++i) {
      result += (i == 0 ? "" : ", ") + names[i] + " from " + (box[i].lower ? box[i].lower->text() : "-infinity") +
                " to " + (box[i].upper ? box[i].upper->text() : "infinity");
    }
    return result;
  }

  void require_proved(const Box& box) {
    std::vector<Side> sides;
    for (const Side& side : box) sides.push_back(variable_side(side));
    std::vector<std::optional<Sign>> signs(factors_.size());
    const auto sign_of_factor = [&](std::size_t factor) {
      auto& known = signs.at(factor);
      if (!known) known = factors_.at(factor).sign_on(sides);
      return *known;
    };
    Encloser encloser(names_, box, precision_);
    std::vector<int> truths;
    for (std::size_t i = 0; i < comparisons_.size(); ++i) {
      const Node& comparison = *comparisons_[i];
      if (products_[i]) {
        const Sign sign = sign_of(*products_[i], sign_of_factor);
        truths.push_back(sign ? truth(comparison.head, *sign) : 0);
      } else if (comparison.head == "=" && text_of(*comparison.parts[0]) == text_of(*comparison.parts[1])) {
        truths.push_back(encloser.has_value(comparison.parts[0]) ? 1 : 0);
      } else {
        const auto sign = encloser.sign_of_difference(comparison.parts[0], comparison.parts[1]);
        truths.push_back(sign ? truth(comparison.head, *sign) : 0);
      }
    }
    if (truth_of(*statement_, truths) != 1) throw Rejected("a leaf that is not proved: " + text_of_box(box, names_));
  }

  const Json& json_;
  NodePointer statement_;
  const std::vector<std::string>& names_;
  Box ranges_;
  Variables variables_;
  slong precision_ = 0;
  std::vector<Box> boxes_;
  std::vector<Polynomial> factors_;
  std::vector<const Node*> comparisons_;
  std::vector<std::optional<Product>> products_;
  std::size_t leaves_ = 0;
};

/// An exponent is made of integers, and its double is an integer: then a power is what the real one is.
void require_exponents(const Node& term, const std::vector<std::string>& names, const Box& ranges) {
  for (const NodePointer& part : term.parts) require_exponents(*part, names, ranges);
  if (term.head != "^") return;
  const Variables variables(names);
  const std::vector<Box> boxes{ranges};
  FractionReader reader(variables, boxes);
  const Fraction exponent = reader.read(*term.parts[1]);
  const auto denominator = exponent.denominator.constant();
  if (!denominator) throw Rejected("an exponent that is no polynomial");
  // With integer arguments a polynomial whose coefficients are halves has values that are halves.
  const Fraction doubled{exponent.numerator * Polynomial(variables, Number(2) / *denominator),
                         Polynomial(variables, Number(1))};
  if (!doubled.numerator.has_integer_coefficients()) throw Rejected("an exponent that need not be half an integer");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!ranges[i].is_integer && doubled.numerator.depends_on(i))
      throw Rejected("an exponent that is not made of integers");
  }
}

StatedRange range_of(const Json& parameter) {
  StatedRange range;
  range.is_integer = parameter.at("integer").get<bool>();
  range.lower = read_end(parameter.at("lower"));
  range.upper = read_end(parameter.at("upper"));
  range.has_lower = parameter.at("has_lower").get<bool>();
  range.has_upper = parameter.at("has_upper").get<bool>();
  return range;
}

void require_stated_ranges(const Json& step, const StatedStep& stated) {
  std::set<std::string> seen;
  for (const Json& parameter : step.at("parameters")) {
    const std::string name = parameter.at("name").get<std::string>();
    const auto found = stated.parameters.find(name);
    if (found == stated.parameters.end() || !seen.insert(name).second) {
      throw Rejected("rule ranges: a parameter " + name + " that is not stated");
    }
    const StatedRange range = range_of(parameter);
    if (!(range == found->second)) {
      throw Rejected("rule ranges: " + name + " in " + text_of(range) + ", stated is " + text_of(found->second));
    }
  }
  if (seen.size() != stated.parameters.size()) throw Rejected("rule ranges: a parameter that is stated is missing");
}

void require_stated_hypotheses(const Json& step, const StatedStep& stated) {
  const Json& hypotheses = step.at("hypotheses");
  if (hypotheses.size() != stated.hypotheses.size()) {
    throw Rejected("rule hypotheses: " + std::to_string(hypotheses.size()) + ", stated are " +
                   std::to_string(stated.hypotheses.size()));
  }
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const std::string logged = text_of(*read_statement(hypotheses[i].get<std::string>()));
    if (logged != stated.hypotheses[i]) {
      throw Rejected("rule hypotheses: " + logged + ", stated is " + stated.hypotheses[i]);
    }
  }
}

/// A log proves what its steps say; that this is what the file says is another question.
void require_stated(const Json& step, const std::string& name, const StatedClaim& claim) {
  if (step.at("claim").get<std::string>() != name) throw Rejected("rule claim: the log is one of " + name);
  const auto found = claim.steps.find(step.at("step").get<std::string>());
  if (found == claim.steps.end()) throw Rejected("rule step: " + claim.source + " has none of this name");
  const StatedStep& stated = found->second;
  try {
    require_stated_ranges(step, stated);
    require_stated_hypotheses(step, stated);
    const std::string logged = text_of(*read_statement(step.at("statement").get<std::string>()));
    if (logged != stated.statement) throw Rejected("rule statement: " + logged + ", stated is " + stated.statement);
  } catch (const Rejected& rejected) {
    throw Rejected(std::string(rejected.what()) + " (" + claim.source + ":" + std::to_string(stated.line) + ")");
  }
}

Totals replay_step(const Json& step) {
  std::vector<std::string> names;
  Box ranges;
  for (const Json& parameter : step.at("parameters")) {
    names.push_back(parameter.at("name").get<std::string>());
    Side side;
    side.is_integer = parameter.at("integer").get<bool>();
    side.lower = read_end(parameter.at("lower"));
    side.upper = read_end(parameter.at("upper"));
    side.lower_open = !side.lower || !parameter.at("has_lower").get<bool>();
    side.upper_open = !side.upper || !parameter.at("has_upper").get<bool>();
    if (side.is_integer) round_inwards(side);
    if (side.lower && side.upper && *side.upper < *side.lower) throw Rejected("an empty range");
    ranges.push_back(std::move(side));
  }
  std::vector<NodePointer> hypotheses;
  for (const Json& hypothesis : step.at("hypotheses"))
    hypotheses.push_back(read_statement(hypothesis.get<std::string>()));
  const NodePointer claim = read_statement(step.at("statement").get<std::string>());
  for (const NodePointer& hypothesis : hypotheses) require_exponents(*hypothesis, names, ranges);
  require_exponents(*claim, names, ranges);
  const auto goals = goals_of(hypotheses, claim);
  const Json& logged = step.at("goals");
  if (logged.size() != goals.size()) throw Rejected("as many goals as the statement has not");
  Totals totals;
  totals.steps = 1;
  totals.goals = goals.size();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    try {
      totals.leaves += GoalReplay(logged[i], goals[i], names, ranges).run();
    } catch (const Rejected& rejected) {
      throw Rejected("goal " + std::to_string(i + 1) + ": " + rejected.what());
    }
  }
  return totals;
}

/// The first line: which claim, and its text.
Totals read_head(const Json& head) {
  if (head.at("format") != "delcert-proof-log" || head.at("version") != 2) throw Malformed("no log of version 2");
  Totals totals;
  totals.claim = head.at("claim").get<std::string>();
  totals.file = head.at("file").get<std::string>();
  const auto text = head.at("text").get<std::string>();
  StatedClaims carried;
  add_claim(carried, text, "the text in the log");
  const auto found = carried.find(totals.claim);
  if (found == carried.end()) throw Rejected("rule claim: the text in the log is not that of " + totals.claim);
  totals.stated = found->second;
  totals.by_its_own_text = true;
  const auto sum = head.at("sha256").get<std::string>();
  if (sum != totals.stated.sha256)
    throw Rejected("rule hash: the text in the log has SHA-256 " + totals.stated.sha256 + ", the log says " + sum);
  return totals;
}

/// Without claims nothing is said of where the statements come from.
Totals replay_log(std::istream& log, const StatedClaims* claims, UnknownClaim unknown) {
  std::string line;
  std::size_t number = 1;
  try {
    if (!std::getline(log, line)) throw Malformed("an empty file");
    Totals totals = read_head(Json::parse(line));
    const std::string carried = totals.stated.sha256;
    if (claims != nullptr) {
      const auto known = claims->find(totals.claim);
      if (known != claims->end()) {
        totals.stated = known->second;
        totals.by_its_own_text = false;
      } else if (unknown == UnknownClaim::rejected) {
        throw Rejected("rule claim: no claim " + totals.claim + " is known; --claims names its file");
      }
    }
    while (std::getline(log, line)) {
      ++number;
      const Json step = Json::parse(line);
      const std::string name = step.at("claim").get<std::string>() + " / " + step.at("step").get<std::string>();
      try {
        if (claims != nullptr) require_stated(step, totals.claim, totals.stated);
        const Totals one = replay_step(step);
        totals.steps += one.steps;
        totals.goals += one.goals;
        totals.leaves += one.leaves;
        totals.proved.insert(step.at("step").get<std::string>());
      } catch (const Rejected& rejected) {
        throw Rejected(name + ": " + rejected.what());
      } catch (const Malformed& malformed) {
        throw Malformed(name + ": " + malformed.what());
      }
    }
    number = 1;
    if (totals.stated.sha256 != carried) {
      throw Rejected("rule text: " + totals.stated.source + " has changed since the log was written: its SHA-256 is " +
                     totals.stated.sha256 + ", that of the text in the log " + carried);
    }
    return totals;
  } catch (const Json::exception& error) {
    throw Malformed("line " + std::to_string(number) + ": " + error.what());
  } catch (const Malformed& malformed) {
    throw Malformed("line " + std::to_string(number) + ": " + malformed.what());
  } catch (const Rejected& rejected) {
    throw Rejected(rejected.what(), number);
  } catch (const std::out_of_range&) {
    throw Rejected("a number of what is not there", number);
  }
}

}  // namespace

Totals replay(std::istream& log, const StatedClaims& claims, UnknownClaim unknown) {
  return replay_log(log, &claims, unknown);
}

Totals replay_as_logged(std::istream& log) { return replay_log(log, nullptr, UnknownClaim::by_the_log); }

}  // namespace delcert::replay
