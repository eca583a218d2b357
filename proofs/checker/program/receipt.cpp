#include "proofs/checker/program/receipt.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/certificate/printable.hpp"

namespace delcert::checker {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view beginning = R"({"format":"delcert-receipt",)";
constexpr int receipt_version = 1;
constexpr std::uint64_t most_shares = 1'000'000;
constexpr std::int64_t largest_count = std::int64_t{1} << 42;  // so that all that are added up have 63 bits

[[noreturn]] void malformed(const std::string& what) { throw Malformed("merge.receipt", what); }

Json as_json(const Range& range) {
  Json counts = Json::object();
  for (const auto& [name, number] : range.counts) counts[name] = number;
  return {{"rules", range.rules}, {"of", range.size}, {"begin", range.begin}, {"end", range.end}, {"counts", counts}};
}
Range range_of(const Json& json) {
  Range range{json.at("rules"), json.at("of"), json.at("begin"), json.at("end"), {}};
  for (const auto& [name, number] : json.at("counts").items()) range.counts.emplace_back(name, number);
  return range;
}

Json as_json(const LevelResult& level) {
  Json findings = Json::array(), ranges = Json::array();
  for (const Finding& finding : level.findings) findings.push_back({{"rule", finding.rule}, {"what", finding.what}});
  for (const Range& range : level.ranges) ranges.push_back(as_json(range));
  return {{"level", level.level},     {"status", level.status},
          {"summary", level.summary}, {"findings", findings},
          {"ranges", ranges},         {"done", level.done},
          {"left", level.left},       {"microseconds", static_cast<std::int64_t>(std::llround(1e6 * level.seconds))}};
}
Json as_json(const Outcome::Chunk& chunk) {
  return {{"root", chunk.root},
          {"labels", {chunk.first_label, chunk.end_label}},
          {"simplices", {chunk.first_simplex, chunk.end_simplex}},
          {"trees", chunk.trees},
          {"joins", chunk.joins}};
}
Outcome::Chunk chunk_of(const Json& json) {
  return {json.at("root"),
          json.at("labels").at(0),
          json.at("labels").at(1),
          json.at("simplices").at(0),
          json.at("simplices").at(1),
          json.at("trees"),
          json.at("joins").get<std::vector<std::array<std::uint64_t, 3>>>()};
}

LevelResult level_of(const Json& json) {
  LevelResult level;
  level.level = json.at("level");
  level.status = json.at("status");
  level.summary = json.at("summary");
  for (const Json& finding : json.at("findings")) level.findings.push_back({finding.at("rule"), finding.at("what")});
  for (const Json& range : json.at("ranges")) level.ranges.push_back(range_of(range));
  level.done = json.at("done").get<std::vector<std::string>>();
  level.left = json.at("left").get<std::vector<std::string>>();
  level.seconds = 1e-6 * json.at("microseconds").get<double>();
  return level;
}

Json as_json(const Identity& identity) {
  return {{"family", identity.family},
          {"dimension", identity.dimension},
          {"size", identity.size},
          {"orientability", identity.orientability},
          {"first_homology", identity.first_homology},
          {"homology_of", identity.homology_of},
          {"name_as_stated", identity.name},
          {"manifold_sha256", identity.manifold_digest},
          {"file_sha256", identity.file_digest}};
}
Identity identity_of(const Json& json) {
  return {json.at("family"),         json.at("dimension"),       json.at("size"),
          json.at("orientability"),  json.at("first_homology"),  json.at("homology_of"),
          json.at("name_as_stated"), json.at("manifold_sha256"), json.at("file_sha256")};
}

Receipt read(const Json& json) {
  Receipt receipt;
  receipt.checker = json.at("checker");
  Outcome& outcome = receipt.outcome;
  outcome.share = {json.at("part").at("number"), json.at("part").at("of")};
  if (json.contains("chunk")) outcome.chunk = chunk_of(json.at("chunk"));
  const Json& certificate = json.at("certificate");
  outcome.content = certificate.at("sha256");
  outcome.points = certificate.at("points");
  outcome.simplices = certificate.at("simplices");
  outcome.euler_characteristic = certificate.at("euler_characteristic");
  outcome.status = json.at("status");
  outcome.identity = identity_of(json.at("manifold"));
  for (const Json& level : json.at("levels")) outcome.levels.push_back(level_of(level));
  outcome.unchecked = json.at("unchecked").get<std::vector<std::string>>();
  const Json& made = json.at("decisions");
  outcome.decisions = {made.at("intervals"), made.at("rationals"), made.at("balls")};
  return receipt;
}

/// What is printed moves no cursor, numbers are integers, and nothing is nested deeply.
bool is_plain(int depth, Json::parse_event_t, const Json& parsed) {
  constexpr int deepest = 8;
  if (depth > deepest) malformed("is nested too deeply");
  if (parsed.is_number_float()) malformed("a number is no integer");
  if (parsed.is_string() && printable(parsed.get_ref<const std::string&>()) != parsed.get_ref<const std::string&>())
    malformed("a text has characters that cannot be printed");
  return true;
}

std::uint64_t facets_of(const Outcome& outcome) {
  return outcome.simplices * static_cast<std::uint64_t>(outcome.identity->dimension + 1) / 2;
}

/// Whether the range is that of the part: of a chunk its labels, its simplices or as many facets as it has.
bool is_of_part(const Range& range, const Outcome& outcome) {
  const std::pair here(range.begin, range.end);
  if (!outcome.chunk) return here == range_of(outcome.share, range.size);
  const Outcome::Chunk& chunk = *outcome.chunk;
  return (range.size == outcome.points && here == std::pair(chunk.first_label, chunk.end_label)) ||
         (range.size == outcome.simplices && here == std::pair(chunk.first_simplex, chunk.end_simplex)) ||
         (range.size == facets_of(outcome) && range.begin == 0 && range.end <= range.size) ||
         (range.size == 1 && here == range_of(outcome.share, range.size));
}

void require_sense(const Outcome::Chunk& chunk, const Outcome& outcome) {
  const bool fits = chunk.root.size() == 64 && chunk.first_label < chunk.end_label &&
                    chunk.end_label <= outcome.points && chunk.first_simplex <= chunk.end_simplex &&
                    chunk.end_simplex <= outcome.simplices && chunk.trees >= 1 &&
                    chunk.trees <= chunk.end_label - chunk.first_label;
  if (!fits) malformed("there is no such chunk");
  for (const auto& [tree, before, there] : chunk.joins) {
    if (tree >= chunk.trees || before + 1 >= outcome.share.number || there >= outcome.points)
      malformed("there is no such tree");
  }
}

/// What no part of a check says of itself.
void require_sense(const Outcome& outcome) {
  const Share& share = outcome.share;
  if (share.number < 1 || share.number > share.of || share.of > most_shares) malformed("there is no such part");
  if (outcome.chunk) require_sense(*outcome.chunk, outcome);
  int worst = 0;
  for (const LevelResult& level : outcome.levels) {
    if (level.status < 0 || level.status > 2 || (level.status == 1) != !level.findings.empty())
      malformed("the status of level " + level.level + " is not that of what was found");
    if (level.status != 0 && worst != 1) worst = level.status;
    if (!(share.number == 1 ? level.left : level.done).empty())
      malformed("level " + level.level + ": the first part, and only the first, does what is not divided");
    for (const Range& range : level.ranges) {
      if (!is_of_part(range, outcome))
        malformed("level " + level.level + ": the range of " + range.rules + " is not that of the part");
      for (const auto& [name, number] : range.counts) {
        if (number < -largest_count || number > largest_count) malformed("the count of " + name + " is too large");
      }
    }
  }
  if (outcome.status != worst || (worst == 0 && (outcome.levels.empty() || !outcome.unchecked.empty())))
    malformed("the status is not that of its levels");
}

}  // namespace

