#include "proofs/formula/abbreviation_reader.hpp"

#include <algorithm>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

struct Abbreviation {
  const toml::node* node;
  std::string name;
  std::vector<std::string> needs;
};

class AbbreviationReader {
 public:
  AbbreviationReader(const FormulaReader& reader, const AbbreviationRules& rules) : reader_(reader), rules_(rules) {}

  std::vector<Statement> read(const toml::node& node) {
    if (const toml::table* all = node.as_table()) {
      for (const auto& [key, value] : *all) add(key.source(), std::string(key.str()), value);
    } else if (const toml::array* all_in_order = node.as_array()) {
      for (const toml::node& part : *all_in_order) add_entry(part);
    } else {
      reader_.fail(node.source(), "the key let expects a table such as { ratio = \"1/(1 + xi)\" }");
    }
    std::vector<Statement> result;
    while (!waiting_.empty()) result.push_back(take_next());
    return result;
  }

 private:
  void add_entry(const toml::node& part) {
    const toml::table* entry = part.as_table();
    if (entry == nullptr) reader_.fail(part.source(), "an abbreviation expects a table { name = …, is = … }");
    reader_.refuse_unknown(*entry, {"name", "is"});
    const std::string name = reader_.string(*entry, "name", true);
    add(entry->get("name")->source(), name, reader_.required(*entry, "is"));
  }

  void add(const toml::source_region& where, const std::string& name, const toml::node& node) {
    rules_.require_free(where, name);
    if (is_waiting(name)) reader_.fail(where, name + " is already something else");
    waiting_.push_back({&node, name, reader_.in_string(node, "a formula expects a string", [](const std::string& text) {
                          return free_names(*parse_formula(text));
                        })});
  }

  [[nodiscard]] bool is_waiting(const std::string& name) const {
    return std::any_of(waiting_.begin(), waiting_.end(), [&](const Abbreviation& one) { return one.name == name; });
  }

  Statement take_next() {
    auto next = std::find_if(waiting_.begin(), waiting_.end(), [&](const Abbreviation& one) {
      return std::none_of(one.needs.begin(), one.needs.end(),
                          [&](const std::string& need) { return is_waiting(need); });
    });
    if (next == waiting_.end()) reader_.fail(waiting_[0].node->source(), waiting_[0].name + " is made of itself");
    Statement term = rules_.term(*next->node, next->name);
    rules_.announce(term);
    waiting_.erase(next);
    return term;
  }

  const FormulaReader& reader_;
  const AbbreviationRules& rules_;
  std::vector<Abbreviation> waiting_;
};

}  // namespace

std::vector<Statement> read_abbreviations(const FormulaReader& reader, const toml::table& table,
                                          const AbbreviationRules& rules) {
  const toml::node* node = table.get("let");
  return node == nullptr ? std::vector<Statement>() : AbbreviationReader(reader, rules).read(*node);
}

}  // namespace delcert
