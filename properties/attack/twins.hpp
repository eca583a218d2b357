#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "properties/attack/witness.hpp"
#include "support/progress.hpp"

namespace delcert {

// A twin of a claim is what has to be refuted if the claim is tested at all: a conclusion with its constant moved past
// what holds, or the claim without one of its hypotheses. Its name is that of the claim, a slash, and its own.

/// The twins of a claim: of its conclusions, then of its hypotheses. What gives a reason for having none has none.
[[nodiscard]] std::vector<Claim> twins_of(const Claim& claim);

/// The conclusions that have neither a twin nor a reason.
[[nodiscard]] std::vector<std::string> conclusions_without_twin(const Claim& claim);

/// The part of the name before and after the slash; the whole and "" for a claim that is no twin.
[[nodiscard]] std::string original_name(const Claim& claim);
[[nodiscard]] std::string twin_name(const Claim& claim);

/// A witness that says that a conclusion of a claim or twin is refuted by an instance.
[[nodiscard]] Witness witness_of(const Claim& claim, std::size_t conclusion, Bindings bindings);

/// "claim.conclusion.json", "claim.twin.json" for a twin.
[[nodiscard]] std::string witness_file_name(const Claim& claim, const std::string& conclusion);

/// Throws InputError unless the witness can speak of this claim or twin: its class, its conclusion, its parameters.
void require_witness_of(const Claim& claim, const Witness& witness);

/// The text of a claim or twin, under the name of the claim, that witnesses carry.
[[nodiscard]] std::string statement_of(const Claim& claim);

/// The claim or twin whose text the witness carries. Throws InputError if this is no claim, or the witness cannot speak
/// of it. Precondition: there is a text.
[[nodiscard]] Claim claim_in(const Witness& witness);

/// The claim or twin that a witness speaks of, as it is now; `claim`, if it is not empty, is the claim to take instead
/// of the one that the witness names. Throws InputError if there is none, or the witness cannot speak of it.
[[nodiscard]] Claim claim_of(const Witness& witness, const std::string& claim = "");

/// Refuted: all hypotheses hold and the conclusion does not, decided exactly; proved: a hypothesis does not hold, or
/// the conclusion does. Precondition: the claim is the one that the witness speaks of.
[[nodiscard]] Verdict decide_witness(const Claim& claim, const Witness& witness);

/// The instance made simpler as long as it refutes the conclusion. `progress` is called for each that is tried.
[[nodiscard]] Witness shrunk_witness(const Claim& claim, std::size_t conclusion, const Bindings& bindings,
                                     const Progress& progress);

/// How hard to try.
struct Effort {
  std::uint64_t samples = 1000;      ///< at random in each shape; less where an instance is costly
  std::uint64_t evaluations = 4000;  ///< directed, for each conclusion and shape; less where an instance is costly
  std::uint64_t seed = 0;
};

/// An instance that refutes the claim, made simpler: found at random, a few samples in each shape in turn, then by
/// directed search; for conclusions that are bare truths on paths along which a bounded number, such as a distortion,
/// grows (`power_of`): the claim is refuted where one fails at the bound already. Nothing if none was found. The same
/// for the same seed.
[[nodiscard]] std::optional<Witness> refute(const Claim& claim, const std::vector<Shape>& shapes, const Effort& effort,
                                            const Progress& progress);

/// Whether a witness file in the folder refutes the twin. Throws InputError for a file of the twin's name that is no
/// witness, speaks of something else, or does not refute the twin: it was written for another statement.
[[nodiscard]] bool is_refuted_by_stored_witness(const Claim& twin, const std::filesystem::path& folder);

}  // namespace delcert
