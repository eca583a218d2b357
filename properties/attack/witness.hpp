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
};

/// The bindings as JSON: {"name": {"number": "p/q"}, …}, kinds by the signature and "number" for parameters.
[[nodiscard]] nlohmann::ordered_json bindings_json(const Bindings& bindings, const Signature& signature);
/// And back: names of the signature of the kind that it says, all others as numbers. Throws InputError, naming the
/// name, for anything else.
[[nodiscard]] Bindings bindings_from(const nlohmann::ordered_json& json, const Vocabulary& vocabulary,
                                     const Signature& signature);

/// The text of a witness file (docs/claim-format.md).
[[nodiscard]] std::string witness_text(const Witness& witness);
/// Reads it back, and has the instance class check the instance. Throws InputError, naming `file`, for anything that is
/// not a witness, or has unknown keys.
[[nodiscard]] Witness parse_witness(const std::string& text, const std::string& file);
/// The same from a file. Throws InputError also if it cannot be read or is larger than 64 MiB.
[[nodiscard]] Witness read_witness(const std::string& file);

}  // namespace delcert
