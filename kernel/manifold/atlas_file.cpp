#include "kernel/manifold/atlas_file.hpp"

#include <algorithm>

#include "kernel/formula/plain_formula.hpp"
#include "kernel/formula/toml_formula_reader.hpp"
#include "kernel/manifold/exact_entry.hpp"
#include "kernel/topology/abelian_group.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_charts = 64;
constexpr std::size_t most_transitions = 512;
constexpr std::size_t most_conditions = 16;
constexpr std::size_t longest_formula = 4096;

class AtlasReader : TomlFormulaReader {
 public:
  AtlasReader(std::string_view text, const std::string& source) : TomlFormulaReader(text, source), table_(parse()) {}

  FormulaAtlasDescription read() const {
    refuse_unknown(table_, {"name", "family", "dimension", "homology", "charts", "transitions"});
    if (short_string(table_, "family") != "atlas")
      fail(required(table_, "family"), key_in_words("family"), "\"atlas\"");
    FormulaAtlasDescription result;
    result.name = short_string(table_, "name");
    result.dimension = Dimension(integer(table_, "dimension", 2, 3));
    const auto m = static_cast<std::size_t>(result.dimension.value);
    for_each_table("charts", most_charts, "chart", [&](const toml::table& table, const std::string& what) {
      result.charts.push_back(chart(table, m, what, result));
    });
    for_each_table("transitions", most_transitions, "transition",
                   [&](const toml::table& table, const std::string& what) {
                     result.transitions.push_back(transition(table, what, result));
                   });
    if (table_.contains("homology")) {
      for (const toml::node& entry :
           array_of(required(table_, "homology"), key_in_words("homology"), m + 1, m + 1, "groups, from degree 0 on")) {
        const auto* group = entry.as_string();
        if (group == nullptr || !is_group_text(group->get()))
          fail(entry, "homology, degree " + std::to_string(result.homology.size()),
               R"(a group such as "Z^2 + Z/3", "(Z/2)^2" or "0")");
        result.homology.push_back(group->get());
      }
    }
    return result;
  }

 private:
  template <class Each>
  void for_each_table(std::string_view key, std::size_t most, const std::string& name, const Each& each) const {
    std::size_t number = 0;
    for (const toml::node& entry : array_of(required(table_, key), key_in_words(key), 1, most,
                                            "tables, each under [[" + std::string(key) + "]]")) {
      const std::string what = name + " " + std::to_string(++number);
      const auto* table = entry.as_table();
      if (table == nullptr) fail(entry, what, "a table");
      each(*table, what);
    }
  }

  const toml::array& array_of(const toml::node& node, const std::string& what, std::size_t least, std::size_t most,
                              const std::string& of) const {
    const auto* result = node.as_array();
    if (result == nullptr || result->size() < least || result->size() > most)
      fail(node, what,
           "an array of " + (least == most ? "" : std::to_string(least) + " to ") + std::to_string(most) + " " + of);
    return *result;
  }

  FormulaAtlasDescription::Chart chart(const toml::table& table, std::size_t m, const std::string& what,
                                       const FormulaAtlasDescription& atlas) const {
    refuse_unknown(table, {"name", "variables", "domain", "core"});
    FormulaAtlasDescription::Chart result;
    result.name = short_string(table, "name");
    for (const auto& other : atlas.charts) {
      if (other.name == result.name) fail(required(table, "name"), what, "another name: this one is taken");
    }
    for (const toml::node& entry :
         array_of(required(table, "variables"), what + ", variables", m, m, "names, one for each dimension")) {
      const auto* name = entry.as_string();
      if (name == nullptr || !is_name_of_variable(name->get()))
        fail(entry, what + ", variables",
             "a name: at most 16 small letters, digits and _, a letter first, and no name of a function");
      if (std::find(result.variables.begin(), result.variables.end(), name->get()) != result.variables.end())
        fail(entry, what + ", variables", "another name: this one is taken");
      result.variables.push_back(name->get());
    }
    result.domain = sides(required(table, "domain"), what + ", domain", result.variables);
    if (!table.contains("core")) {
      // Each side shorter by an eighth.
      for (const auto& [from, to] : result.domain) {
        const Rational margin = (to - from) / Rational(16);
        result.core.push_back({from + margin, to - margin});
      }
      return result;
    }
    const toml::node& core = required(table, "core");
    result.core = sides(core, what + ", core", result.variables);
    for (std::size_t axis = 0; axis < m; ++axis) {
      if (result.core[axis][0] <= result.domain[axis][0] || result.core[axis][1] >= result.domain[axis][1])
        fail(core, what + ", core, " + result.variables[axis], "a side strictly inside that of the domain");
    }
    return result;
  }

  Sides sides(const toml::node& node, const std::string& name, const std::vector<std::string>& variables) const {
    Sides result;
    for (const toml::node& entry :
         array_of(node, name, variables.size(), variables.size(), "pairs of numbers, one for each variable")) {
      result.push_back(exact_interval(*this, entry, name + ", " + variables[result.size()]));
    }
    return result;
  }

  std::size_t place_of_chart(const toml::table& table, std::string_view key, const std::string& what,
                             const FormulaAtlasDescription& atlas) const {
    const std::string name = short_string(table, key);
    for (std::size_t at = 0; at < atlas.charts.size(); ++at) {
      if (atlas.charts[at].name == name) return at;
    }
    fail(required(table, key), what + ", " + std::string(key), "the name of a chart");
  }

  FormulaAtlasDescription::Transition transition(const toml::table& table, const std::string& what,
                                                 const FormulaAtlasDescription& atlas) const {
    refuse_unknown(table, {"from", "to", "map", "inverse", "where"});
    FormulaAtlasDescription::Transition result;
    result.from = place_of_chart(table, "from", what, atlas);
    result.to = place_of_chart(table, "to", what, atlas);
    if (result.from == result.to)
      fail(required(table, "to"), what + ", to", "another chart: no two points of one chart are the same");
    const auto& from = atlas.charts[result.from].variables;
    result.map = formulas(required(table, "map"), what + ", map", from.size(), from.size(), from, true);
    result.inverse = formulas(required(table, "inverse"), what + ", inverse", from.size(), from.size(),
                              atlas.charts[result.to].variables, true);
    if (table.contains("where"))
      result.where = formulas(required(table, "where"), what + ", where", 1, most_conditions, from, false);
    return result;
  }

  std::vector<std::string> formulas(const toml::node& node, const std::string& what, std::size_t least,
                                    std::size_t most, const std::vector<std::string>& variables, bool may_fold) const {
    std::vector<std::string> result;
    for (const toml::node& entry : array_of(node, what, least, most, "formulas")) {
      const auto* text = entry.as_string();
      if (text == nullptr || text->get().size() > longest_formula)
        fail(entry, what + ", formula " + std::to_string(result.size() + 1), "a string of at most 4096 bytes");
      result.push_back(in_string(entry, "a formula", [&](const std::string& formula) {
        if (may_fold) {
          const ExpressionPointer tree = parse_plain_formula(formula, variables, AbsoluteValues::allowed);
          if (has_absolute_values(*tree)) return canonical_text(*tree);
        }
        return FormulaMap(variables, {formula}).canonical_texts()[0];
      }));
    }
    return result;
  }

  toml::table table_;
};

}  // namespace

FormulaAtlasDescription parse_atlas(std::string_view text, const std::string& source) {
  return AtlasReader(text, source).read();
}

}  // namespace delcert
