// Witness files: what is accepted is written and read again as the same text.
#include "properties/attack/witness.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "support/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace delcert;
  try {
    const std::string text = witness_text(parse_witness(fuzz::text_of(data, size), "a.json"));
    fuzz::require(witness_text(parse_witness(text, "a.json")) == text, "a witness reads back");
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), "a.json");
  }
  return 0;
}
