#include "apps/witness_item.hpp"

#include "apps/interruption.hpp"
#include "apps/witness_file.hpp"
#include "proofs/certificate/file_text.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/witness_points.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

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
  switch (witness_file(path)) {
    case WitnessFile::witness:
      return {read_witness(path)};
    case WitnessFile::attack:
      return refutations_in(path);
    case WitnessFile::other:
      break;
  }
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
  for (const DrawnSet& set : drawn_sets(witness))
    item.data["sets"].push_back({{"name", set.name},
                                 {"kind", set.is_simplex           ? "simplex"
                                          : set.points.size() == 1 ? "point"
                                                                   : "points"},
                                 {"points", set.points}});
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

std::vector<PageItem> witness_items(const std::string& path, const ShownFile& file) {
  const InterruptionDeadline deadline;
  std::vector<PageItem> items;
  for (const Witness& witness : witnesses_in(path)) {
    try {
      items.push_back(witness_item(witness, replayed(witness), file));
    } catch (const InputError& error) {
      throw InputError(path + ": " + error.what());
    }
  }
  return items;
}

}  // namespace delcert
