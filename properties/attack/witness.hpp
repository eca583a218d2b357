#pragma once

#include <string>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// A witness file: an instance on which a claim is refuted or nearly so, exactly, with what refers to it.
struct Witness {
  std::string claim;       ///< the name of the claim, or its file
  std::string conclusion;  ///< of the claim; of a twin if `twin` is not empty
  std::string twin;        ///< "" for the claim itself, else the name of the twin's conclusion or dropped hypothesis
  std::string instance_class;  ///< what the bindings are an instance of
  Bindings bindings;
  /// The claim or twin as it was then (`claim_text`, under the name of the claim); "" in a file of version 1.
  std::string text = {};
};

/// The bindings as JSON: {"name": {"number": "p/q"}, …}, kinds by the signature and "number" for parameters.
[[nodiscard]] nlohmann::ordered_json bindings_json(const Bindings& bindings, const Signature& signature);
/// And back: names of the signature of the kind that it says, all others as numbers. Throws InputError, naming the
/// name, for anything else.
[[nodiscard]] Bindings bindings_from(const nlohmann::ordered_json& json, const Vocabulary& vocabulary,
                                     const Signature& signature);

/// The text of a witness file (docs/attacks.md, "Replay it"): of version 2, with the text of the claim and its SHA-256,
/// or of version 1 if the witness has no such text.
[[nodiscard]] std::string witness_text(const Witness& witness);
/// Reads it back, and has the instance class check the instance. Throws InputError, naming `file`, for anything that is
/// not a witness, has unknown keys, or has a text of another SHA-256 than it says.
[[nodiscard]] Witness parse_witness(const std::string& text, const std::string& file);
/// The same from a file. Throws InputError also if it cannot be read or is larger than 64 MiB.
[[nodiscard]] Witness read_witness(const std::string& file);

}  // namespace delcert
