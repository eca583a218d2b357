#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace delcert::checker {

// Finitely generated abelian groups, Z^r + Z/d + Z/d' + … with 1 < d | d' | …, each in the one spelling that the format
// page gives: "0", or its summands joined by " + ", first Z or Z^r, then Z/d or (Z/d)^k by increasing d.

/// Whether the text is the spelling of a group. No number in it may have more than a thousand digits.
bool is_group(std::string_view text);

/// The spelling of the group with this free rank and these orders d | d' | ….
std::string group_text(std::size_t free_rank, const std::vector<std::string>& torsion);

}  // namespace delcert::checker
