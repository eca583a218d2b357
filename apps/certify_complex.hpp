#pragma once

#include "apps/certification.hpp"

namespace delcert {

/// `delcert certify --complex FILE`: proposes a certificate of the complex in the file, has delcert-check verify it,
/// and gives it its name only then. Throws Rejection with what was found wrong, in the names of the file.
ExitStatus certify_complex(const CertifyCommand& options);

}  // namespace delcert
