#pragma once

#include <string>
#include <vector>

#include "proofs/errata/erratum.hpp"

namespace delcert {

/// The findings as the page docs/errata.md: which text was read, how many there are of each kind, a section for each,
/// the severest kind first and those of one kind in their order, a table of what was read and holds.
[[nodiscard]] std::string errata_markdown(const std::vector<Erratum>& errata);

/// The same as a JSON document {"text": …, "errata": […]}: which text was read, and the findings with the keys of the
/// files, `lines` as text, and all keys always there.
[[nodiscard]] std::string errata_json(const std::vector<Erratum>& errata);

/// "17-23, 40".
[[nodiscard]] std::string lines_text(const std::vector<LineRange>& lines);

}  // namespace delcert
