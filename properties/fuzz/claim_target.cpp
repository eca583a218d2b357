// Claims: what is accepted is printed, read again as the same formula and put into LaTeX.
#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/latex.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"

namespace {

using namespace delcert;

const Signatures& signatures() {
  static const Signatures result = [] {
    Signatures made;
    for (const InstanceClass* each : instance_classes()) made[each->name()] = each->signature();
    return made;
  }();
  return result;
}

void read_again(const Statement& statement) {
  const auto again = parse_formula(formula_text(*statement.formula));
  fuzz::require(is_same_formula(*again, *statement.formula), "what is printed is read as the same formula");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Claim claim = parse_claim(fuzz::text_of(data, size), "a.toml", full_vocabulary(), signatures());
    for (const Hypothesis& hypothesis : claim.hypotheses) read_again(hypothesis);
    for (const Conclusion& conclusion : claim.conclusions) {
      read_again(conclusion);
      if (conclusion.twin) read_again(*conclusion.twin);
    }
    for (const Step& step : claim.steps) {
      read_again(step.claim);
      for (const Statement& hypothesis : step.hypotheses) read_again(hypothesis);
      for (const Statement& abbreviation : step.abbreviations) read_again(abbreviation);
      for (const auto& [name, range] : step.parameters) {
        fuzz::require(step_range_text(parse_step_range(step_range_text(range))) == step_range_text(range),
                      "what is printed is read as the same range");
      }
    }
    fuzz::require(!latex_of(claim).empty(), "a claim has LaTeX");
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), "a.toml:");
  }
  return 0;
}
