// Certificates as delcert-check reads them: as they are, and under a seal that fits, so that the content counts.
#include <cfenv>

#include "proofs/checker/input.hpp"
#include "proofs/checker/run.hpp"
#include "properties/fuzz/fuzz_target.hpp"

namespace {

using namespace delcert;

void read(const std::string& bytes) {
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
  const std::string bytes = fuzz::text_of(data, size);
  read(bytes);
  const std::string key = ",\"sha256\":\"";
  const std::size_t seal = bytes.rfind(key);
  if (seal != std::string::npos) {
    const std::string content = bytes.substr(0, seal);
    read(content + key + checker::sha256(content) + "\"}\n");
  }
  std::fesetround(rounding);
  return 0;
}
