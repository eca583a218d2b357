#pragma once

#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"

namespace delcert {

/// The names that each instance class binds.
[[nodiscard]] const Signatures& all_signatures();

/// All files of claims of the library by name, also those of steps only; they are read once. Throws InputError for a
/// file that is not a file of claims.
[[nodiscard]] const std::vector<Claim>& builtin_files();
/// Those of them that are about instances.
[[nodiscard]] const std::vector<Claim>& builtin_claim_list();

/// A claim by its name in the library, or by a file's name. Throws InputError, with a suggestion, if there is none.
[[nodiscard]] Claim find_claim(const std::string& name_or_file);

/// Throws InputError, saying why, unless the bindings have the names of the claim's class, a number for each parameter
/// of the claim, within its range, and nothing else. That they are an instance of the class is another question
/// (`InstanceClass::require`).
void require_names_of(const Claim& claim, const Bindings& bindings);

}  // namespace delcert