bool looks_like_receipt(std::string_view bytes) { return bytes.starts_with(beginning); }

std::string receipt_text(const Receipt& receipt) {
  const Outcome& outcome = receipt.outcome;
  Json levels = Json::array();
  for (const LevelResult& level : outcome.levels) levels.push_back(as_json(level));
  Json object = {{"format", "delcert-receipt"},
                 {"version", receipt_version},
                 {"checker", receipt.checker},
                 {"part", {{"number", outcome.share.number}, {"of", outcome.share.of}}}};
  if (outcome.chunk) object["chunk"] = as_json(*outcome.chunk);
  object["certificate"] = {{"sha256", outcome.content},
                           {"points", outcome.points},
                           {"simplices", outcome.simplices},
                           {"euler_characteristic", outcome.euler_characteristic}};
  object["status"] = outcome.status;
  object["manifold"] = as_json(*outcome.identity);
  object["levels"] = levels;
  object["unchecked"] = outcome.unchecked;
  object["decisions"] = {{"intervals", outcome.decisions.filtered},
                         {"rationals", outcome.decisions.exact},
                         {"balls", outcome.decisions.enclosed}};
  std::string text = object.dump(-1, ' ', true, Json::error_handler_t::replace);
  text.pop_back();
  return text + R"(,"sha256":")" + sha256(text) + "\"}\n";
}

Receipt receipt_of(std::string_view bytes) {
  const std::size_t seal = bytes.rfind(R"(,"sha256":")");
  if (!looks_like_receipt(bytes) || seal == std::string_view::npos) malformed("is no receipt, or is cut short");
  const std::string content(bytes.substr(0, seal));
  if (bytes.substr(seal) != R"(,"sha256":")" + sha256(content) + "\"}\n")
    malformed("the SHA-256 of the content is not the one it is sealed with");
  Receipt receipt;
  try {
    receipt = read(Json::parse(content + "}", is_plain));
  } catch (const Json::exception& reason) {
    malformed(reason.what());
  }
  // So no key is missing, repeated, unknown or elsewhere, and no number is rounded or out of range.
  if (receipt_text(receipt) != bytes)
    malformed("is not written as receipts of version " + std::to_string(receipt_version));
  require_sense(receipt.outcome);
  return receipt;
}

}  // namespace delcert::checker
