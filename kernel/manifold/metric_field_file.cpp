#include "kernel/manifold/metric_field_file.hpp"

#include <algorithm>

#include "kernel/manifold/exact_entry.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

using Square = MetricFieldDescription::Square;

constexpr std::string_view family = "metric-field";
constexpr std::size_t most_waves = 64;
constexpr int greatest_frequency = 64;

class MetricFieldReader : TomlReader {
 public:
  MetricFieldReader(std::string_view text, const std::string& source) : TomlReader(text, source), table_(parse()) {}

  MetricFieldDescription read() const {
    refuse_unknown(table_, {"name", "family", "dimension", "constant", "waves"});
    if (short_string(table_, "family") != family)
      fail(required(table_, "family"), "key \"family\"", "\"metric-field\"");
    MetricFieldDescription result;
    result.name = short_string(table_, "name");
    const int m = integer(table_, "dimension", 2, 3);
    result.dimension = Dimension(m);
    const auto size = static_cast<std::size_t>(m);
    result.constant = matrix(required(table_, "constant"), size, "key \"constant\"");
    if (!table_.contains("waves")) return result;
    const toml::node& list = required(table_, "waves");
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
    refuse_unknown(*table, {"frequency", "cosine", "sine"});
    MetricFieldDescription::Term result;
    const toml::node& frequency = required(*table, "frequency");
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
    result.cosine = has_cosine ? matrix(required(*table, "cosine"), size, what + ", cosine") : zero;
    result.sine = has_sine ? matrix(required(*table, "sine"), size, what + ", sine") : zero;
    return result;
  }

  /// Symmetric.
  Square matrix(const toml::node& node, std::size_t size, const std::string& what) const {
    Square result(size);
    for_each_entry(node, size, what,
                   [&](std::size_t row, std::size_t column, const toml::node& entry, const std::string& name) {
                     result[row].push_back(exact_number(*this, entry, name));
                     if (column < row && result[row][column] != result[column][row])
                       fail(entry, name, exact_text(result[column][row]) + ": the matrix is symmetric");
                   });
    return result;
  }

  toml::table table_;
};

}  // namespace

MetricFieldDescription parse_metric_field(std::string_view text, const std::string& source) {
  return MetricFieldReader(text, source).read();
}

}  // namespace delcert
