// Receipts as `delcert-check --merge` reads them: as they are, and under a seal that fits, so that the content counts.
#include "proofs/checker/input.hpp"
#include "proofs/checker/merge.hpp"
#include "properties/fuzz/fuzz_target.hpp"

namespace {

using namespace delcert;

void read(const std::string& bytes) {
  try {
    const checker::Receipt receipt = checker::receipt_of(bytes);
    fuzz::require(checker::receipt_text(receipt) == bytes, "a receipt is written as it was read");
    const checker::Outcome outcome = checker::merged({{"receipt", receipt}}, receipt.checker, "");
    const bool is_whole = receipt.outcome.share.is_whole();
    fuzz::require(outcome.status != 0 || is_whole, "a part is no whole");
    (void)checker::as_text(outcome);
  } catch (const checker::Malformed&) {
  } catch (const checker::Refused&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::text_of(data, size);
  read(bytes);
  const std::string key = ",\"sha256\":\"";
  const std::size_t seal = bytes.rfind(key);
  if (seal != std::string::npos) {
    const std::string content = bytes.substr(0, seal);
    read(content + key + checker::sha256(content) + "\"}\n");
  }
  return 0;
}
