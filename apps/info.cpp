#include "apps/commands.hpp"

namespace delcert {

void add_info(CLI::App&, Action&) {}

}  // namespace delcert
