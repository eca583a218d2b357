#include "kernel/manifold/metric_field_file.hpp"

#include <algorithm>
#include <map>

#include "kernel/formula/plain_formula.hpp"
#include "kernel/formula/toml_formula_reader.hpp"
#include "kernel/formula/trigonometric_polynomial.hpp"
#include "kernel/manifold/exact_entry.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Square = MetricFieldDescription::Square;

constexpr std::string_view family = "metric-field";
constexpr std::size_t most_waves = 64;
constexpr int greatest_frequency = 64;
constexpr std::size_t most_coordinates = 9;

class MetricFieldReader : TomlFormulaReader {
 public:
  MetricFieldReader(std::string_view text, const std::string& source)
      : TomlFormulaReader(text, source), table_(parse()) {}

  MetricFieldDescription read() const {
    refuse_unknown(table_, {"name", "family", "dimension", "constant", "waves", "variables", "embedding"});
    if (short_string(table_, "family") != family)
      fail(required(table_, "family"), "key \"family\"", "\"metric-field\"");
    MetricFieldDescription result;
    result.name = short_string(table_, "name");
    const int m = integer(table_, "dimension", 2, 3);
    result.dimension = Dimension(m);
    const auto size = static_cast<std::size_t>(m);
    if (table_.contains("embedding")) {
      for (const char* other : {"constant", "waves"}) {
        if (table_.contains(other))
          fail(required(table_, other), std::string("key \"") + other + '"',
               "nothing: the embedding says what the metric is");
      }
      induce(result, variables(size));
      return result;
    }
    if (table_.contains("variables"))
      fail(required(table_, "variables"), "key \"variables\"", "it together with an embedding");
    result.constant = matrix(required(table_, "constant"), size, "key \"constant\"");
    if (!table_.contains("waves")) return result;
    const toml::node& list = required(table_, "waves");
    const auto* waves = list.as_array();
    if (waves == nullptr || waves->size() > most_waves) fail(list, "key \"waves\"", "an array of at most 64 tables");
    for (const toml::node& entry : *waves) result.waves.push_back(wave(entry, size, result.waves.size() + 1));
    return result;
  }

 private:
  std::vector<std::string> variables(std::size_t size) const {
    const toml::node& list = required(table_, "variables");
    const auto* names = list.as_array();
    if (names == nullptr || names->size() != size)
      fail(list, "key \"variables\"", "an array of " + std::to_string(size) + " names");
    std::vector<std::string> result;
    for (const toml::node& entry : *names) {
      const auto name = entry.value_exact<std::string>();
      if (!name || !is_name_of_variable(*name) || std::find(result.begin(), result.end(), *name) != result.end())
        fail(entry, "variable " + std::to_string(result.size() + 1),
             "the name of a variable, different from the others");
      result.push_back(*name);
    }
    return result;
  }

  /// G = Σ_F ∂F·∂Fᵀ, derivatives by the variables, which are 2πx.
  void induce(MetricFieldDescription& result, const std::vector<std::string>& variables) const {
    const std::size_t m = variables.size();
    const toml::node& list = required(table_, "embedding");
    const auto* formulas = list.as_array();
    if (formulas == nullptr || formulas->size() < m || formulas->size() > most_coordinates)
      fail(list, "key \"embedding\"", "an array of " + std::to_string(m) + " to 9 formulas");
    std::vector<TrigonometricPolynomial> metric(m * m, TrigonometricPolynomial(m));
    for (const toml::node& entry : *formulas) {
      const TrigonometricPolynomial coordinate = in_string(
          entry, "key \"embedding\": expected a formula such as \"(2 + cos(v))*cos(u)\"", [&](const std::string& text) {
            return trigonometric_polynomial_of(*parse_plain_formula(text, variables), variables);
          });
      for (std::size_t row = 0; row < m; ++row) {
        for (std::size_t column = 0; column < m; ++column)
          metric[row * m + column] =
              metric[row * m + column] + coordinate.derivative(row) * coordinate.derivative(column);
      }
    }
    const Square zero(m, std::vector<Rational>(m));
    result.constant = zero;
    std::map<std::vector<int>, MetricFieldDescription::Term> waves;
    for (std::size_t at = 0; at < m * m; ++at) {
      for (const auto& [frequency, wave] : metric[at].waves()) {
        if (std::all_of(frequency.begin(), frequency.end(), [](int k) { return k == 0; })) {
          result.constant[at / m][at % m] = wave.cosine;
          continue;
        }
        auto& term = waves.try_emplace(frequency, MetricFieldDescription::Term{frequency, zero, zero}).first->second;
        term.cosine[at / m][at % m] = wave.cosine;
        term.sine[at / m][at % m] = wave.sine;
      }
    }
    for (auto& [frequency, term] : waves) {
      if (std::any_of(frequency.begin(), frequency.end(),
                      [](int k) { return k < -greatest_frequency || k > greatest_frequency; }))
        fail(list, "key \"embedding\"", "a metric with frequencies of at most 64");
      result.waves.push_back(std::move(term));
    }
    if (result.waves.size() > most_waves) fail(list, "key \"embedding\"", "a metric of at most 64 waves");
  }

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
