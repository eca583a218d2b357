#include "proofs/publication/zip_archive.hpp"

#include <zip.h>

#include <memory>
#include <set>
#include <stdexcept>

namespace delcert {

namespace {

// The first day that the format can state: midnight of 1 January 1980.
constexpr zip_uint16_t first_date = 0x21;
constexpr zip_uint16_t first_time = 0;
constexpr zip_uint32_t readable_by_all = 0100644U << 16U;

struct ZipError {
  ZipError() { zip_error_init(&error); }
  ~ZipError() { zip_error_fini(&error); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  [[noreturn]] void fail() { throw std::runtime_error(std::string("libzip: ") + zip_error_strerror(&error)); }
  zip_error_t error{};
};

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};

[[noreturn]] void fail(zip_t* archive) { throw std::runtime_error(std::string("libzip: ") + zip_strerror(archive)); }

std::string bytes_of_source(zip_source_t* source) {
  std::string bytes;
  if (zip_source_open(source) != 0) throw std::runtime_error("libzip: the archive cannot be read again");
  std::string buffer(1U << 16U, '\0');
  zip_int64_t count = 0;
  while ((count = zip_source_read(source, buffer.data(), buffer.size())) > 0)
    bytes.append(buffer, 0, static_cast<std::size_t>(count));
  zip_source_close(source);
  if (count < 0) throw std::runtime_error("libzip: the archive cannot be read again");
  return bytes;
}

}  // namespace

std::string zip_archive(const std::vector<ArchiveFile>& files) {
  std::set<std::string> names;
  for (const ArchiveFile& file : files) {
    if (!names.insert(file.name).second) throw std::invalid_argument("two files are called " + file.name);
  }
  ZipError error;
  zip_source_t* memory = zip_source_buffer_create(nullptr, 0, 0, &error.error);
  if (memory == nullptr) error.fail();
  // Kept, as closing the archive gives its own hold up.
  zip_source_keep(memory);
  const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> kept(memory, &zip_source_free);
  std::unique_ptr<zip_t, Discard> archive(zip_open_from_source(memory, ZIP_TRUNCATE, &error.error));
  if (!archive) {
    zip_source_free(memory);
    error.fail();
  }
  for (const ArchiveFile& file : files) {
    zip_source_t* source = zip_source_buffer(archive.get(), file.bytes.data(), file.bytes.size(), 0);
    if (source == nullptr) fail(archive.get());
    const zip_int64_t added = zip_file_add(archive.get(), file.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (added < 0) {
      zip_source_free(source);
      fail(archive.get());
    }
    const auto index = static_cast<zip_uint64_t>(added);
    if (zip_set_file_compression(archive.get(), index, ZIP_CM_STORE, 0) != 0 ||
        zip_file_set_dostime(archive.get(), index, first_time, first_date, 0) != 0 ||
        zip_file_set_external_attributes(archive.get(), index, 0, ZIP_OPSYS_UNIX, readable_by_all) != 0)
      fail(archive.get());
  }
  if (zip_close(archive.get()) != 0) fail(archive.get());
  (void)archive.release();
  return bytes_of_source(memory);
}

}  // namespace delcert
