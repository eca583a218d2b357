// A part of delcert-claims alone.

#include "apps/other_programs.hpp"

namespace delcert {

bool is_left_to_claims(std::string_view) { return false; }

}  // namespace delcert
