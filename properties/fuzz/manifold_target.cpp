// Manifold files.
#include "kernel/manifold/any_manifold.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "support/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace delcert;
  try {
    const AnyManifold found = parse_any_manifold(fuzz::text_of(data, size), "a.toml");
    if (const auto* flat = std::get_if<ManifoldDescription>(&found)) {
      fuzz::require(flat->gram.size() == static_cast<std::size_t>(flat->dimension.value),
                    "a flat manifold has a Gram matrix of its dimension");
    }
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), "a.toml");
  }
  return 0;
}
