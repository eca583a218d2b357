#include "proofs/certificate/byte_sink.hpp"

#include <zstd.h>

#include <stdexcept>
#include <vector>

#include "proofs/certificate/sha256.hpp"
#include "support/atomic_file.hpp"

namespace delcert {

namespace {

constexpr int compression_level = 3;

}  // namespace

struct ByteSink::State {
  struct FreeCompressor {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  };

  explicit State(const std::filesystem::path& path) : file(path) {
    if (path.extension() == ".zst") {
      compressor.reset(ZSTD_createCCtx());
      if (!compressor) throw std::bad_alloc();
      check(ZSTD_CCtx_setParameter(compressor.get(), ZSTD_c_compressionLevel, compression_level));
      check(ZSTD_CCtx_setParameter(compressor.get(), ZSTD_c_checksumFlag, 1));
      output.resize(ZSTD_CStreamOutSize());
    }
  }

  static std::size_t check(std::size_t result) {
    if (ZSTD_isError(result) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(result));
    return result;
  }

  void compress(std::string_view bytes, ZSTD_EndDirective directive) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    std::size_t left = 0;
    do {
      ZSTD_outBuffer out{output.data(), output.size(), 0};
      left = check(ZSTD_compressStream2(compressor.get(), &out, &in, directive));
      file.write({output.data(), out.pos});
    } while (directive == ZSTD_e_end ? left != 0 : in.pos < in.size);
  }

  AtomicFile file;
  Sha256 hash;
  std::unique_ptr<ZSTD_CCtx, FreeCompressor> compressor;
  std::vector<char> output;
};

ByteSink::ByteSink(const std::filesystem::path& path) : state_(std::make_unique<State>(path)) {}
ByteSink::~ByteSink() = default;

void ByteSink::write(std::string_view bytes) {
  state_->hash.update(bytes);
  if (state_->compressor) {
    state_->compress(bytes, ZSTD_e_continue);
  } else {
    state_->file.write(bytes);
  }
}

std::string ByteSink::digest() const { return state_->hash.digest(); }

void ByteSink::commit() {
  if (state_->compressor) state_->compress({}, ZSTD_e_end);
  state_->file.commit();
}

}  // namespace delcert
