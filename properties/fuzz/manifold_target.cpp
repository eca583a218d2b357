// Manifold files.
#include "kernel/manifold/manifold_file.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "support/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace delcert;
  try {
    const ManifoldDescription manifold = parse_manifold(fuzz::text_of(data, size), "a.toml");
    fuzz::require(manifold.gram.size() == static_cast<std::size_t>(manifold.dimension.value),
                  "a manifold has a Gram matrix of its dimension");
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), "a.toml");
  }
  return 0;
}
