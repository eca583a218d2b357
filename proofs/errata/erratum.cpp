#include "proofs/errata/erratum.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <tuple>

#include "proofs/errata/builtin_errata.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

constexpr std::size_t largest_errata_file = std::size_t{1} << 20U;
constexpr std::array judgements{Judgement::theorem, Judgement::constant, Judgement::word, Judgement::misprint,
                                Judgement::holds};
const std::vector<std::string> keys{"label",   "number", "lines",   "kind",   "printed",   "wrong",
                                    "witness", "mended", "defence", "effect", "decidable", "command"};

/// The ranges of "17-23, 40"; empty if that is not what it is.
std::vector<LineRange> ranges_of(std::string_view text) {
  std::vector<LineRange> ranges;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  const auto number = [&](int& value) {
    const auto [after, error] = std::from_chars(at, end, value);
    const bool read = error == std::errc{} && value > 0 && at != end && *at != '0';
    at = after;
    return read;
  };
  while (true) {
    LineRange range;
    if (!number(range.first)) return {};
    range.last = range.first;
    if (at != end && *at == '-' && (++at, !number(range.last))) return {};
    if (range.last < range.first || (!ranges.empty() && range.first <= ranges.back().last)) return {};
    ranges.push_back(range);
    if (at == end) return ranges;
    if (*at++ != ',') return {};
    if (at != end && *at == ' ') ++at;
  }
}

class ErratumReader {
 public:
  ErratumReader(const std::string& text, const std::string& file) : toml_(text, file), table_(toml_.parse()) {}

  Erratum read() const {
    toml_.refuse_unknown(table_, keys);
    Erratum result;
    result.file = toml_.file();
    result.label = string("label", true);
    result.number = string("number", true);
    result.lines = ranges_of(string("lines", true));
    if (result.lines.empty())
      toml_.fail(table_.get("lines")->source(),
                 "lines are \"17\", \"17-23\" or several of these in order, \"17-23, 40\"");
    result.judgement = judgement();
    result.printed = string("printed", true);
    result.wrong = string("wrong", true);
    result.witness = string("witness", false);
    result.mended = string("mended", false);
    result.defence = string("defence", result.judgement == Judgement::theorem);
    result.effect = string("effect", false);
    result.decidable = boolean("decidable");
    result.command = string("command", result.decidable);
    if (!result.decidable && !result.command.empty())
      toml_.fail(table_.get("command")->source(), "a command, but decidable is false");
    if (result.decidable && result.judgement == Judgement::holds)
      toml_.fail(table_.get("decidable")->source(),
                 "what a computation decides is a claim or a step, not \"read: holds\"");
    return result;
  }

 private:
  std::string string(const std::string& key, bool required) const { return toml_.string(table_, key, required); }

  bool boolean(const std::string& key) const {
    const toml::node& node = toml_.required(table_, key);
    const auto value = node.value_exact<bool>();
    if (!value) toml_.fail(node.source(), "the key " + key + " expects true or false");
    return *value;
  }

  Judgement judgement() const {
    const std::string text = string("kind", true);
    for (const Judgement each : judgements)
      if (text == name_of(each)) return each;
    std::string known;
    for (const Judgement each : judgements)
      known += (known.empty() ? "\"" : ", \"") + std::string(name_of(each)) + "\"";
    toml_.fail(table_.get("kind")->source(), "a kind is one of " + known + ", not \"" + shortened(text) + "\"");
  }

  TomlReader toml_;
  toml::table table_;
};

}  // namespace

Erratum parse_erratum(const std::string& text, const std::string& file) { return ErratumReader(text, file).read(); }

Erratum read_erratum(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read");
  std::string text;
  for (char c = 0; text.size() <= largest_errata_file && stream.get(c);) text += c;
  if (stream.bad()) throw InputError(file + ": cannot be read");
  if (text.size() > largest_errata_file) throw InputError(file + ": larger than 1 MiB");
  return parse_erratum(text, file);
}

const std::vector<Erratum>& builtin_errata_list() {
  static const std::vector<Erratum> list = [] {
    std::vector<Erratum> errata;
    for (const BuiltinErratum& each : builtin_errata())
      errata.push_back(parse_erratum(each.text, "proofs/errata/" + each.name + ".toml"));
    sort_by_line(errata);
    return errata;
  }();
  return list;
}

void sort_by_line(std::vector<Erratum>& errata) {
  std::sort(errata.begin(), errata.end(), [](const Erratum& a, const Erratum& b) {
    return std::tie(a.lines.front().first, a.lines.front().last, a.file) <
           std::tie(b.lines.front().first, b.lines.front().last, b.file);
  });
}

std::string_view name_of(Judgement judgement) {
  switch (judgement) {
    case Judgement::theorem:
      return "changes a theorem";
    case Judgement::constant:
      return "changes a constant";
    case Judgement::word:
      return "needs a word";
    case Judgement::misprint:
      return "misprint";
    default:
      return "read: holds";
  }
}

}  // namespace delcert
