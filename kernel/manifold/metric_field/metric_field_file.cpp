#include "kernel/manifold/metric_field/metric_field_file.hpp"

// As in kernel/manifold/manifold_file.cpp: toml++ 3.3.0 asserts what a file can break.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

using Keys = std::vector<std::string_view>;
using Square = MetricFieldDescription::Square;

constexpr std::string_view family = "metric-field";
constexpr std::size_t most_waves = 64;
constexpr int greatest_frequency = 64;

class MetricFieldReader {
 public:
  MetricFieldReader(const toml::table& table, const std::string& source) : table_(table), source_(source) {}

  MetricFieldDescription read() const {
    allow(table_, {"name", "family", "dimension", "constant", "waves"});
    if (text("family") != family) fail(node(table_, "family"), "key \"family\"", "\"metric-field\"");
    MetricFieldDescription result;
    result.name = text("name");
    const int m = integer(node(table_, "dimension"), "key \"dimension\"", 2, 3);
    result.dimension = Dimension(m);
    const auto size = static_cast<std::size_t>(m);
    result.constant = matrix(node(table_, "constant"), size, "key \"constant\"");
    if (!table_.contains("waves")) return result;
    const toml::node& list = node(table_, "waves");
    const auto* waves = list.as_array();
    if (waves == nullptr || waves->size() > most_waves) fail(list, "key \"waves\"", "an array of at most 64 tables");
    for (const toml::node& entry : *waves) result.waves.push_back(wave(entry, size, result.waves.size() + 1));
    return result;
  }

 private:
  MetricFieldDescription::Term wave(const toml::node& entry, std::size_t size, std::size_t number) const {
    const std::string what = "wave " + std::to_string(number);
    const auto* table = entry.as_table();
    if (table == nullptr) fail(entry, what, "a table {frequency = …, cosine = …, sine = …}");
    allow(*table, {"frequency", "cosine", "sine"});
    MetricFieldDescription::Term result;
    const toml::node& frequency = node(*table, "frequency");
    const auto* entries = frequency.as_array();
    if (entries == nullptr || entries->size() != size)
      fail(frequency, what + ", frequency", "an array of " + std::to_string(size) + " integers");
    for (const toml::node& k : *entries)
      result.frequency.push_back(integer(k, what + ", frequency", -greatest_frequency, greatest_frequency));
    if (std::all_of(result.frequency.begin(), result.frequency.end(), [](int k) { return k == 0; }))
      fail(frequency, what + ", frequency", "one that is not 0: that term is \"constant\"");
    const bool has_cosine = table->contains("cosine");
    const bool has_sine = table->contains("sine");
    if (!has_cosine && !has_sine) fail(entry, what, "a matrix \"cosine\" or \"sine\"");
    const Square zero(size, std::vector<Rational>(size));
    result.cosine = has_cosine ? matrix(node(*table, "cosine"), size, what + ", cosine") : zero;
    result.sine = has_sine ? matrix(node(*table, "sine"), size, what + ", sine") : zero;
    return result;
  }

  /// Symmetric.
  Square matrix(const toml::node& node, std::size_t size, const std::string& what) const {
    const std::string order = std::to_string(size);
    const auto* rows = node.as_array();
    if (rows == nullptr || rows->size() != size) fail(node, what, "an array of " + order + " rows");
    Square result(size);
    for (std::size_t row = 0; row < size; ++row) {
      const auto* entries = (*rows)[row].as_array();
      const std::string name = what + ", row " + std::to_string(row + 1);
      if (entries == nullptr || entries->size() != size) fail((*rows)[row], name, "an array of " + order + " numbers");
      for (std::size_t column = 0; column < size; ++column) {
        result[row].push_back(number((*entries)[column], name + ", entry " + std::to_string(column + 1)));
        if (column < row && result[row][column] != result[column][row])
          fail((*entries)[column], name + ", entry " + std::to_string(column + 1),
               exact_text(result[column][row]) + ": the matrix is symmetric");
      }
    }
    return result;
  }

  Rational number(const toml::node& node, const std::string& what) const {
    if (const auto* integer = node.as_integer()) return Rational(integer->get());
    const auto* string = node.as_string();
    if (string == nullptr) fail(node, what, "an exact number: an integer, or a string such as \"3/4\" or \"0x3p-2\"");
    try {
      return parse_exact(string->get());
    } catch (const InputError& error) {
      throw InputError(position(node.source()) + what + ": " + error.what());
    }
  }

  int integer(const toml::node& node, const std::string& what, int least, int greatest) const {
    const auto* value = node.as_integer();
    if (value == nullptr || value->get() < least || value->get() > greatest)
      fail(node, what, "an integer from " + std::to_string(least) + " to " + std::to_string(greatest));
    return static_cast<int>(value->get());
  }

  std::string text(std::string_view key) const {
    const toml::node& node = this->node(table_, key);
    const auto* value = node.as_string();
    if (value == nullptr || value->get().empty() || value->get().size() > 64)
      fail(node, "key \"" + std::string(key) + "\"", "a string of 1 to 64 bytes");
    return value->get();
  }

  const toml::node& node(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) throw InputError(source_ + ": key \"" + std::string(key) + "\" is missing");
    return *node;
  }

  void allow(const toml::table& table, const Keys& keys) const {
    for (const auto& [key, value] : table) {
      if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
      std::string known;
      for (const std::string_view name : keys) known += (known.empty() ? "" : ", ") + std::string(name);
      throw InputError(position(key.source()) + "unknown key \"" + std::string(key.str()) + "\", expected: " + known);
    }
  }

  std::string position(const toml::source_region& where) const {
    return source_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) + ": ";
  }
  [[noreturn]] void fail(const toml::node& node, const std::string& what, const std::string& expected) const {
    std::string found = "a value of another type";
    if (const auto* integer = node.as_integer()) found = std::to_string(integer->get());
    if (const auto* string = node.as_string()) found = "\"" + string->get().substr(0, 80) + "\"";
    if (const auto* array = node.as_array()) found = "an array of length " + std::to_string(array->size());
    if (node.is_floating_point()) found = "a floating-point number, which would be rounded before it is read";
    throw InputError(position(node.source()) + what + ": found " + found + ", expected " + expected);
  }

  const toml::table& table_;
  const std::string& source_;
};

}  // namespace

MetricFieldDescription parse_metric_field(std::string_view text, const std::string& source) {
  try {
    const toml::table table = toml::parse(text, source);
    return MetricFieldReader(table, source).read();
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    throw InputError(source + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) +
                     ": not TOML: " + std::string(error.description()));
  }
}

std::optional<MetricFieldDescription> metric_field_if_one(const std::string& name_or_path) {
  for (const BuiltinManifold& builtin : builtin_metric_fields()) {
    if (builtin.name == name_or_path) return parse_metric_field(builtin.text, builtin.name);
  }
  try {
    const toml::table table = toml::parse_file(name_or_path);
    if (table["family"].value<std::string_view>() != family) return std::nullopt;
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
  std::ifstream stream(name_or_path, std::ios::binary);
  return parse_metric_field(std::string(std::istreambuf_iterator<char>(stream), {}), name_or_path);
}

}  // namespace delcert
