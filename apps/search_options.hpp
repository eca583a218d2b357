#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "apps/claim_options.hpp"
#include "properties/attack/witness.hpp"

namespace delcert {

/// What directed searches are told, those of `tighten` and of `power`.
struct SearchOptions {
  /// With so many evaluations unless the user says otherwise.
  explicit SearchOptions(std::uint64_t default_evaluations) : evaluations(default_evaluations) {}

  ClaimOptions claims;
  std::uint64_t evaluations;  ///< for each target, before it is divided by what an instance costs
  std::uint64_t seed = 0;
  unsigned threads = 0;   ///< 0: as many as the processor has
  std::string witnesses;  ///< a folder; none if empty
  bool json = false;
};

/// Adds them. `target` is what has `evaluations` instances, such as "conclusion", `of_witnesses` what is written.
/// Returns the option for JSON, which others may exclude.
CLI::Option* add_search_options(CLI::App& command, SearchOptions& options, const std::string& target,
                                const std::string& of_witnesses);

/// How many instances of a shape are tried: fewer of a class whose instances are costly, but at least one.
[[nodiscard]] std::uint64_t evaluations_of(const SearchOptions& options, const Claim& claim, const Shape& shape);

/// Throws InputError unless 1 ≤ evaluations ≤ 10¹².
void require_evaluations(const SearchOptions& options);

[[nodiscard]] unsigned threads_of(const SearchOptions& options);

/// Writes a witness into the folder of witnesses, which is made if it is missing. Throws InputError where it cannot be.
void write_witness(const SearchOptions& options, const std::string& name, const Witness& witness);

}  // namespace delcert
