#include "apps/witness_item.hpp"

#include <fstream>

#include "proofs/certificate/file_text.hpp"
#include "properties/attack/attack_report.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Whether the first key of the file is this one.
bool begins_with(const std::string& path, const std::string& key) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(64, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  std::erase_if(start, [](char letter) { return std::string_view(" \t\r\n").find(letter) != std::string_view::npos; });
  return start.starts_with("{\"" + key + "\"");
}

std::vector<Witness> refutations_in(const std::string& path) {
  std::vector<Witness> result;
  try {
    const auto json = nlohmann::ordered_json::parse(read_text(path));
    for (const auto& one : json.at("refutations")) result.push_back(parse_witness(one.at("witness").dump(), path));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path + ": " + error.what());
  }
  if (result.empty()) throw InputError(path + ": an attack that refuted nothing; there is no witness to show");
  return result;
}

}  // namespace

std::vector<Witness> witnesses_in(const std::string& path) {
  if (begins_with(path, "delcert_witness")) return {read_witness(path)};
  if (begins_with(path, "seed")) return refutations_in(path);
  return {};
}

PageItem witness_item(const Witness& witness, const Replay& replay, const ShownFile& file) {
  const Signature& signature = instance_class(witness.instance_class).signature();
  PageItem item;
  item.data = {{"kind", "witness"},           {"file", file.name},
               {"file_sha256", file.sha256},  {"claim", witness.claim},
               {"title", replay.claim.title}, {"conclusion", witness.conclusion},
               {"twin", witness.twin},        {"instance", witness.instance_class}};
  item.data["bindings"] = bindings_json(witness.bindings, signature);
  item.data["replay"] = {{"hypotheses", name_of(replay.hypotheses)}};
  if (replay.conclusion) {
    item.data["replay"]["text"] = replay.conclusion->text;
    item.data["replay"]["verdict"] = name_of(replay.conclusion->verdict);
    item.data["replay"]["ratio"] = ratio_text(replay.conclusion->ratio);
  } else {
    item.data["replay"]["verdict"] = is_refuted(replay.hypotheses) ? "void" : "undecided";
  }
  return item;
}

}  // namespace delcert
