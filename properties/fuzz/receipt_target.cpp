// Receipts as `delcert-check --merge` reads them: as they are, and under a seal that fits, so that the content counts.
#include "proofs/checker/program/merge.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/sealed.hpp"

namespace {

using namespace delcert;

void read_receipt(const std::string& bytes) {
  try {
    const checker::Receipt receipt = checker::receipt_of(bytes);
    fuzz::require(checker::receipt_text(receipt) == bytes, "a receipt is written as it was read");
    const checker::Outcome outcome = checker::merged({{"receipt", receipt}}, receipt.checker, "");
    const bool is_whole = receipt.outcome.share.is_whole();
    fuzz::require(outcome.status != 0 || is_whole, "a part is not the whole");
    (void)checker::as_text(outcome);
  } catch (const checker::Malformed&) {
  } catch (const checker::Refused&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_with_both_seals(fuzz::text_of(data, size), read_receipt);
  return 0;
}
