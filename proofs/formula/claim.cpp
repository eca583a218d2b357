#include "proofs/formula/claim.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>

#include "kernel/error.hpp"
#include "proofs/formula/formula_error.hpp"
#include "proofs/formula/token.hpp"
#include "proofs/formula/toml_position.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 20U;
constexpr std::size_t most_parts = 1000;
constexpr const char* wrong_name =
    "a name is made of at most 80 small letters, digits, '-', '.' and '_', and begins with a letter or a digit";

bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
  };
  const auto is_sign = [](char c) { return c == '-' || c == '.' || c == '_'; };
  return !text.empty() && text.size() <= 80 && !is_sign(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

class Reader {
 public:
  Reader(const std::string& text, std::string file, const Vocabulary& vocabulary, const Signatures& signatures)
      : text_(text), file_(std::move(file)), vocabulary_(vocabulary), signatures_(signatures) {}

  Claim read() {
    const toml::table table = parse();
    refuse_unknown(table, {"name", "title", "source", "status", "instance", "note", "forall", "given", "show"});
    Claim claim;
    claim.file = file_;
    claim.name = string(table, "name", true);
    if (!is_name(claim.name)) {
      fail(table.get("name")->source(), wrong_name);
    }
    claim.title = string(table, "title", false);
    claim.source = string(table, "source", false);
    claim.note = string(table, "note", false);
    claim.status = status(table);
    claim.instance = string(table, "instance", true);
    const auto found = signatures_.find(claim.instance);
    if (found == signatures_.end()) {
      std::vector<std::string> known;
      for (const auto& [name, signature] : signatures_) known.push_back(name);
      fail(table.get("instance")->source(),
           "no instance class is called " + shortened(claim.instance) + suggestion(claim.instance, known));
    }
    signature_ = found->second;
    read_parameters(table, claim);
    read_hypotheses(table, claim);
    read_conclusions(table, claim);
    return claim;
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& message) const {
    throw InputError(file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
  }
  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    fail(where.begin.line, where.begin.column, message);
  }

  static std::string one_line(std::string_view text) {
    std::string result(text);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return result;
  }

  toml::table parse() const {
    try {
      return toml::parse(text_);
    } catch (const toml::parse_error& error) {
      fail(error.source(), one_line(error.description()));
    }
  }

  void refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table) {
      const std::string word(key.str());
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        fail(key.source(), "unknown key " + shortened(word) + suggestion(word, known));
      }
    }
  }

  std::string string(const toml::table& table, const std::string& key, bool required) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      if (required) fail(table.source(), "the key " + key + " is missing");
      return "";
    }
    const auto value = node->value_exact<std::string>();
    if (!value) fail(node->source(), "the key " + key + " wants a string");
    if (required && value->empty()) fail(node->source(), "the key " + key + " wants a string that is not empty");
    return *value;
  }

  ClaimStatus status(const toml::table& table) const {
    const toml::node* node = table.get("status");
    if (node == nullptr) return ClaimStatus::user;
    const std::string text = string(table, "status", true);
    for (const ClaimStatus candidate : {ClaimStatus::paper, ClaimStatus::mended, ClaimStatus::user}) {
      if (text != name_of(candidate)) continue;
      if (candidate != ClaimStatus::user && !table.contains("source")) {
        fail(node->source(), "a claim of the paper says where it stands there: the key source is missing");
      }
      return candidate;
    }
    fail(node->source(), "a status is \"paper\", \"mended\" or \"user\", not \"" + shortened(text) + "\"");
  }

  void read_parameters(const toml::table& table, Claim& claim) {
    const toml::node* node = table.get("forall");
    if (node == nullptr) return;
    if (!node->is_table()) fail(node->source(), "the key forall wants a table such as { eta = \"(0, 1]\" }");
    for (const auto& [key, value] : *node->as_table()) {
      const std::string name(key.str());
      if (!is_name_of_formula(name) || vocabulary_.function(name) != nullptr ||
          vocabulary_.definition(name) != nullptr) {
        fail(key.source(), shortened(name) + " is no name for a parameter: letters, digits and '_', and no function");
      }
      if (signature_.contains(name)) fail(key.source(), "the class " + claim.instance + " binds " + name + " already");
      const auto text = value.value_exact<std::string>();
      if (!text) fail(value.source(), "a parameter wants a string such as \"(0, 1]\"");
      try {
        claim.parameters[name] = parse_range(*text);
      } catch (const FormulaError& error) {
        fail_in(value, error);
      }
    }
    for (const auto& [name, range] : claim.parameters) signature_[name] = types::number;
  }

  Statement statement(const toml::node& node, const std::string& name) const {
    const auto text = node.value_exact<std::string>();
    if (!text) fail(node.source(), "a formula wants a string");
    try {
      return {name, *text, type_checked(parse_formula(*text), vocabulary_, signature_, types::truth)};
    } catch (const FormulaError& error) {
      fail_in(node, error);
    }
  }

  const toml::array* list(const toml::table& table, const std::string& key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return nullptr;
    if (!node->is_array()) fail(node->source(), "the key " + key + " wants a list");
    if (node->as_array()->size() > most_parts) fail(node->source(), "more than 1000 parts of the key " + key);
    return node->as_array();
  }

  void require_new(const toml::node& part, const std::vector<std::string>& taken, const std::string& name) const {
    if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
      fail(part.source(), "two parts of the claim are called " + name);
    }
  }

  std::string part_name(const toml::table& part, const std::vector<std::string>& taken, const std::string& kind) const {
    std::string name = string(part, "name", false);
    if (name.empty()) name = kind + "-" + std::to_string(taken.size() + 1);
    if (!is_name(name)) {
      fail(part.get("name")->source(), wrong_name);
    }
    require_new(part, taken, name);
    return name;
  }

  void read_hypotheses(const toml::table& table, Claim& claim) const {
    const toml::array* given = list(table, "given");
    if (given == nullptr) return;
    std::vector<std::string> taken;
    for (const toml::node& node : *given) {
      Hypothesis hypothesis;
      if (const toml::table* part = node.as_table()) {
        refuse_unknown(*part, {"name", "claim", "no_twin"});
        const std::string name = part_name(*part, taken, "hypothesis");
        static_cast<Statement&>(hypothesis) = statement(required(*part, "claim"), name);
        hypothesis.no_twin = reason(*part);
      } else {
        static_cast<Statement&>(hypothesis) = statement(node, "hypothesis-" + std::to_string(taken.size() + 1));
        require_new(node, taken, hypothesis.name);
      }
      taken.push_back(hypothesis.name);
      claim.hypotheses.push_back(std::move(hypothesis));
    }
  }

  void read_conclusions(const toml::table& table, Claim& claim) const {
    const toml::array* show = list(table, "show");
    if (show == nullptr || show->empty()) fail(table.source(), "a claim shows something: [[show]] is missing");
    std::vector<std::string> taken;
    for (const toml::node& node : *show) {
      const toml::table* part = node.as_table();
      if (part == nullptr) fail(node.source(), "the key show wants tables, [[show]]");
      refuse_unknown(*part, {"name", "claim", "twin", "no_twin"});
      const std::string name = part_name(*part, taken, "conclusion");
      Conclusion conclusion;
      static_cast<Statement&>(conclusion) = statement(required(*part, "claim"), name);
      if (const toml::node* twin = part->get("twin")) conclusion.twin = statement(*twin, name + "-twin");
      conclusion.no_twin = reason(*part);
      if (conclusion.twin && !conclusion.no_twin.empty()) {
        fail(part->get("no_twin")->source(), "a conclusion has a twin or a reason why not, not both");
      }
      taken.push_back(name);
      claim.conclusions.push_back(std::move(conclusion));
    }
  }

  /// Why there is no twin; empty if the key is missing.
  std::string reason(const toml::table& part) const {
    return part.contains("no_twin") ? string(part, "no_twin", true) : "";
  }

  const toml::node& required(const toml::table& table, const std::string& key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) fail(table.source(), "the key " + key + " is missing");
    return *node;
  }

  /// The place in the file of what is wrong in a formula.
  [[noreturn]] void fail_in(const toml::node& node, const FormulaError& error) const {
    const auto& begin = node.source().begin;
    const TextPosition where = position_in_toml_string(text_, {begin.line, begin.column}, error.offset());
    fail(where.line, where.column, error.what());
  }

  const std::string& text_;
  std::string file_;
  const Vocabulary& vocabulary_;
  const Signatures& signatures_;
  Signature signature_;
};

}  // namespace

Claim parse_claim(const std::string& text, const std::string& file, const Vocabulary& vocabulary,
                  const Signatures& signatures) {
  return Reader(text, file, vocabulary, signatures).read();
}

Claim read_claim(const std::string& file, const Vocabulary& vocabulary, const Signatures& signatures) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read");
  std::string text;
  for (char c = 0; text.size() <= largest_file && stream.get(c);) text += c;
  if (stream.bad()) throw InputError(file + ": cannot be read");
  if (text.size() > largest_file) throw InputError(file + ": larger than 1 MiB");
  return parse_claim(text, file, vocabulary, signatures);
}

std::string_view name_of(ClaimStatus status) {
  switch (status) {
    case ClaimStatus::paper:
      return "paper";
    case ClaimStatus::mended:
      return "mended";
    default:
      return "user";
  }
}

}  // namespace delcert
