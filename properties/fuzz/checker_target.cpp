// Certificates as delcert-check reads them: as they are, and under a seal that fits, so that the content counts.
#include <cfenv>

#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/run.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/sealed.hpp"

namespace {

using namespace delcert;

void read_certificate(const std::string& bytes) {
  try {
    const std::string text = checker::decompressed(bytes);
    const checker::Certificate certificate(text);
    fuzz::require(certificate.n > 0, "a certificate has points");
  } catch (const checker::Malformed&) {
  } catch (const checker::Undecided&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int rounding = std::fegetround();
  std::fesetround(FE_UPWARD);
  fuzz::read_with_both_seals(fuzz::text_of(data, size), read_certificate);
  std::fesetround(rounding);
  return 0;
}
