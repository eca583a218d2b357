// A claim given as text, attacked on random triangles: it is false, and the triangle that refutes it is made simple.

#include <iostream>

#include "properties/attack/claim_library.hpp"
#include "properties/attack/tally.hpp"
#include "properties/attack/twins.hpp"
#include "support/progress.hpp"

namespace {

constexpr const char* text = R"toml(
name = "circumradius-below-edge"
instance = "simplex"

[[show]]
name = "radius"
claim = "circumradius(s) <= longest_edge(s)"
)toml";

}  // namespace

int main() {
  using namespace delcert;
  const Claim claim = parse_claim(text, "claim.toml", full_vocabulary(), all_signatures());
  const Shape triangle{2, 2};
  constexpr std::uint64_t seed = 1;
  const Tally tally = attack_block(claim, triangle, seed, 0, 100);
  const ConclusionTally& radius = tally.conclusions.front();
  std::cout << tally.samples << " triangles, undecided: " << tally.undecided()
            << (radius.violated > 0 ? ", refuted\n" : ", not refuted\n");
  if (radius.violated == 0) return 0;
  const auto instance = sample_instance(claim, triangle, seed, radius.first_violation);
  const Witness witness = shrunk_witness(claim, 0, instance.value().bindings, no_progress());
  std::cout << witness_text(witness) << "decided anew: " << name_of(decide_witness(claim, witness)) << '\n';
}
