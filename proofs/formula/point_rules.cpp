#include "proofs/formula/point_rules.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "kernel/number/fraction_text.hpp"

namespace delcert {

namespace {

std::optional<int> count_from(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  int result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return result;
}

class RulesReader {
 public:
  RulesReader(const TomlFormulaReader& reader, const toml::table& table) : reader_(reader), table_(table) {}

  PointRules read() const {
    reader_.refuse_unknown(table_, {"number", "dimension", "box", "constraints", "least_acceptance"});
    PointRules rules;
    rules.number = counts("number", most_points);
    rules.dimension = counts("dimension", most_dimensions);
    read_box(rules);
    rules.least_acceptance = least_acceptance();
    return rules;
  }

 private:
  /// 3 or "3 .. 5".
  CountRange counts(const std::string& key, int most) const {
    const toml::node& node = reader_.required(table_, key);
    std::optional<int> first;
    std::optional<int> last;
    if (const auto whole = node.value_exact<std::int64_t>()) {
      if (*whole >= 0 && *whole <= most) first = last = static_cast<int>(*whole);
    } else if (const auto text = node.value_exact<std::string>()) {
      const std::size_t dots = text->find("..");
      first = count_from(std::string_view(*text).substr(0, dots));
      last = dots == std::string::npos ? first : count_from(std::string_view(*text).substr(dots + 2));
    }
    if (!first || !last || *first < 1 || *last < *first || *last > most) {
      reader_.fail(node.source(), "the key " + key + " expects an integer from 1 to " + std::to_string(most) +
                                      ", or a range of them such as \"2 .. 3\"");
    }
    return {*first, *last};
  }

  ParameterRange interval(const toml::node& node) const {
    ParameterRange result = reader_.in_string(node, "an interval expects a string such as \"[0, 1]\"",
                                              [](const std::string& text) { return parse_range(text); });
    if (!result.lower || !result.upper) reader_.fail(node.source(), "a box is bounded: points are drawn from it");
    return result;
  }

  void read_box(PointRules& rules) const {
    const toml::node& node = reader_.required(table_, "box");
    const toml::array* sides = node.as_array();
    if (sides == nullptr) {
      rules.box = {interval(node)};
      return;
    }
    for (const toml::node& side : *sides) rules.box.push_back(interval(side));
    const auto count = static_cast<int>(rules.box.size());
    if (rules.dimension.least != rules.dimension.most || count != rules.dimension.least) {
      reader_.fail(node.source(), "a box of " + std::to_string(count) + (count == 1 ? " side" : " sides") +
                                      " is for dimension " + std::to_string(count) +
                                      "; one interval in quotes is for every coordinate in any dimension");
    }
  }

  Rational least_acceptance() const {
    const toml::node* node = table_.get("least_acceptance");
    if (node == nullptr) return Rational(1) / Rational(20);
    const ParameterRange result =
        reader_.in_string(*node, "least_acceptance expects a string such as \"1/20\"", [](const std::string& text) {
          try {
            return parse_range("[" + text + ", " + text + "]");
          } catch (const FormulaError& error) {
            throw FormulaError(error.offset() == 0 ? 0 : error.offset() - 1, error.what());
          }
        });
    if (!result.lower || *result.lower < Rational(0) || Rational(1) < *result.lower) {
      reader_.fail(node->source(), "least_acceptance is a share, from 0 to 1");
    }
    return *result.lower;
  }

  const TomlFormulaReader& reader_;
  const toml::table& table_;
};

std::string side_end_text(const std::optional<Rational>& end) {
  const Rational& value = end.value();
  return value < Rational(0) ? "-(" + fraction_text(-value) + ")" : fraction_text(value);
}

std::string side_formula(const ParameterRange& side, const std::string& coordinate) {
  return side_end_text(side.lower) + (side.has_lower ? " <= " : " < ") + coordinate +
         (side.has_upper ? " <= " : " < ") + side_end_text(side.upper);
}

std::string count_text(const CountRange& range) {
  return "\"" + std::to_string(range.least) + " .. " + std::to_string(range.most) + "\"";
}

std::string interval_text(const ParameterRange& side) {
  return std::string("\"") + (side.has_lower ? "[" : "(") + fraction_text(side.lower.value()) + ", " +
         fraction_text(side.upper.value()) + (side.has_upper ? "]" : ")") + "\"";
}

}  // namespace

PointRules read_point_rules(const TomlFormulaReader& reader, const toml::node& node) {
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    reader.fail(node.source(),
                "the key points expects a table such as { number = 3, dimension = 2, box = \"[0, 1]\" }");
  }
  return RulesReader(reader, *table).read();
}

std::vector<std::string> box_formulas(const PointRules& rules) {
  if (rules.box.size() == 1) {
    return {"forall p_i in vertices(p), p_j in 0 .. m - 1: " +
            side_formula(rules.box[0], "coordinate(vertex(p, p_i), p_j)")};
  }
  std::vector<std::string> result;
  for (std::size_t axis = 0; axis < rules.box.size(); ++axis) {
    result.push_back("forall p_i in vertices(p): " +
                     side_formula(rules.box[axis], "coordinate(vertex(p, p_i), " + std::to_string(axis) + ")"));
  }
  return result;
}

std::string point_rules_text(const PointRules& rules) {
  std::string result = "number = " + count_text(rules.number) + "\ndimension = " + count_text(rules.dimension) + "\n";
  result += "box = ";
  if (rules.box.size() == 1) {
    result += interval_text(rules.box[0]);
  } else {
    std::string sides;
    for (const ParameterRange& side : rules.box) sides += (sides.empty() ? "" : ", ") + interval_text(side);
    result += "[" + sides + "]";
  }
  result += "\nleast_acceptance = \"" + fraction_text(rules.least_acceptance) + "\"\nconstraints = [";
  for (std::size_t at = 0; at < rules.constraints.size(); ++at) {
    result += (at == 0 ? "" : ", ") + nlohmann::json(rules.constraints[at]).dump();
  }
  return result + "]\n";
}

}  // namespace delcert
