// A part of delcert-publish: pages and figures of witnesses rest on claims.

#include "apps/other_programs.hpp"
#include "apps/witness_file.hpp"

namespace delcert {

std::vector<PageItem> witness_items(const std::string&, const ShownFile&) { hand_over_to(claims_program); }
Figure witness_figure(const std::string&) { hand_over_to(claims_program); }

}  // namespace delcert
