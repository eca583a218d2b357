#include <fmt/format.h>

#include "apps/witness_file.hpp"
#include "apps/witness_item.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/witness_points.hpp"
#include "support/error.hpp"

namespace delcert {

Figure witness_figure(const std::string& path) {
  const Witness witness = witnesses_in(path).front();
  const std::vector<DrawnSet> sets = drawn_sets(witness);
  if (sets.empty()) throw InputError("there is nothing to draw in this witness: it is numbers");
  Figure figure = figure_of(sets);
  const Replay replay = replayed(witness);
  std::string verdict = fmt::format("the hypotheses are {}", name_of(replay.hypotheses));
  if (replay.conclusion) {
    const std::string ratio = ratio_text(replay.conclusion->ratio);
    verdict += fmt::format(", {} is {}{}", replay.conclusion->text, name_of(replay.conclusion->verdict),
                           ratio.empty() ? "" : ", ratio " + ratio);
  }
  figure.description = fmt::format("witness against {}, {}{}: {}; {}", witness.claim, witness.conclusion,
                                   witness.twin.empty() ? "" : ", twin " + witness.twin, verdict, figure.description);
  return figure;
}

}  // namespace delcert
