#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace delcert::checker_tests {

/// Random mutations of a certificate, sealed anew, of which the checker may accept those only in which an oracle finds
/// nothing false.
struct MutationCampaign {
  std::string name;                                      // as docs/submanifolds.md has it
  std::string text;                                      // the certificate, which is accepted
  std::function<std::string(const std::string&)> fault;  // what the oracle finds false, or nothing
  int few = 0;                                           // so many, unless DELCERT_MUTATIONS says how many
  std::uint64_t seed = 0;
  /// Two of four mutations are of the bytes before this place only.
  std::size_t head = std::string::npos;
};

/// Makes the mutations, half of them of digits only. Expects that none is accepted that is false, that each status is
/// met, that none takes longer than some seconds, and that the oracle finds false most of what is rejected. The counts
/// of the first `few` are those of the table in docs/submanifolds.md; with DELCERT_MUTATIONS and DELCERT_RENEW in the
/// environment the row is written anew.
void run_campaign(const MutationCampaign& campaign);

}  // namespace delcert::checker_tests
