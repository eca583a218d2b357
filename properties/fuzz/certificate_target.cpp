// Certificates as `delcert info` reads them, which takes files only.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "proofs/certificate/reader.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "support/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace delcert;
  static const std::string path =
      std::filesystem::temp_directory_path() / ("delcert-fuzz-" + std::to_string(getpid()) + ".json");
  {
    std::ofstream stream(path, std::ios::binary);
    stream << fuzz::text_of(data, size);
  }
  try {
    (void)read_certificate(path);
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), path);
  }
  std::filesystem::remove(path);
  return 0;
}
