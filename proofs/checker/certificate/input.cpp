#include "proofs/checker/certificate/input.hpp"

#include <nettle/sha2.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>

#include "proofs/checker/report/report.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t largest_document = std::size_t{1} << 32;

[[noreturn]] void malformed(const std::string& what) { throw Malformed("form.bytes", what); }

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string decompressed(std::string bytes) {
  if (!std::string_view(bytes).starts_with("\x28\xb5\x2f\xfd")) return bytes;
  // No certificate compresses 50 times: labels and coordinates differ from line to line.
  const std::size_t limit = std::min(largest_document, (std::size_t{1} << 16) + 50 * bytes.size());
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
  std::string text;
  for (std::size_t rest = 1; rest != 0;) {
    const std::size_t used = text.size();
    if (used > limit) malformed("the compressed data grows beyond " + std::to_string(limit) + " bytes");
    text.resize(std::min(used + std::clamp(used, std::size_t{1} << 16, std::size_t{1} << 26), limit + 1));
    ZSTD_outBuffer output{text.data(), text.size(), used};
    rest = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(rest) != 0) malformed(std::string("zstd: ") + ZSTD_getErrorName(rest));
    const bool starved = input.pos == input.size && output.pos < output.size;
    text.resize(output.pos);
    if (rest != 0 && starved) malformed("zstd: the frame is cut short");
  }
  if (input.pos != input.size) malformed("bytes after the zstd frame");
  return text;
}

std::string read_bytes(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw Unreadable(path + ": cannot be read");
  std::string bytes;
  std::error_code unknown;  // the size of a pipe
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (!unknown && size <= largest_document) bytes.reserve(static_cast<std::size_t>(size));
  std::array<char, 1 << 16> block;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.append(block.data(), got);
    if (bytes.size() > largest_document)
      malformed("the file has more than " + std::to_string(largest_document) + " bytes");
  }
  if (std::ferror(file.get()) != 0) throw Unreadable(path + ": cannot be read");
  return bytes;
}

namespace {

void update(sha256_ctx& context, std::string_view text) {
  sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
}

std::string digest_of(sha256_ctx context) {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string hexadecimal;
  for (const std::uint8_t byte : digest) {
    hexadecimal += "0123456789abcdef"[byte >> 4];
    hexadecimal += "0123456789abcdef"[byte & 15];
  }
  return hexadecimal;
}

}  // namespace

std::string sha256(std::string_view text) {
  DigestOfBeginning none;
  return sha256(text, 0, none);
}

std::string sha256(std::string_view text, std::size_t length, DigestOfBeginning& beginning) {
  sha256_ctx context;
  sha256_init(&context);
  update(context, text.substr(0, length));
  beginning = {length, digest_of(context)};
  update(context, text.substr(length));
  return digest_of(context);
}

}  // namespace delcert::checker
