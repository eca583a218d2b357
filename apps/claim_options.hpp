#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// Which claims and which shapes a command is about.
struct ClaimOptions {
  std::vector<std::string> names;
  bool all = false;
  std::vector<std::string> shapes;
};

/// CLAIM…, --all, --shape.
void add_claim_options(CLI::App& command, ClaimOptions& options);

/// The claims asked for, each once. Throws InputError for a name that no claim has, for two claims of the same name,
/// and if nothing was asked for.
[[nodiscard]] std::vector<Claim> claims_of(const ClaimOptions& options);

/// The same, for commands about instances: `--all` leaves out the files of steps only, and one that is named is an
/// InputError.
[[nodiscard]] std::vector<Claim> claims_about_instances(const ClaimOptions& options);

/// The shapes asked for, each once, else those of the claim's class. Throws InputError for text that is no shape, "k,m"
/// or "m", and for one that the class does not have; among all claims such a one is left out instead.
[[nodiscard]] std::vector<Shape> shapes_of(const ClaimOptions& options, const Claim& claim);

}  // namespace delcert
