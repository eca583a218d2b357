#include "proofs/certificate/file_text.hpp"

#include <zstd.h>

#include <fstream>
#include <memory>
#include <string_view>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::string_view zstd_magic("\x28\xB5\x2F\xFD", 4);

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string() + ": cannot be opened");
  std::string bytes;
  std::error_code unknown;  // of what is no plain file
  if (const std::uintmax_t size = std::filesystem::file_size(path, unknown); !unknown) bytes.reserve(size);
  std::string chunk(std::size_t{1} << 16U, '\0');
  do {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    bytes.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (in.bad()) throw InputError(path.string() + ": cannot be read");
  return bytes;
}

std::string decompressed(const std::string& bytes, const std::filesystem::path& path) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  std::string result;
  std::string chunk(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t left = 1;
  while (left != 0) {
    const std::size_t before = in.pos;
    ZSTD_outBuffer out{chunk.data(), chunk.size(), 0};
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left) != 0) throw InputError(path.string() + ": zstd: " + ZSTD_getErrorName(left));
    result.append(chunk, 0, out.pos);
    if (left != 0 && out.pos == 0 && in.pos == before)
      throw InputError(path.string() + ": zstd: the file ends too early");
  }
  return result;
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::string bytes = file_bytes(path);
  return bytes.starts_with(zstd_magic) ? decompressed(bytes, path) : bytes;
}

}  // namespace delcert
