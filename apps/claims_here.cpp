// A part of delcert-claims and not of delcert.

#include "apps/claim_commands.hpp"

namespace delcert {

bool is_left_to_claims(std::string_view) { return false; }

}  // namespace delcert
